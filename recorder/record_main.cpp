#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/cli/program.h"
#include "recorder/record_arguments.h"
#include "recorder/record_report.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante record                               what this machine's own group says\n"
    "  rocinante record :19960 -o cell.mcap           whatever is sent to port 19960\n"
    "  rocinante record '239.1.2.3:5000?interface=eth0' [::]:5000 --duration 1m\n"
    "  rocinante record --cell demo.cell.toml -o demo.mcap\n"
    "  rocinante record -o logs/ --min-packets 1 --max-loss 0 --json\n";

RecordEvents eventsFor(const RecordArguments& arguments, const RecordOptions& options) {
  RecordEvents events;
  events.stop_requested = cli::stopRequested;
  if (arguments.quiet) return events;
  events.ready = [&](const std::vector<std::string>& endpoints) {
    fmt::print(stderr, "recording {} to {}\n", fmt::join(endpoints, " "), options.log.string());
  };
  if (::isatty(STDERR_FILENO) != 1) return events;
  events.progress = [before = RecordProgress()](const RecordProgress& now) mutable {
    // To the line's beginning, and what a longer line left behind is cleared.
    fmt::print(stderr, "\r{}\x1b[K", statusText(now, before));
    std::fflush(stderr);
    before = now;
  };
  return events;
}

cli::Exit judge(const RecordArguments& arguments, const RecordSummary& summary) {
  cli::Exit exit = cli::Exit::done;
  const auto no = [&](std::string_view reason) {
    cli::warn(reason);
    exit = cli::Exit::no;
  };
  if (summary.trouble) no(summary.trouble->text());
  if (summary.packets < arguments.min_packets) {
    no(fmt::format("recorded {} packets, fewer than --min-packets {}", summary.packets,
                   arguments.min_packets));
  }
  if (arguments.max_loss && summary.lost() > *arguments.max_loss) {
    no(fmt::format("lost {} packets, more than --max-loss {}", summary.lost(),
                   *arguments.max_loss));
  }
  return exit;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Records what arrives by UDP: every datagram, with the kernel's own arrival time,\n"
      "and an account of anything lost. Ctrl-C ends the recording cleanly.",
      "rocinante-record");
  RecordArguments arguments;
  addRecordArguments(app, arguments);

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    const Result<RecordOptions> options = readRecordArguments(arguments);
    if (!options) return options.error();
    cli::catchStopSignals();
    const Result<RecordSummary> summary = record(*options, eventsFor(arguments, *options));
    if (!summary) return summary.error();
    if (!arguments.quiet && ::isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\x1b[K");
    if (arguments.json) {
      fmt::print("{}\n", summaryJson(*summary));
    } else if (!arguments.quiet) {
      fmt::print("{}\n", summaryText(*summary));
    }
    return judge(arguments, *summary);
  });
}
