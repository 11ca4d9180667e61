#include "recorder/capture/record_arguments.h"

#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_or_log.h"
#include "core/cli/load_progress.h"
#include "core/cli/no_wait.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/live/received_decoder.h"
#include "core/recording/compression_text.h"
#include "core/recording/record_path.h"

namespace rocinante {
namespace {

Result<LoadedCell> loadCell(const RecordArguments& arguments) {
  CellOptions search;
  static_cast<ModelSearch&>(search) = arguments;
  search.parallel = cli::workerThreads();
  if (!arguments.quiet) search.progress = cli::loadProgress(arguments.cell);
  auto cell = collectCellOrLog(arguments.cell, search);
  if (!cell) return cell.error();
  if (!arguments.quiet) {
    for (const std::string& warning : bundleWarnings(*cell)) cli::warn(warning);
  }
  LoadedCell loaded;
  loaded.cell = std::make_shared<const CellBundle>(std::move(*cell));
  if (!arguments.decoders.empty()) return loaded;
  search.geometry = false;
  search.progress = {};
  const Result<Cell> named = loadCellOrLog(arguments.cell, search);
  if (!named) return named.error();
  auto decoders = decodersFor("", *named);
  if (!decoders) return decoders.error();
  loaded.decoders = std::move(*decoders);
  return loaded;
}

Result<Cell> loadWatched(const RecordArguments& arguments) {
  CellOptions search;
  static_cast<ModelSearch&>(search) = arguments;
  search.parallel = cli::workerThreads();
  if (!arguments.quiet) search.progress = cli::loadProgress(arguments.session.watch);
  return loadCellOrLog(arguments.session.watch, search);
}

}  // namespace

void addRecordArguments(cli::CommandLine app, RecordArguments& arguments) {
  app.addOption("EP", arguments.endpoints,
                "endpoints to listen on: udp://HOST:PORT, HOST:PORT, :PORT, or a multicast\n"
                "group; interfaces to watch: pcap://eth0?filter=EXPR; or one capture file:\n"
                "pcap://./FILE; default " +
                    Endpoint::standard().text())
      .valueName("");
  app.addOption("--allow", arguments.allow,
                "record only senders in this network (10.0.0.0/8); may be repeated")
      .valueName("CIDR")
      .oneEach();
  app.addOption("--trust", arguments.trust,
                "record only what is signed with a key of this file (rocinante key)")
      .valueName("FILE");
  app.addOption("--tee", arguments.tees,
                "forward everything received to this endpoint; may be repeated")
      .valueName("EP")
      .oneEach();
  app.addOption("--wait-interface", arguments.wait_interface,
                "wait at most TIME for network interfaces that do not exist yet")
      .valueName("TIME");
  cli::addNoWait(app, arguments.no_wait);
  app.addOption("-o,--output", arguments.output,
                "the log: a file, a folder or a name with %Y%m%dT%H%M%S (UTC) and %n\n"
                "(the piece's number); default session-%Y%m%dT%H%M%SZ.mcap")
      .valueName("LOG");
  app.addOption("--cell", arguments.cell,
                "attach this cell and every file it names: the log then replays alone")
      .valueName("CELL");
  app.addOption("--decoders", arguments.decoders,
                "decode what is not packet text as this file declares, and attach the file;\n"
                "default: the one that the cell names")
      .valueName("FILE");
  cli::addSearchOptions(app, arguments);
  app.addOption("--duration", arguments.duration,
                "end TIME (12.5s, 1m30s) after receiving began, or after the first datagram\n"
                "that meets --start-on")
      .valueName("TIME");
  app.addOption("--max-packets", arguments.max_packets, "end after exactly N packets")
      .valueName("N")
      .positive();
  app.addOption("--min-packets", arguments.min_packets, "exit 1 when fewer were recorded")
      .valueName("N");
  app.addOption("--max-loss", arguments.max_loss, "exit 1 when more were lost; default unlimited")
      .valueName("N");
  app.addOption("--compression", arguments.compression, "zstd, zstd:LEVEL (1 to 22) or none")
      .valueName("KIND")
      .showDefault();
  app.addOption("--sync", arguments.sync, "a crash loses at most about the last TIME")
      .valueName("TIME")
      .showDefault();
  addSessionArguments(app, arguments.session);
  app.addOption("--status", arguments.status, "print a status line every TIME").valueName("TIME");
  app.addFlag("--force", arguments.force, "replace an existing log");
  app.addFlag("--json", arguments.json, "print the summary as JSON");
  app.addFlag("--quiet", arguments.quiet, "print nothing but errors (and --json)");
}

Result<std::optional<Nanoseconds>> readStatusPeriod(const RecordArguments& arguments) {
  if (arguments.status.empty()) return std::optional<Nanoseconds>();
  const Result<Nanoseconds> period = readSpan(arguments.status, "--status");
  if (!period) return period.error();
  return std::optional(*period);
}

Result<RecordOptions> readRecordArguments(const RecordArguments& arguments) {
  RecordOptions options;
  for (const std::string& text : arguments.endpoints) {
    const Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    options.endpoints.push_back(*endpoint);
  }
  if (options.endpoints.empty()) options.endpoints.push_back(Endpoint::standard());
  Result<AddressFilter> allow = AddressFilter::of(arguments.allow);
  if (!allow) return allow.error();
  options.allow = std::move(*allow);
  Result<std::shared_ptr<TrustJudge>> trust = TrustJudge::open(arguments.trust);
  if (!trust) return trust.error();
  options.trust = std::move(*trust);
  for (const std::string& text : arguments.tees) {
    const Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    options.tees.push_back(*endpoint);
  }
  cli::applyNoWait(arguments.no_wait, options.endpoints);
  cli::applyNoWait(arguments.no_wait, options.tees);
  if (!arguments.wait_interface.empty()) {
    const Result<Nanoseconds> longest = readSpan(arguments.wait_interface, "--wait-interface");
    if (!longest) return longest.error();
    options.wait_interface = *longest;
  }
  if (!arguments.duration.empty()) {
    const Result<Nanoseconds> duration = readSpan(arguments.duration, "--duration");
    if (!duration) return duration.error();
    options.duration = *duration;
  }
  const Result<Nanoseconds> sync = readSpan(arguments.sync, "--sync");
  if (!sync) return sync.error();
  options.writing.sync = *sync;
  Status done = readCompression(arguments.compression, options.writing);
  if (!done) return done.error();
  options.writing.overwrite = arguments.force;
  options.max_packets = arguments.max_packets;
  if (arguments.output == "-") {
    return Error{ErrorKind::bad_argument,
                 "a log is written to a file, not to standard output: name one (./- for this name)",
                 "-o -"};
  }
  const auto path = recordPath(arguments.output, WallTime{});
  if (!path) return path.error();
  options.log = arguments.output;
  if (Status read = readSessionArguments(arguments.session, options); !read) return read.error();
  if (!arguments.decoders.empty()) {
    auto decoders = decode::readDecoders(arguments.decoders);
    if (!decoders) return decoders.error();
    options.decoders = std::move(*decoders);
  }
  if (!arguments.cell.empty()) {
    options.load_cell = [&arguments] { return loadCell(arguments); };
  }
  if (!arguments.session.watch.empty()) {
    options.load_watched = [&arguments] { return loadWatched(arguments); };
  }
  if (arguments.cell.empty() && arguments.session.watch.empty()) {
    if (const std::vector<std::string> words = cli::searchWords(arguments); !words.empty()) {
      return Error{ErrorKind::bad_argument, words.front() + " needs --cell", {}};
    }
  }
  return options;
}

}  // namespace rocinante
