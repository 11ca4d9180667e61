#include "golden/command/suite_arguments.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <tuple>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"

namespace rocinante {
void addSuiteOptions(cli::CommandLine app, SuiteArguments& arguments) {
  app.addOption("SUITE", arguments.suite, "the suite's TOML file").required();
  app.addOption("--cell", arguments.cell, "use this cell instead of the suite's");
  app.addOption("--log", arguments.logs,
                "use this log instead of the suite's; RUN=FILE: the log under test of a [[run]]; "
                "repeatable")
      .valueText("[RUN=]FILE")
      .oneEach();
  app.addOption("--only", arguments.only,
                "only frames and cases that match this pattern; repeatable")
      .oneEach();
  app.addOption("--tag", arguments.tags, "only cases with this tag; repeatable").oneEach();
  app.addOption("--not-tag", arguments.not_tags, "only cases without this tag; repeatable")
      .oneEach();
  app.addOption("--shard", arguments.shard, "part I of N of the cases").valueText("I/N");
  cli::addSearchOptions(app, arguments);
}

void addIncompleteOption(cli::CommandLine app, SuiteArguments& arguments) {
  app.addFlag("--incomplete", arguments.incomplete, "accept frames with missing visual meshes");
}

Result<SuiteOptions> suiteOptions(const SuiteArguments& arguments) {
  SuiteOptions options;
  if (!arguments.cell.empty()) options.cell = arguments.cell;
  options.logs = arguments.logs;
  options.selection.only = arguments.only;
  options.selection.tags = arguments.tags;
  options.selection.not_tags = arguments.not_tags;
  if (!arguments.shard.empty()) {
    const auto shard = parseShard(arguments.shard);
    if (!shard.ok()) return shard.error();
    std::tie(options.selection.shard, options.selection.shards) = *shard;
  }
  static_cast<ModelSearch&>(options) = arguments;
  options.incomplete = arguments.incomplete;
  options.drawers = arguments.drawers;
  options.parallel = cli::workerThreads();
  options.now_ms = steadyMs;
  return options;
}

Result<const SuiteRun*> runNamed(const SuiteSession& session, const std::string& name) {
  const auto& runs = session.suite().runs;
  const auto run = std::ranges::find(runs, name, &SuiteRun::name);
  if (run != runs.end()) return &*run;
  return Error{ErrorKind::bad_argument, "the suite has no such run", "--run " + name};
}

std::string commandText(const char* verb, const SuiteArguments& arguments) {
  std::string text =
      fmt::format("rocinante golden {} {}", verb, shellWord(arguments.suite.string()));
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) text += fmt::format(" {} {}", option, shellWord(value));
  };
  add("--cell", arguments.cell);
  for (const std::string& log : arguments.logs) add("--log", log);
  if (arguments.incomplete) text += " --incomplete";
  for (const std::string& glob : arguments.only) add("--only", glob);
  for (const std::string& tag : arguments.tags) add("--tag", tag);
  for (const std::string& tag : arguments.not_tags) add("--not-tag", tag);
  add("--shard", arguments.shard);
  for (const std::string& word : cli::searchWords(arguments)) text += " " + shellWord(word);
  return text;
}

double steadyMs() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

std::string nowText() {
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  return rfc3339Text(WallTime(now.time_since_epoch())).substr(0, 19) + "Z";
}

std::string userName() {
  for (const char* variable : {"ROCINANTE_USER", "USER", "LOGNAME"}) {
    if (const char* name = std::getenv(variable); name != nullptr && *name != '\0') return name;
  }
  return "uid " + std::to_string(::getuid());
}

void warnOfModelFaults(const Cell& cell) {
  const auto warn = [](std::string_view what, std::string_view kind, std::size_t count,
                       const Finding& first) {
    cli::warn(fmt::format("the cell has {} {}(rocinante check lists all); the first: {}",
                          countText(count, kind), what, first.print()));
  };
  if (const Finding* const first = firstError(cell.faults)) {
    return warn("", "error", countOf(cell.faults, Severity::error), *first);
  }
  const auto isMissed = [](const Finding& fault) {
    return fault.severity == Severity::warning && !fault.left_out.empty();
  };
  const auto first = std::ranges::find_if(cell.faults, isMissed);
  if (first == cell.faults.end()) return;
  warn("of what is left out ", "warning",
       static_cast<std::size_t>(std::ranges::count_if(cell.faults, isMissed)), *first);
}

}  // namespace rocinante
