#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/session/moment_name.h"
#include "golden/command/commands.h"
#include "golden/suite/suite.h"
#include "golden/suite/suite_append.h"
#include "viewer/picture/picture_options.h"
#include "viewer/view/render_style.h"
#include "viewer/view/scene_options.h"

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
  // What is not a time is the name of an event.
  made.addText(isSessionTime(arguments.at) ? "at" : "event", arguments.at);
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
  if (arguments.scale != 0) made.add("scale", fmt::format("{}", arguments.scale));
  if (arguments.samples != 0) made.add("samples", std::to_string(arguments.samples));
  made.addTexts("layers", arguments.layers);
  made.addTexts("hide", arguments.hide);
  made.addTexts("show", arguments.show);
  if (arguments.no_insets) made.add("insets", "false");
  made.addTexts("insets", arguments.insets);
  if (arguments.overlay) made.add("panel", "true");
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

/// Whether both name one file, or two with the same bytes.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code fault;
  if (std::filesystem::equivalent(a, b, fault)) return true;
  const auto size = std::filesystem::file_size(a, fault);
  if (fault || size != std::filesystem::file_size(b, fault) || fault) return false;
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  std::array<char, 65536> of_a{}, of_b{};
  for (std::uintmax_t done = 0; done < size;) {
    const auto part = std::min<std::uintmax_t>(size - done, of_a.size());
    first.read(of_a.data(), static_cast<std::streamsize>(part));
    second.read(of_b.data(), static_cast<std::streamsize>(part));
    if (!first || !second || std::memcmp(of_a.data(), of_b.data(), part) != 0) return false;
    done += part;
  }
  return true;
}

/// The suite with the new case has the files that are given: a case of another session would be
/// drawn of the suite's.
Status checkFiles(const AddArguments& arguments, const std::string& text) {
  if (arguments.cell.empty() && arguments.log.empty()) return {};
  const auto suite = parseSuite(text, arguments.suite);
  if (!suite.ok()) return suite.error();
  // Names count from the suite's folder, as those of a new suite do.
  const std::filesystem::path folder = arguments.suite.parent_path();
  const auto differs = [&](const char* what, const std::filesystem::path& has,
                           const std::string& given) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the suite's {} is {}, not {}: add the case to a suite of its own",
                             what, has.empty() ? "the one that its log carries" : has.string(),
                             (folder / given).string()),
                 arguments.suite.string()};
  };
  const bool has_moment = !arguments.at.empty() || !arguments.event.empty() ||
                          !arguments.events.empty() || !arguments.every.empty();
  if (arguments.log.empty() && suite->log && !has_moment) {
    return Error{ErrorKind::bad_argument,
                 "the suite's cases are of a log, and this one has no moment: add it to a suite of "
                 "its own",
                 arguments.suite.string()};
  }
  if (!arguments.log.empty()) {
    if (!suite->log) {
      return Error{ErrorKind::bad_argument,
                   "the suite has no log: its cases are of the cell at rest",
                   arguments.suite.string()};
    }
    if (!isSameFile(*suite->log, folder / arguments.log)) {
      return differs("log", *suite->log, arguments.log);
    }
  }
  if (arguments.cell.empty()) return {};
  // The cell that the log carries is named by the log.
  const bool is_carried = arguments.cell == arguments.log;
  if (is_carried && suite->cell.empty()) return {};
  if (suite->cell.empty()) return differs("cell", {}, arguments.cell);
  if (isSameFile(suite->cell, folder / arguments.cell)) return {};
  return differs("cell", suite->cell, arguments.cell);
}

/// The suite's text, or the first lines of a new suite when the file does not exist and a cell or
/// log is given.
Result<std::string> suiteText(const AddArguments& arguments) {
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(arguments.suite, ignored);
  const bool names_files = !arguments.cell.empty() || !arguments.log.empty();
  if (is_new && names_files) {
    std::string text = "format = 1\n";
    if (!arguments.cell.empty() && arguments.cell != arguments.log)
      text += "cell = " + tomlText(arguments.cell) + "\n";
    if (!arguments.log.empty()) text += "log = " + tomlText(arguments.log) + "\n";
    return text;
  }
  return readFile(arguments.suite, kMaxSuiteBytes);
}

}  // namespace

cli::CommandLine addCaseCommand(cli::CommandLine app, AddArguments& arguments) {
  const cli::CommandLine command =
      app.addSubcommand("add", "append a case to a suite, without a picture");
  const auto list = [&](const char* option, std::vector<std::string>& values, const char* text) {
    command.addOption(option, values, text).oneEach();
  };
  command.addOption("SUITE", arguments.suite, "the suite's TOML file").required();
  command.addOption("--case", arguments.name, "the case's name").required();
  command.addOption("--at", arguments.at, "a session time, or the text of an event");
  command.addOption("--event", arguments.event, "the event with this text");
  command.addOption("--occurrence", arguments.occurrence,
                    "which of several such events: 1 first, -1 last");
  command.addOption("--events", arguments.events,
                    "one frame per event whose text matches this pattern");
  command.addOption("--after", arguments.after, "delay after the event");
  command.addOption("--every", arguments.every, "one frame per period, as 500ms");
  list("--camera", arguments.cameras, "a camera of the cell or the session; repeatable");
  command.addOption("--size", arguments.size, "picture size in pixels, as 640x480");
  command.addOption("--scale", arguments.scale, "of text and lines: 0.5 to 4");
  command.addOption("--samples", arguments.samples, "1 or 4");
  addLayersOption(command, arguments.layers);
  addVisibilityOptions(command, arguments.hide, arguments.show);
  list("--inset", arguments.insets, "CAMERA[:CORNER][:SIZE], in place of the cell's; repeatable");
  command.addFlag("--no-insets", arguments.no_insets, "leave out the cell's insets");
  command.addFlag("--overlay", arguments.overlay, "with a panel of times and values");
  list("--mask", arguments.mask, "do not judge PATH; repeatable");
  list("--style", arguments.style, "a style, as KEY=VALUE; repeatable");
  command.addOption("--tolerance", arguments.tolerance,
                    "exact, rounding, cpu, loose or a tolerance of the suite");
  command.addOption("--expect", arguments.expect,
                    "`different`: expect a difference; needs --reason");
  command.addOption("--reason", arguments.reason, "why a difference is expected");
  list("--tag", arguments.tags, "repeatable");
  command.addOption("--cell", arguments.cell,
                    "of a new suite; of a suite that exists it must be the same");
  command.addOption("--log", arguments.log,
                    "of a new suite; of a suite that exists it must be the same");
  return command;
}

Result<cli::Exit> runAddCommand(const AddArguments& arguments) {
  const auto made = caseOf(arguments);
  if (!made.ok()) return made.error();
  const auto before = suiteText(arguments);
  if (!before.ok()) return before.error();
  const auto after = withCase(*before, *made, arguments.suite);
  if (!after.ok()) return after.error();
  if (Status same = checkFiles(arguments, *after); !same) return same.error();
  if (auto written = writeFileWhole(arguments.suite, bytesOf(*after), true); !written) {
    return written.error();
  }
  fmt::print("added case {}; `rocinante golden approve` makes its golden\n", arguments.name);
  return cli::Exit::done;
}

}  // namespace rocinante
