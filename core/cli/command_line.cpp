#include "core/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/cli/help_formatter.h"

namespace rocinante::cli {

Option Option::valueName(const std::string& word) const {
  return Option(*option_->type_name(word));
}

Option Option::valueText(const std::string& text) const {
  return Option(*option_->option_text(text));
}

Option Option::showDefault() const { return Option(*option_->capture_default_str()); }

Option Option::description(const std::string& text) const {
  return Option(*option_->description(text));
}

Option Option::group(const std::string& heading) const { return Option(*option_->group(heading)); }

Option Option::showRequired() const { return valueName(kRequired); }

Option Option::required() const { return Option(*option_->required()); }

Option Option::needs(Option other) const { return Option(*option_->needs(other.option_)); }

Option Option::needs(const std::string& name) const { return Option(*option_->needs(name)); }

Option Option::excludes(Option other) const { return Option(*option_->excludes(other.option_)); }

Option Option::excludes(const std::string& name) const { return Option(*option_->excludes(name)); }

Option Option::oneEach() const { return Option(*option_->allow_extra_args(false)); }

Option Option::separatedBy(char sign) const { return Option(*option_->delimiter(sign)); }

Option Option::bareMeans(const std::string& text) const {
  return Option(*option_->expected(0, 1)->default_str(text));
}

Option Option::mayBeBare() const {
  return Option(*option_->expected(0, 1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

Option Option::oneOf(std::vector<std::string> values) const {
  return Option(*option_->check(CLI::IsMember(std::move(values))));
}

Option Option::oneOf(std::initializer_list<int> values) const {
  return Option(*option_->check(CLI::IsMember(std::vector<int>(values))));
}

template <class T>
Option Option::within(T least, T most) const {
  return Option(*option_->check(CLI::Range(least, most)));
}
template Option Option::within(int, int) const;
template Option Option::within(double, double) const;

Option Option::positive() const { return Option(*option_->check(CLI::PositiveNumber)); }

Option Option::each(const std::function<void(const std::string& value)>& taken) const {
  return Option(*option_->each(taken));
}

bool Option::given() const { return option_->count() > 0; }

template <class T>
Option CommandLine::addOption(const std::string& names, T& value, const std::string& does) const {
  return Option(*app_->add_option(names, value, does));
}
template Option CommandLine::addOption(const std::string&, std::string&, const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::filesystem::path&,
                                       const std::string&) const;
template Option CommandLine::addOption(const std::string&, int&, const std::string&) const;
template Option CommandLine::addOption(const std::string&, unsigned&, const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::uint64_t&,
                                       const std::string&) const;
template Option CommandLine::addOption(const std::string&, double&, const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::optional<std::uint64_t>&,
                                       const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::optional<std::string>&,
                                       const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::optional<double>&,
                                       const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::vector<std::string>&,
                                       const std::string&) const;
template Option CommandLine::addOption(const std::string&, std::vector<std::filesystem::path>&,
                                       const std::string&) const;

Option CommandLine::addOption(const std::string& names, const std::string& does) const {
  return Option(*app_->add_option(names, does));
}

Option CommandLine::addParsed(const std::string& names,
                              std::function<Status(const std::string& text)> read,
                              const std::string& does) const {
  const auto read_all = [read = std::move(read)](const std::vector<std::string>& given) {
    for (const std::string& text : given) {
      const Status taken = read(text);
      if (!taken) throw CLI::ValidationError(taken.error().where, taken.error().what);
    }
  };
  return Option(*app_->add_option_function<std::vector<std::string>>(names, read_all, does));
}

Option CommandLine::addFlag(const std::string& names, bool& value, const std::string& does) const {
  return Option(*app_->add_flag(names, value, does));
}

Option CommandLine::addFlag(const std::string& names, std::vector<std::string>& values,
                            const std::string& does) const {
  return Option(*app_->add_flag(names, values, does));
}

Option CommandLine::option(const std::string& name) const {
  return Option(*app_->get_option(name));
}

CommandLine CommandLine::addSubcommand(const std::string& name, const std::string& does) const {
  return CommandLine(*app_->add_subcommand(name, does));
}

void CommandLine::requireSubcommand() const { app_->require_subcommand(1); }

CommandLine CommandLine::addOneOf(const std::string& name, const std::string& heading) const {
  CLI::App* const options = app_->add_option_group(name, heading);
  options->require_option(1);
  return CommandLine(*options);
}

bool CommandLine::isChosen() const { return app_->parsed(); }

Program::Program(const std::string& does, const std::string& name)
    : CommandLine(*new CLI::App(does, name)) {}

Program::~Program() { delete app_; }

}  // namespace rocinante::cli
