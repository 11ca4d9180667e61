#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/joint_packets.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// The real program, killed: docs/log-format.md, "The open chunk".
namespace rocinante {
namespace {

using std::chrono::milliseconds;

constexpr Nanoseconds kSync = milliseconds(100);
constexpr Nanoseconds kGrace = milliseconds(50);
/// The same beside programs that occupy every processor: docs/programs/record.md.
constexpr Nanoseconds kGraceUnderLoad = milliseconds(150);

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

/// The longest delay of a thread's wake-up on this machine: a recorder that does not get to run
/// cannot write.
class StallWatch {
 public:
  StallWatch() : thread_([this] { watch(); }) {}
  ~StallWatch() { stop(); }
  Nanoseconds stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return longest_;
  }
  Nanoseconds longest() const { return longest_.load(); }

 private:
  void watch() {
    constexpr Nanoseconds kSleep = milliseconds(1);
    // Measured from the thread's creation: waiting to run for the first time is a stall too.
    SteadyTime before = made_;
    do {
      std::this_thread::sleep_for(kSleep);
      const SteadyTime now = steadyNow();
      longest_ = std::max<Nanoseconds>(longest_, now - before - kSleep);
      before = now;
    } while (!stop_);
  }
  SteadyTime made_ = steadyNow();
  std::atomic<bool> stop_{false};
  std::atomic<Nanoseconds> longest_{Nanoseconds(0)};
  std::thread thread_;
};

struct SentUntil {
  SteadyTime at;
  std::uint64_t packets;  ///< handed to the kernel by then
};

/// Sends `rate_hz` packets a second, evenly, in bursts of a millisecond: for `span`, and as much
/// longer as this machine stalls, so that something is always on the disk at the end.
std::vector<SentUntil> sendFor(UdpSender& sender, double rate_hz, Nanoseconds span,
                               const StallWatch& stalls) {
  std::vector<SentUntil> sent;
  std::uint64_t next = 0;
  const SteadyTime start = steadyNow();
  while (true) {
    const Nanoseconds passed = steadyNow() - start;
    if (passed >= span + 2 * stalls.longest()) return sent;
    const double seconds = std::chrono::duration<double>(passed).count();
    const auto due = static_cast<std::uint64_t>(seconds * rate_hz) + 1;
    while (next < due) {
      std::vector<std::string> packets;
      for (; next < due && packets.size() < 64; ++next) {
        packets.push_back(test::jointPacket(next, rate_hz));
      }
      std::vector<ByteView> views;
      for (const std::string& each : packets) views.push_back(bytesOf(each));
      EXPECT_TRUE(sender.send(views).ok());
    }
    sent.push_back({steadyNow(), next});
    std::this_thread::sleep_for(milliseconds(1));
  }
}

/// The sequence numbers in a killed log, in order.
std::vector<std::uint64_t> sequencesIn(const std::filesystem::path& path) {
  std::vector<std::uint64_t> sequences;
  auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok()) << log.error().text();
  if (!log) return sequences;
  for (auto message = log->next(); message && *message; message = log->next()) {
    if (!(*message)->channel->captured()) continue;
    std::istringstream words{std::string(textOf((*message)->payload))};
    std::string word;
    std::uint64_t sequence = 0;
    words >> word >> word >> sequence;
    sequences.push_back(sequence);
  }
  EXPECT_FALSE(log->summary().complete);
  return sequences;
}

/// Checks what one kill left.
void killOnce(double rate_hz, Nanoseconds after, const std::string& compression,
              Nanoseconds grace) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "log.mcap";
  auto program = test::Program::start(
      "rocinante-record", {"127.0.0.1:0", "-o", path.string(), "--compression", compression});
  std::istringstream line(program.waitForLine("recording "));
  std::string endpoint;
  line >> endpoint >> endpoint;
  const auto bound = Endpoint::parse(endpoint);
  ASSERT_TRUE(bound.ok()) << endpoint;
  UdpSender sender = std::move(UdpSender::open(*bound).value());

  StallWatch stalls;
  const std::vector<SentUntil> sent = sendFor(sender, rate_hz, after, stalls);
  const auto queue = test::udpQueueAt(bound->address.port);
  ASSERT_TRUE(queue.has_value());
  const SteadyTime killed_at = steadyNow();
  program.signal(SIGKILL);
  const Nanoseconds stall = stalls.stop();
  EXPECT_EQ(program.finish().exit_code, 128 + SIGKILL);

  std::uint64_t safe = 0;
  for (const SentUntil& each : sent) {
    if (each.at + kSync + grace + 2 * stall <= killed_at) safe = each.packets;
  }
  ASSERT_GT(safe, 0U);
  const std::vector<std::uint64_t> stored = sequencesIn(path);
  std::uint64_t safe_stored = 0;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (stored[i] < safe) ++safe_stored;
  }
  EXPECT_TRUE(std::ranges::is_sorted(stored));
  EXPECT_LE(safe - safe_stored, queue->dropped)
      << safe << " packets were safe, the last of " << stored.size() << " in the log is "
      << (stored.empty() ? 0 : stored.back()) << "; this machine stalled for "
      << std::chrono::duration_cast<milliseconds>(stall).count() << " ms";
}

void killAtRandomMoments(double rate_hz, Nanoseconds grace = kGrace) {
  // ROCINANTE_KILLS=N, as scripts/nightly has it: N rounds.
  const char* const wanted = std::getenv("ROCINANTE_KILLS");
  const int usual = std::getenv("ROCINANTE_LONG") != nullptr ? 4 : 1;
  const int rounds = wanted != nullptr ? std::atoi(wanted) : usual;
  std::random_device random;
  const unsigned seed = random();
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 generator(seed);
  // After the first datagrams, and after one whole chunk at 100,000 a second.
  std::uniform_int_distribution<int> moment_ms(400, rate_hz < 10 ? 2'500 : 1'200);
  for (int i = 0; i < rounds; ++i) {
    for (const char* compression : {"zstd", "none"}) {
      SCOPED_TRACE(compression);
      killOnce(rate_hz, milliseconds(moment_ms(generator)), compression, grace);
    }
  }
}

TEST(RecordKilled, AtOnePacketASecondLosesAtMostSync) { killAtRandomMoments(1); }
TEST(RecordKilled, AtAHundredPacketsASecondLosesAtMostSync) { killAtRandomMoments(100); }
TEST(RecordKilled, AtSixThousandPacketsASecondLosesAtMostSync) { killAtRandomMoments(6'000); }
TEST(RecordKilled, AtAHundredThousandPacketsASecondLosesAtMostSync) {
  killAtRandomMoments(100'000);
}

/// Processes that compute and never sleep, during its lifetime.
class BusyLoops {
 public:
  explicit BusyLoops(int count) {
    for (int i = 0; i < count; ++i) {
      const ::pid_t child = ::fork();
      if (child == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile bool busy = true; busy;) continue;
        ::_exit(0);
      }
      children_.push_back(child);
    }
  }
  ~BusyLoops() {
    for (const ::pid_t child : children_) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
  }

 private:
  std::vector<::pid_t> children_;
};

// Only on request: the other load of the machine is unknown here.
void killBesideBusyLoops(double rate_hz) {
  if (std::getenv("ROCINANTE_KILLS") == nullptr) GTEST_SKIP() << "ROCINANTE_KILLS is not set";
  const BusyLoops loops(4);
  killAtRandomMoments(rate_hz, kGraceUnderLoad);
}

TEST(RecordKilledBesideBusyLoops, AtOnePacketASecond) { killBesideBusyLoops(1); }
TEST(RecordKilledBesideBusyLoops, AtAHundredPacketsASecond) { killBesideBusyLoops(100); }
TEST(RecordKilledBesideBusyLoops, AtSixThousandPacketsASecond) { killBesideBusyLoops(6'000); }
TEST(RecordKilledBesideBusyLoops, AtFiftyThousandPacketsASecond) { killBesideBusyLoops(50'000); }

}  // namespace
}  // namespace rocinante
