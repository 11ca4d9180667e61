#include "core/cli/help_formatter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante::cli {
namespace {

constexpr const char* kExitCodes =
    "\nExit codes: 0 done, same or compatible; 1 the answer is no, or something was not kept;\n"
    "2 could not run, or nothing was judged.";

/// The suffix that CLI11 adds to the word for a value: ":POSITIVE", ":INT in [0 - 64]",
/// ":{text,json}".
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

/// CLI11's own layout differs between versions (2.5 wraps, indents and shouts), so the whole layout
/// is ours: the text, and the shell completion made from it, is the same with every version.
class HelpFormatter final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    std::string text = app->get_description();
    if (!text.empty()) text += "\n";
    text += usageOf(app, name);
    const auto positionals = app->get_options([](const CLI::Option* option) {
      return !option->get_group().empty() && option->get_positional();
    });
    if (!positionals.empty()) text += sectionOf("Positionals", positionals);
    const std::vector<std::string> groups = app->get_groups();
    for (const std::string& group : groups) {
      const auto options = app->get_options([&group](const CLI::Option* option) {
        return option->get_group() == group && option->nonpositional();
      });
      if (group.empty() || options.empty()) continue;
      text += sectionOf(group, options);
      if (group != groups.back()) text += "\n";
    }
    text += subcommandsOf(app) + "\n";
    if (!app->get_footer().empty()) text += app->get_footer() + "\n";
    return text;
  }

 private:
  using Options = std::vector<const CLI::Option*>;

  static std::string usageOf(const CLI::App* app, const std::string& name) {
    std::string usage = name.empty() ? "Usage:" : "Usage: " + name;
    const auto is_named = [](const CLI::Option* option) { return option->nonpositional(); };
    if (!app->get_options(is_named).empty()) usage += " [OPTIONS]";
    for (const CLI::Option* option :
         app->get_options([](const CLI::Option* each) { return each->get_positional(); })) {
      std::string word = option->get_name(true, false);
      if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) word += "...";
      const bool is_required = option->get_required() || option->get_type_name() == kRequired;
      usage += is_required ? " " + word : " [" + word + "]";
    }
    const auto has_name = [](const CLI::App* each) {
      return !each->get_disabled() && !each->get_name().empty();
    };
    if (!app->get_subcommands(has_name).empty()) {
      usage += app->get_require_subcommand_min() == 0 ? " [SUBCOMMAND]" : " SUBCOMMAND";
    }
    for (const CLI::Option* option : app->get_options(is_named)) {
      if (!option->get_required()) continue;
      usage += option->get_snames().empty() ? " --" + option->get_lnames().front()
                                            : " -" + option->get_snames().front();
      usage += " " + valueWord(option->get_type_name());
    }
    return usage + "\n";
  }

  /// The name on the left, its lines to the right of it.
  static std::string row(const std::string& name, const std::string& lines) {
    constexpr std::size_t kColumn = 34;
    std::string text = "  " + name;
    const bool fits = text.size() < kColumn;
    if (fits) text.resize(kColumn, ' ');
    if (!lines.empty()) {
      const std::string next = "\n" + std::string(kColumn, ' ');
      text += (fits ? "" : next) + CLI::detail::find_and_replace(lines, "\n", next);
    }
    return text + "\n";
  }

  static std::string sectionOf(std::string title, const Options& options) {
    if (title == "OPTIONS") title = "Options";  // since 2.5
    std::string text = "\n" + title + ":\n";
    for (const CLI::Option* option : options) {
      const bool positional = !option->nonpositional();
      text += row(option->get_name(positional, !positional) + valueOf(option), linesOf(option));
    }
    return text;
  }

  /// Option groups with a required number of options, each below its description; then the
  /// subcommands.
  static std::string subcommandsOf(const CLI::App* app) {
    std::string groups, commands;
    for (const CLI::App* each : app->get_subcommands({})) {
      if (each->get_group().empty()) continue;
      if (!each->get_name().empty()) {
        commands += row(each->get_display_name(true), each->get_description());
        continue;
      }
      const CLI::Option* const help = each->get_help_ptr();
      groups += sectionOf(
          each->get_description(),
          each->get_options([help](const CLI::Option* option) { return option != help; }));
    }
    return groups + (commands.empty() ? "" : "\nSubcommands:\n" + commands);
  }

  static std::string valueOf(const CLI::Option* option) {
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

  static std::string linesOf(const CLI::Option* option) {
    std::string text = option->get_description();
    const bool shows_choice =
        option->get_option_text().empty() && isChoice(option->get_type_name());
    if (shows_choice && !option->get_default_str().empty()) {
      text += (text.empty() ? "default " : "; default ") + option->get_default_str();
    }
    return text;
  }
};

struct ValueWord {
  std::string_view option, word;
};

/// Words for the values of options that have none of their own, so that each word means one thing.
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
    // CLI11's word for any text is TEXT.
    if (option->get_type_name() != "TEXT" || !option->nonpositional()) continue;
    for (const ValueWord& each : kValueWords) {
      if (option->check_lname(std::string(each.option))) {
        option->type_name(std::string(each.word));
      }
    }
  }
}

/// The lines of `examples` for the subcommand `name`.
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
