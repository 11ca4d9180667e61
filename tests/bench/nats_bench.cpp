// Datagrams through Debian's nats-server on loopback, with the source and the sink that programs
// use: at the rate of the bar, 60,000/s, then as fast as they go. Loss, the share of a processor
// that each end takes, and the age of a datagram when it arrives.
// usage: nats_bench [SECONDS=10] [RATE=60000]
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/transport/open_sink.h"
#include "core/transport/open_source.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;
using Clock = std::chrono::steady_clock;

/// User and system time of another process.
double processSeconds(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  double ticks = 0;
  for (int field = 1; field <= 15 && file >> word; ++field) {
    if (field >= 14) ticks += std::stod(word);
  }
  return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// The moment of sending, which the receiver subtracts.
std::string packetNow(std::uint64_t number) {
  const auto now = Clock::now().time_since_epoch() / std::chrono::microseconds(1);
  return fmt::format("RK1 arm@bench {} -\njoints arm 0.1 0.2 0.3 0.4 0.5 0.6\nevent \"{:020}\"\n",
                     number, now);
}

std::int64_t sentAt(ByteView payload) {
  const std::string_view text = textOf(payload);
  return std::strtoll(text.substr(text.rfind('"') - 20).data(), nullptr, 10);
}

struct Receiver {
  std::unique_ptr<DatagramSource> source;
  std::atomic<std::uint64_t> received{0};
  std::atomic<bool> stop{false};
  std::vector<std::int64_t> ages_us{};
  std::thread thread{};

  void start() {
    thread = std::thread([this] {
      while (!stop) {
        pollfd waiting{source->fileDescriptor(), POLLIN, 0};
        ::poll(&waiting, 1, 20);
        const auto batch = source->receive();
        if (!batch) {
          fmt::print(stderr, "{}\n", batch.error().text());
          return;
        }
        const auto now = Clock::now().time_since_epoch() / std::chrono::microseconds(1);
        for (const ReceivedDatagram& each : *batch) ages_us.push_back(now - sentAt(each.payload));
        received += batch->size();
      }
    });
  }
};

int measure(const std::string& endpoint, pid_t server, std::uint64_t rate, int seconds) {
  const Endpoint at = Endpoint::parse(endpoint).value();
  auto source = openSource(at);
  auto sink = openSink(at);
  if (!source || !sink) {
    fmt::print(stderr, "{}\n", source ? sink.error().text() : source.error().text());
    return 2;
  }
  Receiver receiver{std::move(*source)};
  receiver.ages_us.reserve(20'000'000);
  receiver.start();
  const auto start = Clock::now();
  const double ours = bench::processSeconds();
  const double servers = processSeconds(server);
  std::uint64_t sent = 0;
  const auto run = std::chrono::seconds(seconds);
  for (auto now = start; now - start < run; now = Clock::now()) {
    const auto due =
        rate == 0 ? sent + 64
                  : static_cast<std::uint64_t>(std::chrono::duration<double>(now - start).count() *
                                               static_cast<double>(rate));
    for (; sent < due; ++sent) {
      const std::string text = packetNow(sent);
      const ByteView payload = bytesOf(text);
      if (Status done = (*sink)->send({&payload, 1}); !done) {
        fmt::print(stderr, "{}\n", done.error().text());
        return 2;
      }
    }
    if (rate > 0) std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  (void)(*sink)->flush();
  const double span = std::chrono::duration<double>(Clock::now() - start).count();
  const auto give_up = Clock::now() + std::chrono::seconds(20);
  while (receiver.received + receiver.source->dropped() < sent && Clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  receiver.stop = true;
  receiver.thread.join();
  auto& ages = receiver.ages_us;
  std::sort(ages.begin(), ages.end());
  const auto at_share = [&](double share) {
    return ages.empty()
               ? 0
               : ages[static_cast<std::size_t>(share * static_cast<double>(ages.size() - 1))];
  };
  fmt::print(
      "{:>9} | {:9.0f}/s | {:9} sent | {:6} lost | both ends {:5.2f} cores | nats-server {:5.2f} "
      "cores"
      " | age p50 {} us, p99 {} us\n",
      rate == 0 ? "unbounded" : fmt::format("{}/s", rate), static_cast<double>(sent) / span, sent,
      sent - receiver.received, (bench::processSeconds() - ours) / span,
      (processSeconds(server) - servers) / span, at_share(0.5), at_share(0.99));
  return sent == receiver.received ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const int seconds = argc > 1 ? std::atoi(argv[1]) : 10;
  const auto rate = static_cast<std::uint64_t>(argc > 2 ? std::atoi(argv[2]) : 60'000);
  const std::string port = std::to_string(20'000 + ::getpid() % 20'000);
  const pid_t server = ::fork();
  if (server == 0) {
    ::execlp("nats-server", "nats-server", "-a", "127.0.0.1", "-p", port.c_str(), "-l", "/dev/null",
             nullptr);
    ::_exit(127);
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  int status = 0;
  if (::waitpid(server, &status, WNOHANG) == server) {
    fmt::print(stderr, "skipped: no nats-server (package nats-server)\n");
    return 77;
  }
  const std::string endpoint = "nats://127.0.0.1:" + port + "/bench";
  int result = measure(endpoint, server, rate, seconds);
  // The bar is at the rate: without one, senders outrun any receiver, which is shown, not judged.
  if (result == 0) (void)measure(endpoint, server, 0, std::min(seconds, 5));
  ::kill(server, SIGTERM);
  ::waitpid(server, &status, 0);
  return result;
}
