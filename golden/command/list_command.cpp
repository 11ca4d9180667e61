#include <fmt/format.h>

#include <iostream>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "core/report/json_text.h"
#include "golden/command/commands.h"
#include "golden/judge/housekeeping.h"
#include "golden/suite/suite_neighbours.h"

namespace rocinante {
namespace {

const std::vector<AcceptedPicture>& picturesOf(const SuiteSession& session,
                                               const std::string& name) {
  static const std::vector<AcceptedPicture> kNone;
  const auto found = session.manifest().cases.find(name);
  return found == session.manifest().cases.end() ? kNone : found->second;
}

std::string momentText(const SuiteSession& session, const SuiteFrame& frame) {
  if (!frame.time) return "none";
  if (!session.origin()) return "rest";
  return secondsText(*frame.time - *session.origin(), 3);
}

void printTable(const SuiteSession& session) {
  cli::TextTable table;
  table.rows.push_back({"frame", "moment", "golden", "accepted by", "at", "why"});
  for (const SuiteFrame& frame : session.frames()) {
    const auto& pictures = picturesOf(session, frame.name);
    std::string name = frame.name;
    std::string moment = momentText(session, frame);
    if (pictures.empty()) table.rows.push_back({name, moment, "none", "", "", ""});
    for (const AcceptedPicture& accepted : pictures) {
      table.rows.push_back({std::exchange(name, ""), std::exchange(moment, ""), accepted.picture,
                            plainText(accepted.accepted_by), plainText(accepted.accepted_at),
                            plainText(accepted.reason)});
    }
  }
  table.is_number = {false, true, false, false, false, false};
  fmt::print("{}", table.text());
}

/// The runs with their accepted logs.
void printRuns(const SuiteSession& session) {
  if (session.runs().empty()) return;
  cli::TextTable table;
  table.rows.push_back({"run", "accepted log", "accepted by", "at", "why"});
  for (const SuiteRun* run : session.runs()) {
    const auto& logs = session.manifest().runsOf(run->name);
    std::string name = run->name;
    if (logs.empty()) table.rows.push_back({name, "none", "", "", ""});
    for (const AcceptedRun& accepted : logs) {
      table.rows.push_back({std::exchange(name, ""), accepted.log, plainText(accepted.accepted_by),
                            plainText(accepted.accepted_at), plainText(accepted.reason)});
    }
  }
  table.is_number = {false, false, false, false, false};
  fmt::print("{}", table.text());
}

void addRunsTo(Json& root, const SuiteSession& session) {
  for (const SuiteRun* run : session.runs()) {
    Json entry = {{"name", run->name}, {"align", nameOf(run->spec.align)}, {"tags", run->tags}};
    entry["accepted"] = Json::array();
    for (const AcceptedRun& accepted : session.manifest().runsOf(run->name)) {
      entry["accepted"].push_back({{"log", accepted.log},
                                   {"session", accepted.session},
                                   {"accepted_by", accepted.accepted_by},
                                   {"accepted_at", accepted.accepted_at},
                                   {"reason", accepted.reason}});
    }
    root["runs"].push_back(std::move(entry));
  }
}

void printJson(const SuiteSession& session, const std::vector<std::string>& faults) {
  Json root = {{"format", 1}, {"suite", session.suite().file.string()}};
  root["frames"] = Json::array();
  for (const SuiteFrame& frame : session.frames()) {
    Json entry = {{"name", frame.name}, {"case", frame.case_name}, {"tags", frame.tags}};
    if (!frame.camera.empty()) entry["camera"] = frame.camera;
    if (frame.time) entry["log_time_ns"] = frame.time->time_since_epoch().count();
    if (!frame.why.empty()) entry["why"] = frame.why;
    entry["goldens"] = Json::array();
    for (const AcceptedPicture& accepted : picturesOf(session, frame.name)) {
      entry["goldens"].push_back({{"key", accepted.key},
                                  {"picture", accepted.picture},
                                  {"pixels", accepted.pixels},
                                  {"accepted_by", accepted.accepted_by},
                                  {"accepted_at", accepted.accepted_at},
                                  {"reason", accepted.reason}});
      if (accepted.coverage) entry["goldens"].back()["coverage"] = *accepted.coverage;
    }
    root["frames"].push_back(std::move(entry));
  }
  addRunsTo(root, session);
  root["faults"] = faults;
  std::cout << jsonText(root);
}

}  // namespace

cli::CommandLine addListCommand(cli::CommandLine app, ListArguments& arguments) {
  const cli::CommandLine command =
      app.addSubcommand("list", "list the frames of a suite, their goldens and stale files");
  addSuiteOptions(command, arguments.suite);
  command.addFlag("--verify", arguments.verify, "read every golden and check its hash");
  command.addFlag("--json", arguments.json, "print the answer as JSON");
  return command;
}

Result<cli::Exit> runListCommand(const ListArguments& arguments) {
  const auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  const auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  const std::vector<std::string> faults =
      folderFaults(session->manifest(), session->folder(), session->allFrames(), arguments.verify,
                   session->suite().runs, neighboursOf(session->suite()));
  std::size_t without = 0;
  for (const SuiteFrame& frame : session->frames()) {
    without += picturesOf(*session, frame.name).empty() ? 1 : 0;
  }
  std::size_t runs_without = 0;
  for (const SuiteRun* run : session->runs()) {
    runs_without += session->manifest().runsOf(run->name).empty() ? 1 : 0;
  }
  if (arguments.json) {
    printJson(*session, faults);
  } else {
    if (!session->frames().empty()) printTable(*session);
    printRuns(*session);
    for (const std::string& fault : faults) fmt::print("{}\n", fault);
    if (!session->runs().empty()) {
      fmt::print("{}, {} without an accepted log\n", cli::counted(session->runs().size(), "run"),
                 runs_without);
    }
    fmt::print("{}, {} without a golden, {} faults\n",
               cli::counted(session->frames().size(), "frame"), without, faults.size());
  }
  return faults.empty() && without + runs_without == 0 ? cli::Exit::done : cli::Exit::no;
}

}  // namespace rocinante
