#include "golden/command/add_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "core/base/atomic_file.h"
#include "golden/suite/suite_append.h"
#include "viewer/picture/picture_size.h"
#include "viewer/view/render_style.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxSuiteBytes = 16U << 20U;

/// The styles as an inline table; a repeated key becomes a list.
Result<std::string> styleTable(const std::vector<std::string>& words) {
  RenderStyle style;
  for (const std::string& word : words) {
    if (auto set = setStyle(style, word); !set) return set.error();
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> keys;
  for (const auto& [key, value] : styleWords(style)) {
    if (keys.empty() || keys.back().first != key)
      keys.emplace_back(key, std::vector<std::string>());
    keys.back().second.push_back(tomlText(value));
  }
  std::string table;
  for (const auto& [key, values] : keys) {
    table += fmt::format("{}{} = ", table.empty() ? "" : ", ", key);
    table += values.size() == 1 ? values[0] : fmt::format("[{}]", fmt::join(values, ", "));
  }
  return "{ " + table + " }";
}

Result<NewCase> caseOf(const AddArguments& arguments) {
  NewCase made;
  made.name = arguments.name;
  made.addText("at", arguments.at);
  made.addText("event", arguments.event);
  if (arguments.occurrence != 0) made.add("occurrence", std::to_string(arguments.occurrence));
  made.addText("events", arguments.events);
  made.addText("after", arguments.after);
  made.addText("every", arguments.every);
  if (arguments.cameras.size() == 1) {
    made.addText("camera", arguments.cameras[0]);
  } else {
    made.addTexts("camera", arguments.cameras);
  }
  if (!arguments.size.empty()) {
    const auto size = parsePictureSize(arguments.size);
    if (!size.ok()) return size.error();
    made.add("size", fmt::format("[{}, {}]", size->first, size->second));
  }
  if (arguments.samples != 0) made.add("samples", std::to_string(arguments.samples));
  made.addTexts("layers", arguments.layers);
  made.addTexts("hide", arguments.hide);
  made.addTexts("show", arguments.show);
  made.addTexts("mask", arguments.mask);
  if (!arguments.style.empty()) {
    auto style = styleTable(arguments.style);
    if (!style.ok()) return style.error();
    made.add("style", std::move(*style));
  }
  made.addText("tolerance", arguments.tolerance);
  made.addText("expect", arguments.expect);
  made.addText("reason", arguments.reason);
  made.addTexts("tags", arguments.tags);
  return made;
}

/// The suite's text, or the first lines of a new suite when the file does not exist and a cell or
/// log is given.
Result<std::string> suiteText(const AddArguments& arguments) {
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(arguments.suite, ignored);
  const bool names_files = !arguments.cell.empty() || !arguments.log.empty();
  if (is_new && names_files) {
    std::string text = "format = 1\n";
    if (!arguments.cell.empty()) text += "cell = " + tomlText(arguments.cell) + "\n";
    if (!arguments.log.empty()) text += "log = " + tomlText(arguments.log) + "\n";
    return text;
  }
  if (!is_new && names_files) {
    return Error{ErrorKind::bad_argument,
                 "the suite exists and names its cell and log; --cell and --log are for a new "
                 "suite",
                 arguments.suite.string()};
  }
  return readFile(arguments.suite, kMaxSuiteBytes);
}

}  // namespace

CLI::App* addCaseCommand(CLI::App& app, AddArguments& arguments) {
  CLI::App* command = app.add_subcommand("add", "append a case to a suite, without a picture");
  const auto list = [&](const char* option, std::vector<std::string>& values, const char* text) {
    command->add_option(option, values, text)->allow_extra_args(false);
  };
  command->add_option("SUITE", arguments.suite, "the suite's TOML file")->required();
  command->add_option("--case", arguments.name, "the case's name")->required();
  command->add_option("--at", arguments.at, "a session time");
  command->add_option("--event", arguments.event, "the event with this text");
  command->add_option("--occurrence", arguments.occurrence,
                      "which of several such events: 1 first, -1 last");
  command->add_option("--events", arguments.events,
                      "one frame per event whose text matches this pattern");
  command->add_option("--after", arguments.after, "delay after the event");
  command->add_option("--every", arguments.every, "one frame per period, as 500ms");
  list("--camera", arguments.cameras, "a camera of the cell or the session; repeatable");
  command->add_option("--size", arguments.size, "picture size in pixels, as 640x480");
  command->add_option("--samples", arguments.samples, "1 or 4");
  list("--layer", arguments.layers, "draw only this layer; repeatable");
  list("--hide", arguments.hide, "do not draw PATH; repeatable");
  list("--show", arguments.show, "draw PATH even if hidden; repeatable");
  list("--mask", arguments.mask, "do not judge PATH; repeatable");
  list("--style", arguments.style, "a style, as KEY=VALUE; repeatable");
  command->add_option("--tolerance", arguments.tolerance,
                      "exact, rounding, cpu, loose or a tolerance of the suite");
  command->add_option("--expect", arguments.expect,
                      "`different`: expect a difference; needs --reason");
  command->add_option("--reason", arguments.reason, "why a difference is expected");
  list("--tag", arguments.tags, "repeatable");
  command->add_option("--cell", arguments.cell, "of a new suite");
  command->add_option("--log", arguments.log, "of a new suite");
  return command;
}

Result<cli::Exit> runAddCommand(const AddArguments& arguments) {
  const auto made = caseOf(arguments);
  if (!made.ok()) return made.error();
  const auto before = suiteText(arguments);
  if (!before.ok()) return before.error();
  const auto after = withCase(*before, *made, arguments.suite);
  if (!after.ok()) return after.error();
  if (auto written = writeFileWhole(arguments.suite, bytesOf(*after), true); !written) {
    return written.error();
  }
  fmt::print("added case {}; `rocinante golden approve` makes its golden\n", arguments.name);
  return cli::Exit::done;
}

}  // namespace rocinante
