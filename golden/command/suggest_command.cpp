#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/behaviour/limit_suggestion.h"
#include "core/behaviour/link_tracks.h"
#include "core/behaviour/run_judge.h"
#include "core/cli/opened_session.h"
#include "core/cli/worker_threads.h"
#include "golden/command/commands.h"

namespace rocinante {
namespace {

constexpr std::size_t kLeastRecordings = 3, kMostRecordings = 32;

void print(const std::string& run, const RunSpec& spec, const LimitSuggestion& found) {
  const std::string limits = found.toml(spec);
  fmt::print("# run {}, from {} recordings, each judged beside the others\n", run,
             found.recordings);
  fmt::print("{}\n", limits.empty() ? "# no limit needs to be wider" : limits);
  fmt::print("# different: {} of {} as the suite is, {} of {} with limits from the others alone\n",
             found.alarms_before, found.recordings, found.alarms, found.recordings);
  fmt::print("# expect {:.0f} % false alarms", found.expected() * 100);
  if (found.wanted() > 0) {
    fmt::print("; {} more without an alarm make that 5 %", countText(found.wanted(), "recording"));
  }
  fmt::print("\n");
  for (const std::string& what : found.beyond) {
    fmt::print("# no limit accepts this: {}\n", plainText(what));
  }
}

}  // namespace

cli::CommandLine addSuggestCommand(cli::CommandLine app, SuggestArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand(
      "suggest", "print limits of a run with which several recordings of it are the same");
  addSuiteOptions(command, arguments.suite);
  command.addOption("--run", arguments.run, "the run of the suite").required();
  command
      .addOption("RECORDING", arguments.recordings,
                 "recordings of the run that are all meant to be the same, at least three")
      .required();
  return command;
}

Result<cli::Exit> runSuggestCommand(const SuggestArguments& arguments) {
  if (arguments.recordings.size() < kLeastRecordings ||
      arguments.recordings.size() > kMostRecordings) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("limits need {} to {} recordings; these are {}", kLeastRecordings,
                             kMostRecordings, arguments.recordings.size()),
                 ""};
  }
  const auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  const auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  const auto named = runNamed(*session, arguments.run);
  if (!named.ok()) return named.error();
  const SuiteRun* const run = *named;
  const std::vector<std::string> links = linksToJudge(run->spec, session->cell());
  std::vector<SessionTrack> tracks;
  for (const std::filesystem::path& recording : arguments.recordings) {
    if (cli::stopRequested()) return Error{ErrorKind::refused, "interrupted", recording.string()};
    const auto opened = cli::openSession(recording, session->suite().cell, arguments.suite);
    if (!opened.ok()) return opened.error();
    auto track = trackSession(session->cell(), opened->log, links);
    if (!track.ok()) return opened->named(track.error());
    tracks.push_back(std::move(*track));
  }
  std::vector<const SessionTrack*> sessions;
  for (const SessionTrack& track : tracks) sessions.push_back(&track);
  for (std::size_t i = 1; i < sessions.size(); ++i) {
    const RunJudgement judged = judgeRun(run->spec, {sessions.front()}, *sessions[i]);
    if (judged.comparable) continue;
    return Error{ErrorKind::bad_argument, judged.rule, arguments.recordings[i].string()};
  }
  print(run->name, run->spec, suggestLimits(run->spec, sessions, cli::workerThreads()));
  return cli::Exit::done;
}

}  // namespace rocinante
