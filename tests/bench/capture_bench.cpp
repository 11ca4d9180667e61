// How many datagrams a second are captured without loss: rocinante's recorder beside a bare
// recvmmsg loop that keeps nothing, from one sender that offers both the same rates.
// usage: capture_bench [SECONDS_A_RATE [RATE...]]
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/udp.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "core/net/udp_socket.h"
#include "recorder/capture/record.h"

namespace {

using namespace rocinante;
using std::chrono::milliseconds;

constexpr std::size_t kPayloadBytes = 100;
constexpr std::size_t kSegments = 40;
constexpr std::size_t kSequenceDigits = 10;
/// Behind "RK1 arm@r1 " and the number.
constexpr std::size_t kSequenceEnd = 11 + kSequenceDigits;

SteadyTime now() { return std::chrono::steady_clock::now(); }

double cpuSeconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& each) {
    return static_cast<double>(each.tv_sec) + static_cast<double>(each.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Six joints in packet text, padded to one length: UDP_SEGMENT cuts a send into equal datagrams.
std::string payloadOf(std::uint64_t sequence) {
  const double q = static_cast<double>(sequence % 100'000) * 1e-5;
  std::string text =
      fmt::format("RK1 arm@r1 {:0{}} -\njoints arm {:.5f} {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}",
                  sequence, kSequenceDigits, q, q / 2, 1 - q, q * q, -q, q / 3);
  text.resize(kPayloadBytes, ' ');
  return text;
}

/// Bursts that are ready but for their sequence numbers: to write out six numbers for each datagram
/// would take the sender longer than to send it.
class Bursts {
 public:
  Bursts() {
    for (std::size_t i = 0; i < kBursts * kSegments; ++i) text_ += payloadOf(i);
  }
  /// kSegments datagrams, the first with this number.
  std::string_view from(std::uint64_t sequence) {
    char* const burst = text_.data() + sequence / kSegments % kBursts * kSegments * kPayloadBytes;
    for (std::size_t i = 0; i < kSegments; ++i) {
      char* digit = burst + i * kPayloadBytes + kSequenceEnd;
      for (std::uint64_t rest = sequence + i; rest > 0; rest /= 10) {
        *--digit = static_cast<char>('0' + rest % 10);
      }
    }
    return {burst, kSegments * kPayloadBytes};
  }

 private:
  static constexpr std::size_t kBursts = 250;
  std::string text_;
};

/// Sends `rate` datagrams a second in bursts of a millisecond; many datagrams in one system call.
/// Answers how many were sent.
std::uint64_t sendAt(const SocketAddress& to, std::uint64_t rate, Nanoseconds duration) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  const int segment = kPayloadBytes;
  ::setsockopt(socket, IPPROTO_UDP, UDP_SEGMENT, &segment, sizeof segment);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(to.port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address);
  Bursts bursts;
  std::uint64_t sent = 0;
  std::uint64_t skipped = 0;
  const SteadyTime start = now();
  for (SteadyTime moment = start; moment - start < duration; moment = now()) {
    const auto due = static_cast<std::uint64_t>(
        std::chrono::duration<double>(moment - start).count() * static_cast<double>(rate));
    // A sender that was held up does not make up for more than 20 ms: that would be another rate.
    skipped += due > sent + skipped + rate / 50 ? due - sent - skipped - rate / 50 : 0;
    while (sent + skipped + kSegments <= due) {
      const std::string_view burst = bursts.from(sent);
      if (::send(socket, burst.data(), burst.size(), 0) < 0) break;
      sent += kSegments;
    }
    std::this_thread::sleep_for(milliseconds(1));
  }
  ::close(socket);
  return sent;
}

/// A sender of its own process; `finish` waits for it and gives the count.
struct SenderProcess {
  SenderProcess(const SocketAddress& to, std::uint64_t rate, Nanoseconds duration) {
    if (::pipe(ends) != 0) std::exit(2);
    pid = ::fork();
    if (pid != 0) return;
    const std::uint64_t sent = sendAt(to, rate, duration);
    ::_exit(::write(ends[1], &sent, sizeof sent) == sizeof sent ? 0 : 2);
  }
  std::uint64_t finish() {
    std::uint64_t sent = 0;
    if (::read(ends[0], &sent, sizeof sent) != sizeof sent) std::exit(2);
    ::waitpid(pid, nullptr, 0);
    ::close(ends[0]);
    ::close(ends[1]);
    return sent;
  }
  bool over() { return ::waitpid(pid, nullptr, WNOHANG) == pid; }
  int ends[2] = {-1, -1};
  pid_t pid = 0;
};

struct Outcome {
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
  std::uint64_t lost = 0;
  double cpu_s = 0;
};

Outcome bareLoop(std::uint64_t rate, Nanoseconds duration) {
  UdpReceiver receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  Outcome outcome;
  const double cpu_before = cpuSeconds();
  SenderProcess sender(receiver.boundAddress(), rate, duration);
  for (bool over = false;;) {
    std::size_t drained = 0;
    for (;;) {
      const auto batch = receiver.receive();
      if (!batch || batch->empty()) break;
      drained += batch->size();
    }
    outcome.received += drained;
    if (over && drained == 0) break;
    over = over || sender.over();
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  outcome.cpu_s = cpuSeconds() - cpu_before;
  outcome.sent = sender.finish();
  outcome.lost = receiver.droppedByNow().value();
  return outcome;
}

Outcome recorder(std::uint64_t rate, Nanoseconds duration,
                 LogWriterOptions::Compression compression) {
  UdpReceiver receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  RecordOptions options;
  options.log = std::filesystem::temp_directory_path() /
                fmt::format("rocinante-capture-bench-{}.mcap", ::getpid());
  options.writing.compression = compression;
  options.writing.overwrite = true;
  LogWriter log = LogWriter::create(options.log, options.writing, "bench").value();
  Outcome outcome;
  const double cpu_before = cpuSeconds();
  SenderProcess sender(receiver.boundAddress(), rate, duration);
  RecordEvents events;
  events.stop_requested = [&] { return sender.over(); };
  const RecordSummary summary = recordFrom({&receiver}, std::move(log), options, events);
  outcome.cpu_s = cpuSeconds() - cpu_before;
  outcome.sent = sender.finish();
  outcome.received = summary.packets;
  outcome.lost = summary.lost();
  std::filesystem::remove(options.log);
  return outcome;
}

/// A rate that the sender did not reach says nothing about the receiver.
constexpr double kReached = 0.98;

void report(std::string_view what, const Outcome& outcome, double seconds, const Outcome& bare) {
  const auto sent = static_cast<double>(outcome.sent);
  const auto cpuOf = [](const Outcome& each) {
    return each.cpu_s * 1e6 / static_cast<double>(std::max<std::uint64_t>(1, each.received));
  };
  fmt::print(
      "  {:<20} offered {:>9.0f}/s  lost {:>8} ({:5.2f} %)  {:4.2f} us CPU a packet, {:4.2f}x  "
      "{}\n",
      what, sent / seconds, outcome.lost, 100.0 * static_cast<double>(outcome.lost) / sent,
      cpuOf(outcome), cpuOf(outcome) / cpuOf(bare),
      outcome.received + outcome.lost == outcome.sent ? "account exact" : "ACCOUNT WRONG");
  std::fflush(stdout);
}

/// No loss where the bare loop has none; whatever is lost is counted.
void judge(std::string_view what, std::uint64_t rate, double seconds, const Outcome& ours,
           const Outcome& bare) {
  const auto reached = [&](const Outcome& outcome) {
    return static_cast<double>(outcome.sent) >= kReached * static_cast<double>(rate) * seconds;
  };
  const char* answer = "met";
  if (ours.received + ours.lost != ours.sent) {
    answer = "MISSED: the account is wrong";
  } else if (!reached(ours) || !reached(bare)) {
    answer = "not judged: the sender did not reach the rate";
  } else if (bare.lost > 0) {
    answer = "not judged: the bare loop lost some too";
  } else if (ours.lost > 0) {
    answer = "MISSED: lost what the bare loop keeps";
  }
  fmt::print("  bar, {}/s {}: {}\n", rate, what, answer);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 3;
  const auto duration = std::chrono::duration_cast<Nanoseconds>(
      std::chrono::duration<double>(seconds > 0 ? seconds : 3));
  std::vector<std::uint64_t> rates;
  for (int i = 2; i < argc; ++i) rates.push_back(std::strtoull(argv[i], nullptr, 10));
  const double took = std::chrono::duration<double>(duration).count();
  if (rates.empty()) rates = {6'000, 100'000, 200'000, 400'000, 600'000, 800'000};
  for (const std::uint64_t rate : rates) {
    fmt::print("{} datagrams of {} bytes a second:\n", rate, kPayloadBytes);
    const Outcome bare = bareLoop(rate, duration);
    report("bare recvmmsg loop", bare, took, bare);
    const Outcome plain = recorder(rate, duration, LogWriterOptions::Compression::none);
    report("record, uncompressed", plain, took, bare);
    const Outcome zstd = recorder(rate, duration, LogWriterOptions::Compression::zstd);
    report("record, zstd", zstd, took, bare);
    if (rate <= 600'000) judge("uncompressed", rate, took, plain, bare);
    if (rate <= 400'000) judge("zstd", rate, took, zstd, bare);
  }
}
