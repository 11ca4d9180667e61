#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/behaviour/track_cache.h"
#include "core/bundle/private_folder.h"
#include "core/check/check.h"
#include "core/check/rules/rule_list.h"
#include "core/cli/worker_threads.h"
#include "core/report/account.h"
#include "golden/approval/run_approval.h"
#include "golden/command/commands.h"
#include "golden/judge/suite_runs.h"
#include "golden/report/report.h"
#include "golden/report/report_runs.h"
#include "golden/suite/suite_neighbours.h"
#include "golden/why/accepted_cells.h"
#include "golden/why/file_change.h"
#include "golden/why/frame_explainer.h"

namespace rocinante {
namespace {

constexpr std::size_t kMostPrinted = 20;

/// Why a log should not be accepted, a sentence each.
class Objections {
 public:
  Objections(const SuiteSession& session, const SuiteOptions& options, const SuiteRun& run,
             const OpenedRecording& log)
      : session_(session), options_(options), run_(run), log_(log) {}

  Status collect(bool replace) {
    if (Status checked = check(); !checked) return checked;
    return judge(replace);
  }
  const std::vector<std::string>& found() const { return found_; }

 private:
  Status check() {
    auto reader = LogReader::open(log_.log);
    if (!reader.ok()) return reader.error();
    const auto report = checkLog(session_.cell(), *reader);
    if (!report.ok()) return report.error();
    for (const Finding& finding : report->findings) {
      if (report->isFailure(finding) && !isOfPicturesOnly(finding.rule)) {
        const std::string hint = finding.hint.empty() ? "" : " (" + plainText(finding.hint) + ")";
        found_.push_back(
            fmt::format("{}{} [{}]", plainText(sentenceOf(finding)), hint, finding.rule));
      }
    }
    if (report->verdict == CheckVerdict::nothing_judged && found_.empty()) {
      found_.emplace_back("no packet of the log can be decoded");
    }
    return {};
  }

  Status judge(bool replace) {
    AcceptedCells cells(session_, options_);
    const RunOptions options{cli::stopRequested, steadyMs, TrackCache::ofUser(),
                             [&](const AcceptedRun& accepted) { return cells.of(accepted); },
                             cli::workerThreads()};
    const auto alone = judgeAlone(session_, run_);
    if (!alone.ok()) return alone.error();
    if (!alone->empty()) found_.push_back(*alone);
    if (replace || !alone->empty() || session_.manifest().runsOf(run_.name).empty()) return {};
    const auto judged = judgeOneRun(session_, run_, options);
    if (!judged.ok()) return judged.error();
    if (judged->verdict == FrameVerdict::incomparable) found_.push_back(judged->rule);
    print(judged->judgement.findings);
    return {};
  }

  /// What is accepted from now on and was not.
  void print(const std::vector<RunFinding>& findings) {
    for (std::size_t i = 0; i < std::min(findings.size(), kMostPrinted); ++i) {
      const RunFinding& finding = findings[i];
      fmt::print("  widens: {}\n", plainText(finding.what));
    }
    if (findings.size() > kMostPrinted) {
      fmt::print("  widens: {} more\n", findings.size() - kMostPrinted);
    }
    for (const RunFinding& finding : findings) {
      if (widensFar(finding)) found_.push_back(widensFarText(finding));
    }
  }

  const SuiteSession& session_;
  const SuiteOptions& options_;
  const SuiteRun& run_;
  const OpenedRecording& log_;
  std::vector<std::string> found_;
};

/// Somebody has said how far recordings of the run differ.
bool hasLimits(const RunSpec& spec) {
  const RunLimits& limits = spec.limits;
  return !spec.own_limits.empty() || limits.joint_deg > kRunFloors.joint_deg ||
         limits.position_mm > kRunFloors.position_mm || limits.turn_deg > kRunFloors.turn_deg ||
         limits.event_ms > kRunFloors.event_ms || limits.signal_share != kRunFloors.signal_share;
}

Status refuseFor(const std::vector<std::string>& objections, const OpenedRecording& log,
                 bool anyway) {
  for (std::size_t i = 0; i < std::min(objections.size(), kMostPrinted); ++i) {
    cli::warn(objections[i]);
  }
  if (objections.size() > kMostPrinted) {
    cli::warn(fmt::format("and {} objections more", objections.size() - kMostPrinted));
  }
  if (objections.empty() || anyway) return {};
  return Error{ErrorKind::refused, "not accepted; --anyway accepts it all the same",
               log.recording.string()};
}

/// `listed` is the hash of its log in a list; empty without one.
Result<cli::Exit> approveOneRun(const ApproveArguments& arguments, const std::string& listed) {
  auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  auto named = runNamed(*session, arguments.run);
  if (!named.ok()) return named.error();
  if (auto own = session->optionsOf(**named, *options)) {
    *options = std::move(*own);
    session = SuiteSession::open(arguments.suite.suite, *options);
    if (!session.ok()) return session.error();
    named = runNamed(*session, arguments.run);
    if (!named.ok()) return named.error();
  }
  const SuiteRun* const run = *named;
  const OpenedRecording* const log = session->logOf(*run);
  if (log == nullptr) {
    return Error{ErrorKind::bad_argument, "a log to accept is needed",
                 "--log " + arguments.run + "=FILE"};
  }
  if (!listed.empty()) {
    const auto bytes = readFile(log->log, kMaxRunLogBytes);
    if (!bytes.ok()) return log->named(bytes.error());
    if (hexOf(xxh3(bytesOf(*bytes))) != listed) {
      return Error{ErrorKind::refused, "its log is not the one that the list accepts",
                   "run " + run->name};
    }
  }
  Objections objections(*session, *options, *run, *log);
  if (Status collected = objections.collect(arguments.replace); !collected) {
    return log->named(collected.error());
  }
  if (Status may = refuseFor(objections.found(), *log, arguments.anyway); !may) return may.error();
  RunCandidate candidate{run->name, log->log, userName(), nowText(), arguments.message};
  candidate.replace = arguments.replace;
  candidate.kinematics = trackCellHash(session->cell());
  for (const RunMask& mask : run->spec.masks) candidate.masks.push_back(maskText(mask));
  if (const auto cell = collectSessionCell(*session, *options); cell.ok()) {
    candidate.cell_files = hashesOf(*cell);
    candidate.cell_texts = recordedTexts(*cell);
  }
  const auto approved = approveRun(session->folder(), candidate);
  if (!approved.ok()) return log->named(approved.error());
  fmt::print("{} {} for run {}; goldens in {}\n",
             listed.empty() ? log->recording.string() : "its log",
             *approved == RunApproved::added ? "accepted" : "was accepted already", run->name,
             session->suite().goldens.lexically_normal().string());
  const std::string shared =
      sharedGolden(neighboursOf(session->suite()), GoldenKind::run, run->name);
  if (!shared.empty()) cli::warn(shared);
  const bool is_first = arguments.replace || session->manifest().runsOf(run->name).empty();
  if (is_first && !hasLimits(run->spec)) {
    fmt::print(
        "one recording tells no band: accept 2 to 4 more, or let `rocinante golden suggest` "
        "derive limits from several\n");
  }
  return cli::Exit::done;
}

}  // namespace

Result<cli::Exit> approveListedRun(const ApproveArguments& arguments, const std::string& run,
                                   const std::string& bytes) {
  ApproveArguments its = arguments;
  its.run = run;
  its.suite.only.clear();
  its.suite.tags.clear();
  its.suite.not_tags.clear();
  its.suite.shard.clear();
  return approveOneRun(its, bytes);
}

Result<cli::Exit> approveReportedRun(const ApproveArguments& arguments, const JudgedRun& run,
                                     const std::string& bytes) {
  if (!run.log_copy) {
    return Error{ErrorKind::not_found,
                 "the report has no copy of its log: give the log, without --artifact",
                 "run " + run.name};
  }
  if (run.log_bytes != bytes) {
    return Error{ErrorKind::refused, "the log in the report is not the one that the list accepts",
                 "run " + run.name};
  }
  const auto folder = PrivateFolder::make();
  if (!folder.ok()) return folder.error();
  const std::filesystem::path file = (*folder)->path() / runLogFile(run);
  if (Status written = writeFileWhole(file, bytesOf(*run.log_copy), true); !written) {
    return written.error();
  }
  ApproveArguments its = arguments;
  its.suite.logs.push_back(run.name + "=" + file.string());
  // CI recorded the suite's log, too: nothing of it is judged here.
  const auto suite = readSuite(arguments.suite.suite);
  std::error_code ignored;
  if (suite.ok() && suite->log && !std::filesystem::exists(*suite->log, ignored)) {
    its.suite.logs.push_back(file.string());
  }
  const auto done = approveListedRun(its, run.name, bytes);
  if (done.ok()) return done;
  // Its file is one of ours.
  return Error{done.error().kind, done.error().what, "run " + run.name};
}

Result<cli::Exit> approveRunOfSuite(const ApproveArguments& arguments) {
  auto done = approveOneRun(arguments, "");
  if (done.ok() || done.error().kind != ErrorKind::refused || cli::stopRequested()) return done;
  // As of a list: it could be judged, and is not kept.
  cli::warn(done.error().text());
  return cli::Exit::no;
}

}  // namespace rocinante
