// What a relay costs: 2,000 datagrams/s to 100 unicast listeners beside a bare recvmmsg + sendmmsg
// loop, the latency that one hop adds, the greeting of 1,000 devices, and two arms at 60 Hz through
// a line of 28.8 kbit/s. usage: relay_bench [SECONDS]
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "core/net/udp_socket.h"
#include "core/relay/fan_out.h"
#include "core/relay/relay.h"
#include "core/subscription/subscription_text.h"
#include "player/relay/relay_program.h"
#include "tests/support/fault_link.h"

namespace {

using namespace rocinante;
using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr std::size_t kListeners = 100;
constexpr int kRate = 2000;

SteadyTime now() { return std::chrono::steady_clock::now(); }

UdpReceiver anyPort() { return UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value(); }

double cpuOfThread() {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  const auto seconds = [](const timeval& each) {
    return static_cast<double>(each.tv_sec) + static_cast<double>(each.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Sends `rate` datagrams a second, each on its own.
std::uint64_t sendFor(const SocketAddress& to, double seconds) {
  Endpoint endpoint;
  endpoint.address = to;
  UdpSender sender = UdpSender::open(endpoint).value();
  const auto count = static_cast<std::uint64_t>(seconds * kRate);
  const SteadyTime start = now();
  for (std::uint64_t i = 0; i < count; ++i) {
    const Nanoseconds due(static_cast<std::int64_t>(i) * 1'000'000'000 / kRate);
    std::this_thread::sleep_until(start + due);
    const double q = static_cast<double>(i) * 1e-4;
    const std::string text =
        fmt::format("RK1 arm@r {} {:.6f}\njoints arm {:.6f} {:.6f} {:.6f} {:.6f} {:.6f} {:.6f}\n",
                    i + 1, q, q, -q, q / 2, q / 3, q / 4, q / 5);
    if (!sender.send(bytesOf(text))) std::exit(2);
  }
  return count;
}

/// What 100 listeners received, kept small so that they cost as little as they can.
struct Listeners {
  Listeners() {
    for (std::size_t i = 0; i < kListeners; ++i) sockets.push_back(anyPort());
  }
  std::uint64_t drain() {
    std::uint64_t heard = 0;
    for (UdpReceiver& each : sockets) {
      for (;;) {
        const auto batch = each.receive();
        if (!batch || batch->empty()) break;
        for (const ReceivedDatagram& datagram : *batch) {
          heard += textOf(datagram.payload).starts_with("RK1") ? 1 : 0;
        }
      }
    }
    return heard;
  }
  std::vector<UdpReceiver> sockets;
};

struct Outcome {
  double cpu_s = 0;
  std::uint64_t wanted = 0, heard = 0;
};

/// `body(stop)` relays in a thread of its own and returns its CPU time.
Outcome measure(Listeners& listeners, const SocketAddress& to, double seconds,
                const std::function<double(const std::atomic<bool>&)>& body) {
  std::atomic<bool> stop = false;
  Outcome outcome;
  std::thread relay([&] { outcome.cpu_s = body(stop); });
  std::atomic<bool> sent = false;
  std::thread sender([&] {
    outcome.wanted = sendFor(to, seconds) * kListeners;
    sent = true;
  });
  while (!sent) {
    std::this_thread::sleep_for(milliseconds(20));
    outcome.heard += listeners.drain();
  }
  std::this_thread::sleep_for(milliseconds(200));
  outcome.heard += listeners.drain();
  stop = true;
  sender.join();
  relay.join();
  return outcome;
}

/// Receives and sends to everybody, and does nothing else.
double bareLoop(UdpReceiver& from, Listeners& listeners, const std::atomic<bool>& stop) {
  const int out = ::socket(AF_INET, SOCK_DGRAM, 0);
  std::vector<sockaddr_in> addresses;
  for (const UdpReceiver& each : listeners.sockets) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(each.boundAddress().port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    addresses.push_back(address);
  }
  std::vector<mmsghdr> messages(kListeners);
  const double before = cpuOfThread();
  while (!stop) {
    pollfd waiting{from.fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, 50);
    const auto batch = from.receive();
    if (!batch) std::exit(2);
    for (const ReceivedDatagram& each : *batch) {
      iovec piece{const_cast<std::byte*>(each.payload.data()), each.payload.size()};
      for (std::size_t i = 0; i < kListeners; ++i) {
        messages[i].msg_hdr = {&addresses[i], sizeof addresses[i], &piece, 1, nullptr, 0, 0};
      }
      ::sendmmsg(out, messages.data(), kListeners, 0);
    }
  }
  const double cpu = cpuOfThread() - before;
  ::close(out);
  return cpu;
}

/// A free port of this machine, as far as it is still free in a moment.
Endpoint freePort() {
  Endpoint endpoint;
  endpoint.address = anyPort().boundAddress();
  return endpoint;
}

RelayProgramOptions relayOf(const Endpoint& from, const Endpoint& serve) {
  RelayProgramOptions options;
  options.from = {from};
  options.serve = {serve};
  options.name = "bench";
  options.run = "r";
  return options;
}

void subscribe(UdpReceiver& listener, const SocketAddress& relay) {
  const FanOut::Destination to(relay);
  FanOut out(listener.fileDescriptor());
  SubscriptionMessage request;
  request.lease_s = kMaxLeaseSeconds;
  for (int attempt = 0; attempt < 200; ++attempt) {
    const std::string text = subscriptionText(request, kSubscribeBytes);
    out.add(bytesOf(text), to);
    out.flush([] { return true; });
    pollfd waiting{listener.fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, 100);
    const auto batch = listener.receive();
    for (std::size_t i = 0; batch && i < batch->size(); ++i) {
      const auto answer = readSubscription((*batch)[i].payload);
      if (!answer) continue;
      if (answer->verb == SubscriptionVerb::accepted) return;
      request.cookie = answer->cookie;
    }
  }
  std::exit(2);
}

double relayLoop(const RelayProgramOptions& options, const std::atomic<bool>& stop) {
  SendSurroundings surroundings;
  surroundings.stop = [&] { return stop.load(); };
  surroundings.notify = [](std::string_view) {};
  const double before = cpuOfThread();
  const auto report = relayUntilStopped(options, surroundings);
  if (!report) {
    fmt::print(stderr, "{}\n", report.error().text());
    std::exit(2);
  }
  return cpuOfThread() - before;
}

void fanOut(double seconds) {
  Listeners listeners;
  UdpReceiver bare = anyPort();
  const Outcome floor =
      measure(listeners, bare.boundAddress(), seconds,
              [&](const std::atomic<bool>& stop) { return bareLoop(bare, listeners, stop); });
  const Endpoint from = freePort(), serve = freePort();
  Outcome relay;
  {
    std::atomic<bool> stop = false;
    std::thread running([&] { relay.cpu_s = relayLoop(relayOf(from, serve), stop); });
    for (UdpReceiver& each : listeners.sockets) subscribe(each, serve.address);
    listeners.drain();
    std::atomic<bool> sent = false;
    std::thread sender([&] {
      relay.wanted = sendFor(from.address, seconds) * kListeners;
      sent = true;
    });
    while (!sent) {
      std::this_thread::sleep_for(milliseconds(20));
      relay.heard += listeners.drain();
    }
    std::this_thread::sleep_for(milliseconds(200));
    relay.heard += listeners.drain();
    stop = true;
    sender.join();
    running.join();
  }
  for (const auto& [name, each] : {std::pair("bare loop", floor), std::pair("relay", relay)}) {
    fmt::print("{:10} {} of {} datagrams, {:.1f} us of CPU for each of {}\n", name, each.heard,
               each.wanted, each.cpu_s * 1e6 / (seconds * kRate), kRate * seconds);
  }
  fmt::print("relay / bare loop: {:.2f} (bar 1.30), lost {}\n", relay.cpu_s / floor.cpu_s,
             relay.wanted - std::min(relay.wanted, relay.heard));
}

void hop() {
  UdpReceiver listener = anyPort();
  const Endpoint from = freePort();
  RelayProgramOptions options = relayOf(from, freePort());
  options.serve.clear();
  Endpoint to;
  to.address = listener.boundAddress();
  options.to = {to};
  std::atomic<bool> stop = false;
  std::thread running([&] { relayLoop(options, stop); });
  UdpSender through = UdpSender::open(from).value(), direct = UdpSender::open(to).value();
  const auto trip = [&](UdpSender& sender, std::uint64_t number) -> std::optional<double> {
    const std::string text = fmt::format("RK1 arm@r {} -\njoints arm 1 2 3 4 5 6\n", number);
    const SteadyTime start = now();
    if (!sender.send(bytesOf(text))) std::exit(2);
    while (now() - start < milliseconds(200)) {
      const auto batch = listener.receive();
      if (batch && !batch->empty()) return secondsOf(now() - start) * 1e6;
    }
    return std::nullopt;
  };
  while (!trip(through, 0)) {
  }
  std::vector<double> relayed, straight;
  for (std::uint64_t i = 1; i <= 4000; ++i) {
    std::this_thread::sleep_for(microseconds(500));
    if (const auto us = trip(through, i)) relayed.push_back(*us);
    if (const auto us = trip(direct, i)) straight.push_back(*us);
  }
  stop = true;
  running.join();
  std::sort(relayed.begin(), relayed.end());
  std::sort(straight.begin(), straight.end());
  const auto at = [](const std::vector<double>& all, double share) {
    return all.empty() ? 0.0
                       : all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  };
  fmt::print("one hop adds p50 {:.1f} us (bar 60), p99 {:.1f} us\n",
             at(relayed, 0.5) - at(straight, 0.5), at(relayed, 0.99) - at(straight, 0.99));
}

void greeting() {
  Relay relay({"bench", "r", std::chrono::seconds(2)});
  LogTime moment(std::chrono::seconds(1));
  for (int i = 0; i < 1000; ++i) {
    const std::string text = fmt::format(
        "RK1 s@r {} -\nadd d{} m\njoints d{} 0.123456 1.234567 2.345678 0.5 0.25 -1.5\n"
        "pose d{} 1.5 2.5 0.25 0 0 0 1\n",
        i, i, i, i);
    relay.receive(bytesOf(text), moment);
  }
  const Relay::OutputId output = relay.open({}, moment);
  relay.greet(output);
  const SteadyTime start = now();
  std::size_t datagrams = 0;
  // As the program does: what is due when it is due.
  do {
    while (relay.due() > moment + (now() - start)) {
    }
    relay.advance(moment + (now() - start));
    datagrams += relay.outgoing().size();
    relay.clearOutgoing();
  } while (relay.due() != LogTime::max());
  fmt::print("greeting of 1,000 devices: {:.1f} ms in {} datagrams (bar 20)\n",
             secondsOf(now() - start) * 1e3, datagrams);
}

/// How often each of two six-joint arms arrives, and how old what the listener knows of it is. The
/// first joint is the time in seconds at which it was sent.
void slowLine(double seconds) {
  constexpr double kBits = 28'800;
  UdpReceiver listener = anyPort();
  test::FaultLink line(listener.boundAddress().port, {.bits_per_second = kBits});
  const Endpoint from = freePort();
  RelayProgramOptions options = relayOf(from, freePort());
  options.serve.clear();
  options.to = {Endpoint::parse(fmt::format("127.0.0.1:{}", line.port())).value()};
  options.outputs.bytes_per_second = kBits / 8;
  std::atomic<bool> stop = false;
  std::thread running([&] { relayLoop(options, stop); });
  const SteadyTime start = now();
  std::thread sender([&] {
    UdpSender arms = UdpSender::open(from).value();
    for (int i = 0; !stop; ++i) {
      std::this_thread::sleep_until(start + i * microseconds(16'667));
      const double at = secondsOf(now() - start);
      for (const char* const arm : {"arm1", "arm2"}) {
        const std::string text =
            fmt::format("RK1 {}@7f3a {} {:.9f}\njoints {} {:.9f} {:.9f} 0.5 1.25 -0.75 2\n", arm, i,
                        1'700'000'000 + at, arm, at, std::sin(at));
        if (!arms.send(bytesOf(text))) std::exit(2);
      }
    }
  });
  std::array<double, 2> newest{-1, -1};
  std::array<int, 2> arrivals{};
  std::vector<double> ages_ms;
  PacketTextDecoder decoder;
  while (now() - start < std::chrono::duration<double>(seconds)) {
    std::this_thread::sleep_for(milliseconds(1));
    const auto batch = listener.receive();
    for (std::size_t i = 0; batch && i < batch->size(); ++i) {
      const Packet* packet = decoder.decode((*batch)[i].payload);
      for (std::size_t k = 0; packet != nullptr && k < packet->statements.size(); ++k) {
        const Statement& each = packet->statements[k];
        if (each.kind != StatementKind::joints) continue;
        const std::size_t arm = each.name == "arm1" ? 0 : 1;
        arrivals[arm] += each.numbers[0] > newest[arm] ? 1 : 0;
        newest[arm] = each.numbers[0];
      }
    }
    for (const double each : newest) {
      if (each >= 0) ages_ms.push_back((secondsOf(now() - start) - each) * 1e3);
    }
  }
  stop = true;
  sender.join();
  running.join();
  std::sort(ages_ms.begin(), ages_ms.end());
  fmt::print(
      "two arms at 60 Hz through 28.8 kbit/s: {:.1f} and {:.1f} a second (bar 10), age p50 {:.0f} "
      "ms, "
      "p99 {:.0f} ms (bar 200), {} dropped by the line\n",
      arrivals[0] / seconds, arrivals[1] / seconds, ages_ms[ages_ms.size() / 2],
      ages_ms[ages_ms.size() * 99 / 100], line.counts().overflowed);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 5;
  greeting();
  hop();
  slowLine(seconds);
  fanOut(seconds);
}
