#include "core/cli/help_formatter.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace rocinante::cli {
namespace {

constexpr const char* kExitCodes =
    "\nExit codes: 0 done, same or compatible; 1 the answer is no, or something was not kept;\n"
    "2 could not run, or nothing was judged.";

/// What CLI11 puts behind the word for a value: ":POSITIVE", ":INT in [0 - 64]", ":{text,json}".
std::string_view checkOf(std::string_view type) {
  const std::size_t colon = type.find(':');
  return colon == type.npos ? std::string_view() : type.substr(colon + 1);
}

bool isChoice(std::string_view type) { return checkOf(type).starts_with('{'); }

std::string valueWord(std::string_view type) {
  if (isChoice(type)) {
    std::string choices(checkOf(type));
    choices = choices.substr(1, choices.find('}') - 1);
    return CLI::detail::find_and_replace(choices, ",", "|");
  }
  const std::string_view word = type.substr(0, type.find(':'));
  if (word == "INT" || word == "UINT") return "N";
  return word == "FLOAT" ? "X" : std::string(word);
}

class HelpFormatter final : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(34); }

  std::string make_usage(const CLI::App* app, std::string name) const override {
    std::string usage = CLI::Formatter::make_usage(app, std::move(name));
    usage.pop_back();  // its line feed
    const auto is_needed = [](const CLI::Option* option) {
      return option->nonpositional() && option->get_required();
    };
    for (const CLI::Option* option : app->get_options(is_needed)) {
      const bool is_short = !option->get_snames().empty();
      usage +=
          is_short ? " -" + option->get_snames().front() : " --" + option->get_lnames().front();
      usage += " " + valueWord(option->get_type_name());
    }
    return usage + "\n";
  }

  /// A group of options of which so many are to be given: a section with its description above.
#if CLI11_VERSION_MAJOR > 2 || CLI11_VERSION_MINOR >= 5
  std::string make_expanded(const CLI::App* app, CLI::AppFormatMode mode) const override {
    return app->get_name().empty() ? sectionOf(app) : CLI::Formatter::make_expanded(app, mode);
  }
#else
  std::string make_expanded(const CLI::App* app) const override {
    return app->get_name().empty() ? sectionOf(app) : CLI::Formatter::make_expanded(app);
  }
#endif

  std::string make_option_opts(const CLI::Option* option) const override {
    if (!option->get_option_text().empty()) return " " + option->get_option_text();
    std::string text;
    if (option->get_type_size() != 0 && option->nonpositional()) {
      text = " " + valueWord(option->get_type_name());
      if (!option->get_default_str().empty() && !isChoice(option->get_type_name())) {
        text += "=" + option->get_default_str();
      }
    }
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
    return text;
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = option->get_description();
    const bool shows_choice =
        option->get_option_text().empty() && isChoice(option->get_type_name());
    if (shows_choice && !option->get_default_str().empty()) {
      text += (text.empty() ? "default " : "; default ") + option->get_default_str();
    }
    return text;
  }

 private:
  std::string sectionOf(const CLI::App* group) const {
    const CLI::Option* const help = group->get_help_ptr();
    return make_group(group->get_description(), false,
                      group->get_options([help](const CLI::Option* each) { return each != help; }));
  }
};

struct ValueWord {
  std::string_view option, word;
};

/// What an option takes whose program names no word for it: one word for one thing, everywhere.
constexpr ValueWord kValueWords[] = {
    {"after", "TIME"},      {"at", "TIME"},
    {"at-file", "FILE"},    {"baseline", "FILE"},
    {"camera", "NAME"},     {"case", "NAME"},
    {"cell", "CELL"},       {"depth", "FILE"},
    {"detail", "LEVEL"},    {"device", "NAME"},
    {"difference", "FILE"}, {"duration", "TIME"},
    {"events", "PATTERN"},  {"every", "TIME"},
    {"fps", "N"},           {"frames", "DIR"},
    {"from", "TIME"},       {"hide", "PATH"},
    {"identity", "FILE"},   {"joint", "NAME=VALUE"},
    {"joints", "VALUES"},   {"json", "FILE"},
    {"junit", "FILE"},      {"layer", "NAME"},
    {"live", "EP"},         {"log", "LOG"},
    {"mask", "PATH"},       {"not-tag", "TAG"},
    {"only", "PATTERN"},    {"other-cell", "CELL"},
    {"other-log", "LOG"},   {"other-render", "PROGRAM"},
    {"output", "FILE"},     {"pose", "VALUES"},
    {"report", "DIR"},      {"rule-pages", "URL"},
    {"script", "FILE"},     {"search", "DIR"},
    {"sheet", "FILE"},      {"show", "PATH"},
    {"size", "WxH"},        {"slack", "TIME"},
    {"step", "TIME"},       {"style", "KEY[=VALUE]"},
    {"tag", "TAG"},         {"tier", "TIER"},
    {"tolerance", "TIER"},  {"until", "TIME"},
    {"video", "FILE"},
};

void nameValues(CLI::App& app) {
  for (CLI::Option* option : app.get_options({})) {
    // CLI11's word for any text.
    if (option->get_type_name() != "TEXT" || !option->nonpositional()) continue;
    for (const ValueWord& each : kValueWords) {
      if (option->check_lname(std::string(each.option))) {
        option->type_name(std::string(each.word));
      }
    }
  }
}

/// The lines of `examples` that show the subcommand `name`.
std::string examplesOf(std::string_view examples, const std::string& name) {
  std::string chosen;
  while (!examples.empty()) {
    const std::size_t end = std::min(examples.find('\n'), examples.size() - 1);
    const std::string_view line = examples.substr(0, end + 1);
    examples.remove_prefix(end + 1);
    // "  rocinante log NAME ..."
    const std::size_t program = line.find(' ', line.find("rocinante ") + 10);
    if (line.substr(std::min(program, line.size())).starts_with(" " + name + " ")) chosen += line;
  }
  return chosen;
}

}  // namespace

void setHelp(CLI::App& app, std::string_view examples) {
  const auto formatter = std::make_shared<HelpFormatter>();
  app.formatter(formatter);
  app.footer("\nExamples:\n" + std::string(examples) + kExitCodes);
  nameValues(app);
  for (CLI::App* subcommand : app.get_subcommands({})) {
    if (subcommand->get_name().empty()) continue;  // a group of options
    subcommand->formatter(formatter);
    nameValues(*subcommand);
    const std::string shown = examplesOf(examples, subcommand->get_name());
    subcommand->footer((shown.empty() ? "" : "\nExamples:\n" + shown) + kExitCodes);
  }
}

}  // namespace rocinante::cli
