#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/cli/program.h"
#include "core/duration_text.h"
#include "core/net/udp_socket.h"
#include "recorder/spy/spy.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante spy                          what this machine's own group says, live\n"
    "  rocinante spy :19960                   what is sent to port 19960\n"
    "  rocinante spy --duration 5s            a report after five seconds\n"
    "  rocinante spy --duration 5s --json     the same for scripts\n";

constexpr Nanoseconds kRefresh = std::chrono::milliseconds(250);

struct Arguments {
  std::vector<std::string> endpoints;
  std::string duration;
  bool json = false;
};

LogTime wallNow() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return LogTime(std::chrono::duration_cast<Nanoseconds>(now));
}

/// The live table: on the terminal's other screen, so that what was there comes back.
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

/// Gives everything that waits at the sockets to the spy.
Status drain(std::vector<UdpReceiver>& receivers, Spy& spy) {
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    // One endpoint under a flood must not keep the others waiting.
    for (int turn = 0; turn < 64; ++turn) {
      const auto batch = receivers[i].receive();
      if (!batch) return batch.error();
      if (batch->empty()) break;
      for (const ReceivedDatagram& each : *batch) {
        spy.add(i, each, LogTime(each.kernel_time.time_since_epoch()));
      }
    }
    const Result<std::uint64_t> dropped = receivers[i].droppedByNow();
    if (!dropped) return dropped.error();
    spy.setDropped(i, *dropped);
  }
  return {};
}

Result<SpyReport> watch(std::vector<UdpReceiver>& receivers, std::optional<Nanoseconds> duration,
                        bool live) {
  std::vector<ListenedEndpoint> listened;
  std::vector<pollfd> waiting;
  std::vector<std::string> names;
  for (const UdpReceiver& each : receivers) {
    listened.push_back({each.endpoint(), each.boundAddress()});
    waiting.push_back({each.fileDescriptor(), POLLIN, 0});
    Endpoint endpoint = each.endpoint();
    endpoint.address.port = each.boundAddress().port;
    names.push_back(endpoint.text());
  }
  Spy spy(listened, wallNow());
  std::optional<Screen> screen;
  if (live) {
    screen.emplace();
  } else {
    fmt::print(stderr, "listening at {}\n", fmt::join(names, " "));
  }
  const auto start = std::chrono::steady_clock::now();
  auto shown = start - kRefresh;
  while (!cli::stopRequested()) {
    const auto now = std::chrono::steady_clock::now();
    if (duration && now - start >= *duration) break;
    if (screen && now - shown >= kRefresh) {
      shown = now;
      screen->show(spy.report(wallNow()));
    }
    ::poll(waiting.data(), waiting.size(), 50);
    if (Status drained = drain(receivers, spy); !drained) return drained.error();
  }
  return spy.report(wallNow());
}

Result<cli::Exit> run(const Arguments& arguments) {
  std::optional<Nanoseconds> duration;
  if (!arguments.duration.empty()) {
    const Result<Nanoseconds> read = parseDuration(arguments.duration);
    if (!read) return read.error();
    if (*read <= Nanoseconds(0)) {
      return Error{ErrorKind::bad_argument, "--duration must be more than nothing",
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
  std::vector<UdpReceiver> receivers;
  for (const Endpoint& endpoint : endpoints) {
    Result<UdpReceiver> receiver = UdpReceiver::open(endpoint);
    if (!receiver) return receiver.error();
    receivers.push_back(std::move(*receiver));
  }
  cli::catchStopSignals();
  const bool live = !arguments.json && ::isatty(STDOUT_FILENO) == 1;
  const Result<SpyReport> report = watch(receivers, duration, live);
  if (!report) return report.error();
  const std::string text = arguments.json ? spyJson(*report, true) + "\n" : spyText(*report, 0, 0);
  fmt::print("{}", text);
  // Nothing that can be read is nothing judged.
  return report->packets > 0 ? cli::Exit::done : cli::Exit::could_not_run;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Listens and says what arrives, without any model: who sends, which sources and devices\n"
      "speak, what is wrong with what they say, and why nothing may move. Live on a terminal.",
      "rocinante-spy");
  Arguments arguments;
  app.add_option("EP", arguments.endpoints,
                 "endpoints to listen at; default " + Endpoint::standard().text())
      ->type_name("");
  app.add_option("--duration", arguments.duration, "report after so long (5s); else at Ctrl-C")
      ->type_name("TIME");
  app.add_flag("--json", arguments.json, "the report as JSON");
  return cli::run(app, argc, argv, kExamples, [&] { return run(arguments); });
}
