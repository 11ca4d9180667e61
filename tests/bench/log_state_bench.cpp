// The state at a moment of a long session: 10 minutes at 6,000 packets a second, of six arms that
// restate themselves, a planner that draws and a conveyor that comes and goes. How long each answer
// takes going forwards and backwards in steps of 1/30 s, and at random; and what writing with
// keyframes costs beside bare ZSTD_compress2 of the same records.
// usage: log_state_bench [SECONDS [FOLDER]]
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "core/mcap/append_record.h"
#include "core/mcap/records.h"
#include "core/recording/session_writer.h"
#include "core/session/timeline.h"
#include "tests/bench/bench_support.h"
#include "tests/support/joint_packets.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;
constexpr std::int64_t kRateHz = 6'000;
constexpr std::int64_t kPeriodNs = 1'000'000'000 / kRateHz;
constexpr std::size_t kArms = 6;
constexpr double kBarMs = 16;

/// What the sources say, packet by packet.
class Sources {
 public:
  static constexpr std::size_t kCount = kArms + 2;

  /// Packet `i` of the session: which source says it, and what.
  std::size_t say(std::size_t i, std::string& text) {
    const std::size_t source = i % 200 == 0 ? kArms : i % 200 == 100 ? kArms + 1 : i % kArms;
    std::uint64_t& sequence = sequences_[source];
    const double t = static_cast<double>(i) / static_cast<double>(kRateHz);
    if (source == kArms) {
      text = fmt::format(
          "RK1 planner@p {} {:.6f}\nline path:{}/4 #00ff00 width=2 {:.4f} 0 1 {:.4f} 1 1 0.5 0.5 "
          "1\n"
          "view follow {:.3f} -4 3 0 0 0 45\n",
          sequence, t, i / 200 % 4 + 1, t, t / 2, t);
    } else if (source == kArms + 1) {
      const std::size_t box = i / 200 % 12;
      text = fmt::format("RK1 conveyor@c {} {:.6f}\n", sequence, t);
      text += i / 2400 % 2 == 0
                  ? fmt::format("add box{0} box\npose box{0} {1:.4f} 0.2 0.8 0 0 0 1\n", box, t)
                  : fmt::format("remove box{}\n", box);
    } else if (sequence % 2000 < 2) {
      // Every two seconds in two parts, with the packets of others between them.
      text = fmt::format("RK1 arm{0}@a {1} {2:.6f} restated part=r{3}:{4}/2\n", source, sequence, t,
                         sequence / 2000, sequence % 2 + 1);
      text += sequence % 2 == 0
                  ? fmt::format("add arm{0} puma560\npose arm{0} {0} 0 0 0 0 0 1\n", source)
                  : fmt::format("color arm{0}/link2 #ff8000\njoints arm{0} 0 0 0 0 0 0\n", source);
    } else {
      const double q = static_cast<double>(i % 100'000) * 1e-5;
      text = fmt::format(
          "RK1 arm{0}@a {1} {2:.6f}\njoints arm{0} {3:.5f} {4:.5f} {5:.5f} {6:.5f} "
          "{7:.5f} {8:.5f}\n",
          source, sequence, t, q, q / 2, 1 - q, q * q, -q, q / 3);
    }
    ++sequence;
    return source;
  }

 private:
  std::uint64_t sequences_[kCount] = {};
};

void writeSession(const std::filesystem::path& path, std::size_t packets) {
  LogWriterOptions options;
  options.overwrite = true;
  SessionWriter session(bench::need(LogWriter::create(path, options, "bench")), {});
  std::vector<ChannelId> channels;
  for (std::size_t i = 0; i < Sources::kCount; ++i) {
    channels.push_back(
        bench::need(session.addChannel(fmt::format("/udp/19960/s{}", i), "rk1", {})));
  }
  Sources sources;
  std::string text;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < packets; ++i) {
    const std::size_t source = sources.say(i, text);
    const std::int64_t time_ns = kOriginNs + static_cast<std::int64_t>(i) * kPeriodNs;
    bytes += text.size();
    bench::need(session.write(channels[source], static_cast<std::uint32_t>(i),
                              LogTime(Nanoseconds(time_ns)), time_ns, bytesOf(text)));
  }
  bench::need(session.log().close("finished"));
  fmt::print("{} packets of {} bytes in {} s, {} keyframes, a file of {} MB\n", packets,
             bytes / packets, packets / static_cast<std::size_t>(kRateHz), session.keyframes(),
             std::filesystem::file_size(path) / 1'000'000);
}

/// Asks for the state at each moment; tells the times that the answers took.
void ask(const char* name, const std::filesystem::path& path, const std::vector<LogTime>& moments) {
  using Clock = std::chrono::steady_clock;
  Timeline timeline = bench::need(Timeline::open(path));
  std::vector<double> took_ms, cpu_ms;
  for (const LogTime moment : moments) {
    const double cpu_before = 1e3 * bench::threadSeconds();
    const Clock::time_point start = Clock::now();
    (void)bench::need(timeline.stateAt(moment));
    cpu_ms.push_back(1e3 * bench::threadSeconds() - cpu_before);
    took_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  const auto at = [](std::vector<double>& times, double part) {
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  fmt::print(
      "{:<18} p50 {:5.2f} ms, p99 {:5.2f} (bar {}), max {:5.2f}; of CPU p99 {:5.2f}, max "
      "{:5.2f}  ({} moments)\n",
      name, at(took_ms, 0.5), at(took_ms, 0.99), kBarMs, at(took_ms, 1), at(cpu_ms, 0.99),
      at(cpu_ms, 1), took_ms.size());
}

void askEverywhere(const std::filesystem::path& path, LogTime start, LogTime end) {
  std::vector<LogTime> forwards;
  for (LogTime moment = start; moment < end; moment += Nanoseconds(1'000'000'000 / 30)) {
    forwards.push_back(moment);
  }
  const std::vector<LogTime> backwards(forwards.rbegin(), forwards.rend());
  std::vector<LogTime> seconds;
  for (LogTime moment = end; moment > start; moment -= std::chrono::seconds(1)) {
    seconds.push_back(moment);
  }
  std::mt19937_64 random(1);
  std::vector<LogTime> anywhere;
  const auto span_ns = static_cast<std::uint64_t>((end - start).count());
  for (int i = 0; i < 2000; ++i) {
    anywhere.push_back(start + Nanoseconds(static_cast<std::int64_t>(random() % span_ns)));
  }
  ask("forwards, 1/30 s", path, forwards);
  ask("backwards, 1/30 s", path, backwards);
  ask("backwards, 1 s", path, seconds);
  std::reverse(seconds.begin(), seconds.end());
  ask("forwards, 1 s", path, seconds);
  ask("random", path, anywhere);
}

/// The CPU of writing `packets` with and without keyframes beside that of compressing them alone.
void measureWriting(const std::filesystem::path& path, std::size_t packets) {
  std::vector<std::string> payloads;
  Bytes records;
  for (std::size_t i = 0; i < packets; ++i) {
    payloads.push_back(test::jointPacket(i, kRateHz));
    const std::uint64_t time = static_cast<std::uint64_t>(kOriginNs) + i * kPeriodNs;
    mcap::append(records, mcap::Message{0, static_cast<std::uint32_t>(i), time, time,
                                        bytesOf(payloads.back())});
  }
  const auto bare = [&] {
    constexpr std::size_t kBufferBytes = std::size_t{1} << 20U;
    Bytes out(ZSTD_compressBound(kBufferBytes));
    ZSTD_CCtx* const zstd = ZSTD_createCCtx();
    ZSTD_CCtx_setParameter(zstd, ZSTD_c_compressionLevel, 1);
    for (std::size_t at = 0; at < records.size(); at += kBufferBytes) {
      ZSTD_compress2(zstd, out.data(), out.size(), records.data() + at,
                     std::min(kBufferBytes, records.size() - at));
    }
    ZSTD_freeCCtx(zstd);
  };
  const auto log = [&](bool keyframes) {
    LogWriterOptions options;
    options.overwrite = true;
    KeyframeOptions how;
    how.enabled = keyframes;
    SessionWriter session(bench::need(LogWriter::create(path, options, "bench")), how);
    const ChannelId channel = bench::need(session.addChannel("/udp/19960/arm", "rk1", {}));
    for (std::size_t i = 0; i < packets; ++i) {
      const std::int64_t time_ns = kOriginNs + static_cast<std::int64_t>(i) * kPeriodNs;
      bench::need(session.write(channel, static_cast<std::uint32_t>(i),
                                LogTime(Nanoseconds(time_ns)), time_ns, bytesOf(payloads[i])));
    }
    bench::need(session.log().close("finished"));
  };
  double least[3] = {1e9, 1e9, 1e9};
  const auto measure = [&](double& least_s, auto work) {
    const double start = bench::processSeconds();
    work();
    least_s = std::min(least_s, bench::processSeconds() - start);
  };
  for (int run = 0; run < 5; ++run) {
    measure(least[0], bare);
    measure(least[1], [&] { log(false); });
    measure(least[2], [&] { log(true); });
  }
  const double ns = 1e9 / static_cast<double>(packets);
  fmt::print(
      "writing: bare zstd 1 {:.0f} ns a packet; log {:.0f}, {:.2f}x; with keyframes {:.0f}, "
      "{:.2f}x (bar 2.00)\n",
      least[0] * ns, least[1] * ns, least[1] / least[0], least[2] * ns, least[2] / least[0]);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t seconds = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 600;
  const std::filesystem::path folder =
      argc > 2 ? std::filesystem::path(argv[2]) : std::filesystem::temp_directory_path();
  const std::filesystem::path path =
      folder / fmt::format("log_state_bench.{}.mcap", static_cast<long>(::getpid()));
  const std::size_t packets = std::max<std::size_t>(seconds, 1) * kRateHz;
  writeSession(path, packets);
  const LogTime start{Nanoseconds(kOriginNs)};
  askEverywhere(path, start, start + Nanoseconds(static_cast<std::int64_t>(packets) * kPeriodNs));
  measureWriting(path, 1'000'000);
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  return 0;
}
