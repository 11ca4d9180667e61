#include <fmt/format.h>

#include <string>

#include "core/base/figure_text.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "viewer/page/page_job.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante page cell.toml session.mcap -o session.html\n"
    "  rocinante page session.mcap -o session.html          a log that carries its cell\n"
    "  rocinante page robot.urdf session.mcap -o session.html --size 50MB\n"
    "  rocinante page site.cell.toml session.mcap -o small.html --size 5MB --thin\n"
    "  rocinante page session.mcap -o fall.html --from 30s --until 45s\n"
    "  rocinante page cell.toml session.mcap -o session.html --layout forces.layout.toml\n"
    "  rocinante page --extract session.html -o session.mcap\n";

/// Faults shown; further ones are only counted.
constexpr std::size_t kWarningsShown = 5;
/// Kinds of what a page has not of a layout.
constexpr std::size_t kLayoutShown = 8;

Result<cli::Exit> make(PageJob job) {
  job.parallel = cli::workerThreads();
  const auto report = makePage(job);
  if (!report) return report.error();
  if (const std::string note = report->account.note(); !note.empty()) cli::warn(note);
  for (std::size_t i = 0; i < report->warnings.size() && i < kWarningsShown; ++i) {
    cli::warn(report->warnings[i]);
  }
  if (report->warnings.size() > kWarningsShown) {
    cli::warn(fmt::format("... and {} more", report->warnings.size() - kWarningsShown));
  }
  cli::say(fmt::format("{}: {}, with a log of {}\n", job.output.string(),
                       sizeText(report->page_bytes), sizeText(report->log_bytes)));
  if (!report->left_out.empty()) cli::say(report->left_out + "\n");
  if (!report->layout_left_out.empty()) {
    cli::say(fmt::format("of {} {}\n", job.layout.filename().string(),
                         accountSentence(report->layout_left_out, kLayoutShown)));
  }
  if (report->findings > 0) {
    cli::say(fmt::format("findings of check: {}, of them {} error{}\n", report->findings,
                         report->errors, report->errors == 1 ? "" : "s"));
  }
  return report->is_whole ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app("Makes one HTML file that shows a session in any browser, without a network.",
                   "rocinante-page");
  PageJob job;
  std::string page;
  std::string most = "20MB";
  app.addOption("CELL", job.cell,
                "a .cell.toml, a .urdf or an .obj; without it, the cell that the log carries");
  app.addOption("LOG", job.log, "the session");
  app.addOption("-o,--output", job.output, "the page; with --extract, the log").required();
  app.addOption("--size", most, "the largest page that is written").showDefault();
  app.addFlag("--thin", job.thin,
              "make a page that would be larger smaller, by coarser pictures and meshes; the log "
              "stays whole");
  app.addOption("--from", job.from,
                "begin at this session time (12.5s, -1s, RFC 3339), as `log cut` does")
      .valueText("TIME");
  app.addOption("--until", job.until, "end before this session time").valueText("TIME");
  app.addOption("--layout", job.layout,
                "begin with the curves, insets, camera and theme of this NAME.layout.toml of the "
                "window")
      .valueText("FILE");
  app.addOption("--extract", page, "write the log that this page carries, byte for byte")
      .valueText("PAGE");
  app.addOption("--viewer", job.viewer,
                "the folder of rocinante-viewer.js and .wasm, which scripts/build_web makes; "
                "without it, the installed one")
      .valueText("DIR");
  app.addFlag("--force", job.overwrite, "replace an existing file");
  cli::addSearchOptions(app, job);
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    std::optional<cli::StopDeadline> until_stopped(std::in_place, "stopped");
    if (!page.empty()) {
      if (!job.cell.empty() || !job.from.empty() || !job.until.empty()) {
        return Error{ErrorKind::bad_argument, "--extract takes no LOG, no CELL and no times", {}};
      }
      if (!job.layout.empty()) {
        return Error{ErrorKind::bad_argument, "--extract takes no --layout", {}};
      }
      const auto bytes = extractLog(page, job.output, job.overwrite);
      if (!bytes) return bytes.error();
      cli::say(fmt::format("{}: {}\n", job.output.string(), sizeText(*bytes)));
      return cli::Exit::done;
    }
    if (!orderLogAndItsCell(job.cell, job.log)) {
      return Error{ErrorKind::bad_argument, "give a LOG, or --extract PAGE", {}};
    }
    const auto bytes = parseSize(most);
    if (!bytes) return Error{bytes.error().kind, bytes.error().what, "--size"};
    job.most_bytes = *bytes;
    // One deadline at a time.
    until_stopped.reset();
    const auto opened = cli::openSession(job.log, job.cell, job);
    until_stopped.emplace("stopped");
    if (!opened) return opened.error();
    job.log = opened->log;
    return make(std::move(job));
  });
}
