#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <unistd.h>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/cli/program.h"
#include "core/cli/status_line.h"
#include "core/cli/terminal.h"
#include "core/cli/text_table.h"
#include "core/recording/record_path.h"
#include "recorder/capture/record_arguments.h"
#include "recorder/capture/record_report.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante record                               the local multicast group\n"
    "  rocinante record :19960 -o cell.mcap           everything sent to port 19960\n"
    "  rocinante record '239.1.2.3:5000?interface=eth0' [::]:5000 --duration 1m\n"
    "  rocinante record --cell demo.cell.toml -o demo.mcap\n"
    "  rocinante record -o logs/ --min-packets 1 --max-loss 0 --json\n"
    "  rocinante record -o logs/ --split-time 1h --disk-quota 20GB\n"
    "  rocinante record -o 'crash-%n.mcap' --ring 30s --ring-after 5s --ring-on "
    "'event=*collision*'\n";

/// SIGHUP requests a new piece, except when it reports that the terminal is gone.
class Terminal {
 public:
  Terminal() : was_there_(isThere()) {}
  bool hungUp() const { return was_there_ && cli::signalCount(SIGHUP) > 0 && !isThere(); }

 private:
  static bool isThere() {
    const int file = ::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (file >= 0) ::close(file);
    return file >= 0;
  }
  bool was_there_;
};

void tellReady(const RecordOptions& options, const std::vector<std::string>& endpoints,
               const std::string& log) {
  if (options.ring) {
    cli::tell(fmt::format("recording {} into memory, the last {} s, for {}\n",
                          fmt::join(endpoints, " "), secondsText(options.ring->span),
                          log.empty() ? std::string(kDefaultRecordName) : log));
  } else {
    cli::tell(fmt::format("recording {} to {}\n", fmt::join(endpoints, " "), log));
  }
  if (options.start_on.empty()) return;
  std::vector<std::string> waits;
  for (const Condition& each : options.start_on) waits.push_back(each.text());
  cli::tell(fmt::format("waiting for {}\n", fmt::join(waits, " or ")));
}

RecordEvents eventsFor(const RecordArguments& arguments, const RecordOptions& options,
                       std::optional<Nanoseconds> status_period, cli::StatusLine& line) {
  RecordEvents events;
  const auto terminal = std::make_shared<Terminal>();
  events.stop_requested = [terminal] { return cli::stopRequested() || terminal->hungUp(); };
  events.seams_requested = [terminal] {
    return terminal->hungUp() ? 0U : cli::signalCount(SIGHUP);
  };
  events.triggers_requested = [] { return cli::signalCount(SIGUSR1); };
  events.note = [&line, quiet = arguments.quiet](const NoteBox::Note& note) {
    if (quiet && !note.is_trouble) return;
    line.clear();
    if (note.is_trouble) {
      cli::warn(note.text);
    } else {
      cli::tell(note.text + "\n");
    }
  };
  if (arguments.quiet) return events;
  events.ready = [&](const std::vector<std::string>& endpoints, const std::string& log) {
    tellReady(options, endpoints, log);
  };
  if (!line.isVisible() && !status_period) return events;
  events.progress = [&line, status_period, status = RecordStatus(),
                     reported_at = Nanoseconds(0)](const RecordProgress& now) mutable {
    const std::string text = status.text(now);
    if (status_period && now.elapsed - reported_at >= *status_period) {
      reported_at = now.elapsed;
      line.clear();
      cli::tell(text + "\n");
    }
    line.show(text);
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
  // The warnings were printed when they occurred.
  if (!summary.warnings.empty()) exit = cli::Exit::no;
  for (const InputAccount& each : summary.inputs) {
    if (each.subscription && !each.subscription->accepted_after) {
      no(each.endpoint + ": " + each.subscription->trouble);
    }
  }
  if (summary.packets < arguments.min_packets) {
    no(fmt::format("recorded {}, fewer than --min-packets {}", countText(summary.packets, "packet"),
                   arguments.min_packets));
  }
  if (arguments.max_loss && summary.lost() > *arguments.max_loss) {
    no(fmt::format("lost {}, more than --max-loss {}", countText(summary.lost(), "packet"),
                   *arguments.max_loss));
  }
  return exit;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app(
      "Records UDP: every datagram that arrives, with the kernel's own arrival time,\n"
      "and an account of anything lost. Ctrl-C ends the recording cleanly.",
      "rocinante-record");
  RecordArguments arguments;
  addRecordArguments(app, arguments);

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    const Result<RecordOptions> options = readRecordArguments(arguments);
    if (!options) return options.error();
    const Result<std::optional<Nanoseconds>> status_period = readStatusPeriod(arguments);
    if (!status_period) return status_period.error();
    cli::catchStopSignals();
    cli::countSignal(SIGHUP);
    cli::countSignal(SIGUSR1);
    // A reader that closes the pipe early (`| head`) must not end the recording.
    ::signal(SIGPIPE, SIG_IGN);
    cli::StatusLine line(!arguments.quiet);
    const Result<RecordSummary> summary =
        record(*options, eventsFor(arguments, *options, *status_period, line));
    line.clear();
    if (!summary) return summary.error();
    if (arguments.json) {
      cli::say(summaryJson(*summary));
    } else if (!arguments.quiet) {
      cli::say(cli::wrapped(summaryText(*summary) + "\n", cli::outputTerminal().columns, 2));
    }
    return judge(arguments, *summary);
  });
}
