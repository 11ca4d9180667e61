#include "golden/command/approve_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/plain_text.h"
#include "core/check/check.h"
#include "golden/approval/run_approval.h"
#include "golden/judge/suite_runs.h"
#include "golden/run/track_cache.h"
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
      if (report->isFailure(finding)) {
        found_.push_back(fmt::format("{} [{}]", plainText(finding.text), finding.rule));
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
                             [&](const AcceptedRun& accepted) { return cells.of(accepted); }};
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
      if (!finding.largest || finding.limit <= 0) continue;
      if (*finding.largest <= kMostWidening * finding.limit) continue;
      found_.push_back(
          fmt::format("{} is {} beyond what was accepted, more than {} times its "
                      "limit of {}",
                      finding.item, figureText(*finding.largest, finding.unit), kMostWidening,
                      figureText(finding.limit, finding.unit)));
    }
  }

  const SuiteSession& session_;
  const SuiteOptions& options_;
  const SuiteRun& run_;
  const OpenedRecording& log_;
  std::vector<std::string> found_;
};

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

}  // namespace

Result<cli::Exit> approveRunOfSuite(const ApproveArguments& arguments) {
  const auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  const auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  const auto& runs = session->suite().runs;
  const auto run = std::ranges::find(runs, arguments.run, &SuiteRun::name);
  if (run == runs.end()) {
    return Error{ErrorKind::bad_argument, "the suite has no such run", "--run " + arguments.run};
  }
  const OpenedRecording* const log = session->logOf(*run);
  if (log == nullptr) {
    return Error{ErrorKind::bad_argument, "a log to accept is needed",
                 "--log " + arguments.run + "=FILE"};
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
    candidate.cell_texts = toldTexts(*cell);
  }
  const auto approved = approveRun(session->folder(), candidate);
  if (!approved.ok()) return log->named(approved.error());
  fmt::print("{} {} for run {}; goldens in {}\n", log->recording.string(),
             *approved == RunApproved::added ? "accepted" : "was accepted already", run->name,
             session->suite().goldens.lexically_normal().string());
  return cli::Exit::done;
}

}  // namespace rocinante
