#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>

#include "core/bundle/attached_cell.h"
#include "core/cli/program.h"
#include "core/duration_text.h"
#include "recorder/record.h"
#include "recorder/record_path.h"
#include "recorder/record_report.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante record                               what this machine's own group says\n"
    "  rocinante record :19960 -o cell.mcap           whatever is sent to port 19960\n"
    "  rocinante record '239.1.2.3:5000?interface=eth0' [::]:5000 --duration 1m\n"
    "  rocinante record --cell demo.cell.toml -o demo.mcap\n"
    "  rocinante record -o logs/ --min-packets 1 --max-loss 0 --json\n";

struct Arguments {
  std::vector<std::string> endpoints;
  std::string output;
  std::string cell;
  std::vector<std::filesystem::path> search;
  bool search_environment = false;
  std::string duration;
  std::optional<std::uint64_t> max_packets, max_loss;
  std::uint64_t min_packets = 0;
  std::string compression = "zstd";
  std::string sync = "100ms";
  bool force = false;
  bool json = false;
  bool quiet = false;
};

Status readCompression(std::string_view text, LogWriterOptions& options) {
  if (text == "none") {
    options.compression = LogWriterOptions::Compression::none;
    return {};
  }
  if (text == "zstd") return {};
  if (text.starts_with("zstd:")) {
    const std::string_view level = text.substr(5);
    const char* end = level.data() + level.size();
    const auto [used, fault] = std::from_chars(level.data(), end, options.zstd_level);
    const bool whole = fault == std::errc() && used == end;
    if (whole && options.zstd_level >= 1 && options.zstd_level <= 22) return {};
  }
  return Error{ErrorKind::bad_argument, "--compression is none, zstd or zstd:1 to zstd:22",
               std::string(text)};
}

Result<Nanoseconds> readPositive(const std::string& text, const char* option) {
  const Result<Nanoseconds> duration = parseDuration(text);
  if (!duration) return duration.error();
  if (*duration <= Nanoseconds(0)) {
    return Error{ErrorKind::bad_argument, std::string(option) + " must be more than nothing", text};
  }
  return *duration;
}

/// The cell with all its files: before a socket is bound, so that a recording never begins without
/// what it was to carry.
Status readCell(const Arguments& arguments, RecordOptions& options) {
  CellOptions search;
  search.search = arguments.search;
  search.search_environment = arguments.search_environment;
  if (arguments.cell.empty()) {
    if (search.search.empty() && !search.search_environment) return {};
    return Error{ErrorKind::bad_argument, "--search and --search-env go with --cell", {}};
  }
  auto cell = collectCellOrLog(arguments.cell, search);
  if (!cell) return cell.error();
  if (!arguments.quiet) {
    for (const std::string& warning : bundleWarnings(*cell)) cli::warn(warning);
  }
  options.cell = std::make_shared<const CellBundle>(std::move(*cell));
  return {};
}

Result<RecordOptions> readOptions(const Arguments& arguments) {
  RecordOptions options;
  for (const std::string& text : arguments.endpoints) {
    const Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    options.endpoints.push_back(*endpoint);
  }
  if (options.endpoints.empty()) options.endpoints.push_back(Endpoint::standard());
  if (!arguments.duration.empty()) {
    const Result<Nanoseconds> duration = readPositive(arguments.duration, "--duration");
    if (!duration) return duration.error();
    options.duration = *duration;
  }
  const Result<Nanoseconds> sync = readPositive(arguments.sync, "--sync");
  if (!sync) return sync.error();
  options.writing.sync = *sync;
  Status done = readCompression(arguments.compression, options.writing);
  if (!done) return done.error();
  options.writing.overwrite = arguments.force;
  options.max_packets = arguments.max_packets;
  const auto now = std::chrono::system_clock::now();
  const auto path = recordPath(arguments.output, now);
  if (!path) return path.error();
  options.log = *path;
  if (Status read = readCell(arguments, options); !read) return read.error();
  return options;
}

RecordEvents eventsFor(const Arguments& arguments, const RecordOptions& options) {
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

cli::Exit judge(const Arguments& arguments, const RecordSummary& summary) {
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
  Arguments arguments;
  app.add_option("EP", arguments.endpoints,
                 "endpoints to listen at: udp://HOST:PORT, HOST:PORT, :PORT, or a multicast\n"
                 "group; default " +
                     Endpoint::standard().text())
      ->type_name("");
  app.add_option("-o,--output", arguments.output,
                 "the log: a file, a folder or a name with %Y%m%dT%H%M%S (UTC); default\n"
                 "session-%Y%m%dT%H%M%SZ.mcap")
      ->type_name("LOG");
  app.add_option("--cell", arguments.cell,
                 "attach this cell and every file it names: the log then replays alone")
      ->type_name("CELL");
  app.add_option("--search", arguments.search, "a folder in which its models are looked for")
      ->type_name("DIR")
      ->allow_extra_args(false);
  app.add_flag("--search-env", arguments.search_environment,
               "also in ROCINANTE_PATH, AMENT_PREFIX_PATH, ROS_PACKAGE_PATH");
  app.add_option("--duration", arguments.duration, "end after so long (12.5s, 1m30s)")
      ->type_name("TIME");
  app.add_option("--max-packets", arguments.max_packets, "end after exactly N packets")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  app.add_option("--min-packets", arguments.min_packets, "exit 1 when fewer were recorded")
      ->type_name("N");
  app.add_option("--max-loss", arguments.max_loss, "exit 1 when more were lost; default unlimited")
      ->type_name("N");
  app.add_option("--compression", arguments.compression, "zstd, zstd:LEVEL (1 to 22) or none")
      ->type_name("KIND")
      ->capture_default_str();
  app.add_option("--sync", arguments.sync, "a crash loses at most about the last so long")
      ->type_name("TIME")
      ->capture_default_str();
  app.add_flag("--force", arguments.force, "replace an existing log");
  app.add_flag("--json", arguments.json, "print the summary as JSON");
  app.add_flag("--quiet", arguments.quiet, "print nothing but errors (and --json)");

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    const Result<RecordOptions> options = readOptions(arguments);
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
