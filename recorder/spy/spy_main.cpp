#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/base/duration_text.h"
#include "core/cli/no_wait.h"
#include "core/cli/program.h"
#include "core/cli/terminal.h"
#include "core/transport/open_source.h"
#include "recorder/spy/spy.h"
#include "recorder/spy/spy_json.h"
#include "recorder/spy/spy_text.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante spy                          the local multicast group, live\n"
    "  rocinante spy :19960                   everything sent to port 19960\n"
    "  rocinante spy subscribe://hall:19961   what a relay forwards\n"
    "  rocinante spy pcap://eth0              traffic that other programs receive\n"
    "  rocinante spy pcap://./cell.pcapng     the contents of a capture file\n"
    "  rocinante spy :49152 --decoders robot.decoders.toml   while you write a decoder\n"
    "  rocinante spy --duration 5s            a report after five seconds\n"
    "  rocinante spy --duration 5s --json     the same for scripts\n";

constexpr Nanoseconds kRefresh = std::chrono::milliseconds(250);

using Decoders = std::shared_ptr<const decode::DecoderSet>;

struct Arguments {
  std::vector<std::string> endpoints;
  std::vector<std::string> allow;
  std::string trust;
  std::string decoders;
  std::string duration;
  bool no_wait = false;
  bool json = false;
};

LogTime wallNow() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return LogTime(std::chrono::duration_cast<Nanoseconds>(now));
}

/// Shows the live table on the terminal's alternate screen, so that the previous contents come
/// back.
class Screen {
 public:
  Screen() { write("\x1b[?1049h\x1b[?25l"); }
  ~Screen() { write("\x1b[?25h\x1b[?1049l"); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void show(const SpyReport& report) {
    winsize size{};
    const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
    const std::size_t lines = known ? size.ws_row : 24;
    const std::size_t columns = known ? size.ws_col : 80;
    // Five parts share the screen; the longest that fits is shown.
    std::string text;
    for (std::size_t rows = lines; rows > 0; rows = rows * 3 / 4) {
      text = spyText(report, rows, columns);
      if (static_cast<std::size_t>(std::ranges::count(text, '\n')) <= lines || rows == 1) break;
    }
    std::string out = "\x1b[H";
    std::size_t line = 1;
    for (std::size_t at = 0; at < text.size() && line < lines; ++line) {
      const std::size_t end = text.find('\n', at);
      out += text.substr(at, end - at) + "\x1b[K\r\n";
      at = end + 1;
    }
    write(out + "\x1b[J");
  }

 private:
  static void write(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
  }
};

/// Passes all waiting datagrams of the sources to the spy.
Status drain(const Sources& sources, Spy& spy) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    DatagramSource& source = *sources[i];
    // One endpoint under a flood must not keep the others waiting.
    for (int turn = 0; turn < 64; ++turn) {
      const auto batch = source.receive();
      if (!batch) return batch.error();
      if (batch->empty()) break;
      for (const ReceivedDatagram& each : *batch) {
        spy.add(i, each, LogTime(each.kernel_time.time_since_epoch()));
      }
    }
    const Result<std::uint64_t> dropped = source.droppedByNow();
    if (!dropped) return dropped.error();
    spy.setDropped(i, *dropped, source.counts(), source.leftOut());
  }
  return {};
}

/// Reads a capture file on its own time line.
Result<SpyReport> read(DatagramSource& source, const std::vector<ListenedEndpoint>& listened,
                       const Decoders& decoders) {
  std::optional<Spy> spy;
  LogTime last{};
  while (!source.ended() && !cli::stopRequested()) {
    const auto batch = source.receive();
    // The part before a break still gets a report.
    if (!batch && !spy) return batch.error();
    if (!batch) {
      cli::warn(batch.error().text());
      break;
    }
    for (const ReceivedDatagram& each : *batch) {
      const LogTime time(each.kernel_time.time_since_epoch());
      if (!spy) spy.emplace(listened, time, decoders);
      last = std::max(last, time);
      spy->add(0, each, time);
    }
  }
  if (!spy) spy.emplace(listened, last, decoders);
  spy->setDropped(0, 0, source.counts(), source.leftOut());
  return spy->report(last);
}

Result<SpyReport> watch(const Sources& sources, const Decoders& decoders,
                        std::optional<Nanoseconds> duration, bool live) {
  const std::vector<ListenedEndpoint> listened = listenedEndpoints(sources);
  if (!listened[0].endpoint.file.empty()) return read(*sources[0], listened, decoders);
  Spy spy(listened, wallNow(), decoders);
  std::optional<Screen> screen;
  // The screen would cover it.
  for (const auto& each : sources) {
    if (const auto news = each->maintain()) cli::warn(*news);
  }
  if (live) {
    screen.emplace();
  } else {
    std::vector<std::string> names;
    for (const auto& each : sources) names.push_back(boundText(*each));
    cli::tell(fmt::format("listening on {}\n", fmt::join(names, " ")));
  }
  const auto start = std::chrono::steady_clock::now();
  auto shown = start - kRefresh;
  std::vector<pollfd> waiting(sources.size());
  while (!cli::stopRequested()) {
    const auto now = std::chrono::steady_clock::now();
    if (duration && now - start >= *duration) break;
    if (screen && now - shown >= kRefresh) {
      shown = now;
      screen->show(spy.report(wallNow()));
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const auto news = sources[i]->maintain();
      if (news && !screen) cli::warn(*news);
      waiting[i] = {sources[i]->fileDescriptor(), POLLIN, 0};
    }
    ::poll(waiting.data(), waiting.size(), 50);
    if (Status drained = drain(sources, spy); !drained) return drained.error();
  }
  return spy.report(wallNow());
}

Result<cli::Exit> run(const Arguments& arguments) {
  std::optional<Nanoseconds> duration;
  if (!arguments.duration.empty()) {
    const Result<Nanoseconds> read = parseDuration(arguments.duration);
    if (!read) return read.error();
    if (*read <= Nanoseconds(0)) {
      return Error{ErrorKind::bad_argument, "--duration must be greater than zero",
                   arguments.duration};
    }
    duration = *read;
  }
  std::vector<Endpoint> endpoints;
  for (const std::string& text : arguments.endpoints) {
    const Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    endpoints.push_back(*endpoint);
  }
  if (endpoints.empty()) endpoints.push_back(Endpoint::standard());
  cli::applyNoWait(arguments.no_wait, endpoints);
  InputOptions options;
  const Result<AddressFilter> allow = AddressFilter::of(arguments.allow);
  if (!allow) return allow.error();
  options.allow = *allow;
  Result<std::shared_ptr<TrustJudge>> trust = TrustJudge::open(arguments.trust);
  if (!trust) return trust.error();
  options.trust = std::move(*trust);
  Decoders decoders;
  if (!arguments.decoders.empty()) {
    auto read = decode::readDecoders(arguments.decoders);
    if (!read) return read.error();
    decoders = std::move(*read);
  }
  const Result<Sources> sources = openSources(endpoints, options);
  if (!sources) return sources.error();
  cli::catchStopSignals();
  const bool live = !arguments.json && ::isatty(STDOUT_FILENO) == 1;
  const Result<SpyReport> report = watch(*sources, decoders, duration, live);
  if (!report) return report.error();
  for (const auto& each : *sources) {
    if (const auto text = neverAcceptedText(*each)) cli::warn(*text);
  }
  const std::string text =
      arguments.json ? spyJson(*report, true) : spyText(*report, 0, cli::outputTerminal().columns);
  cli::say(text);
  // Without a readable packet nothing was judged.
  return report->packets > 0 ? cli::Exit::done : cli::Exit::could_not_run;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app(
      "Listens and reports what arrives, without a model: who sends, which sources and devices\n"
      "are active, what is wrong with their packets, and why nothing moves. Live on a terminal.",
      "rocinante-spy");
  Arguments arguments;
  app.addOption("EP", arguments.endpoints,
                "endpoints to listen on, interfaces to watch (pcap://eth0) or a capture file\n"
                "(pcap://./FILE); default " +
                    Endpoint::standard().text())
      .valueName("");
  rocinante::cli::addNoWait(app, arguments.no_wait);
  app.addOption("--allow", arguments.allow,
                "accept only senders in this network (10.0.0.0/8); may be repeated")
      .valueName("CIDR")
      .oneEach();
  app.addOption("--trust", arguments.trust,
                "accept only what is signed with a key of this file (rocinante key)")
      .valueName("FILE");
  app.addOption("--decoders", arguments.decoders,
                "decode what is not packet text as this file declares, and show its fields")
      .valueName("FILE");
  app.addOption("--duration", arguments.duration, "report after TIME (5s); default at Ctrl-C")
      .valueName("TIME");
  app.addFlag("--json", arguments.json, "the report as JSON");
  return cli::run(app, argc, argv, kExamples, [&] { return run(arguments); });
}
