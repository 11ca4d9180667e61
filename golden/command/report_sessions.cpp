#include <fmt/format.h>

#include <algorithm>

#include "core/cli/worker_threads.h"
#include "golden/command/report_output.h"
#include "golden/why/frame_why.h"
#include "viewer/page/page_file.h"
#include "viewer/page/page_job.h"

namespace rocinante {
namespace {

/// Beyond it the page is made smaller, and beyond that there is none.
constexpr std::uint64_t kMostBytes = 20'000'000;

/// Adds a page to the report under this name; false where the log gives none.
Result<bool> addPage(const SuiteSession& session, const SuiteArguments& arguments,
                     const std::filesystem::path& viewer, const OpenedRecording& recording,
                     const std::string& name, SuiteReport& report) {
  PageJob job;
  static_cast<ModelSearch&>(job) = arguments;
  job.log = recording.log;
  job.cell = session.suite().cell;
  job.output = name;
  job.viewer = viewer;
  job.most_bytes = kMostBytes;
  job.thin = true;
  job.parallel = cli::workerThreads();
  auto made = pageFor(job);
  if (!made && made.error().kind == ErrorKind::not_found) return made.error();
  if (!made) {
    report.notes.push_back(fmt::format("no page of the session: {}", made.error().text()));
    return false;
  }
  report.pages.push_back({name, std::move(made->html)});
  return true;
}

/// What most of the difference is about, where the frame shows it.
Path blamed(const JudgedFrame& judged) {
  if (!judged.why) return {};
  for (const LinkChange& change : judged.why->blame.changes) {
    const bool is_shown = change.kind != ChangeKind::vanished &&
                          change.kind != ChangeKind::drawing && change.kind != ChangeKind::camera;
    if (is_shown && !change.name.device.empty())
      return {false, change.name.device, change.name.link};
  }
  return {};
}

bool asksForPage(const JudgedFrame& judged) {
  return !isFine(judged.verdict) && judged.frame.time.has_value();
}

}  // namespace

Status addSessionPages(const SuiteSession& session, const SuiteArguments& arguments,
                       const std::filesystem::path& viewer, SuiteReport& report) {
  const OpenedRecording* const log = session.log();
  bool has_page = false;
  if (log != nullptr && session.origin() && std::ranges::any_of(report.frames, asksForPage)) {
    auto added = addPage(session, arguments, viewer, *log, kSessionPageFile, report);
    if (!added) return added.error();
    has_page = *added;
  }
  for (JudgedFrame& judged : report.frames) {
    if (!has_page || !asksForPage(judged)) continue;
    judged.page = kSessionPageFile + pageLink(*judged.frame.time - *session.origin(),
                                              judged.frame.camera, blamed(judged));
  }
  for (JudgedRun& run : report.runs) {
    if (run.verdict != FrameVerdict::different) continue;
    const auto is_it = [&](const SuiteRun* one) { return one->name == run.name; };
    const auto spec = std::ranges::find_if(session.runs(), is_it);
    const OpenedRecording* const its =
        spec == session.runs().end() ? nullptr : session.logOf(**spec);
    if (its == nullptr) continue;
    if (its == log && has_page) {
      run.page = kSessionPageFile;
      continue;
    }
    auto added = addPage(session, arguments, viewer, *its, runPageFile(run), report);
    if (!added) return added.error();
    if (*added) run.page = runPageFile(run);
  }
  return {};
}

}  // namespace rocinante
