// A session of 10 minutes at 6,000 packets a second (six arms of six joints), judged against a band
// of five accepted ones, as `golden run` judges it: its log is read, each accepted log is hashed,
// and its track comes from the cache (the first time it is made). What can be done side by side is,
// as there; the bar is of CPU time of all threads, with tracks from the cache. With SIGNALS each
// packet has so many numbers beside, without a bar. usage: run_bench [SECONDS [FOLDER [SIGNALS]]]
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/behaviour/run_judge.h"
#include "core/behaviour/track_cache.h"
#include "core/cli/worker_threads.h"
#include "core/log/log_writer.h"
#include "core/recording/session_writer.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;
constexpr std::int64_t kRateHz = 6'000;
constexpr std::size_t kArms = 6, kJoints = 6;
constexpr std::size_t kAccepted = 5;
constexpr double kBarCpuSeconds = 6;  // for 10 minutes

/// Sessions of one motion: each begins a little later, and its encoders have noise of their own.
/// `signals`: numbers beside the joints. `late_s`: the whole motion.
void writeLog(const std::filesystem::path& path, std::int64_t packets, std::uint64_t session,
              std::size_t signals, double late_s = 0) {
  std::uint64_t chance = 0x9E3779B97F4A7C15U * (session + 1);
  SessionWriter writer(bench::need(LogWriter::create(path, {}, "run bench")), {});
  std::vector<ChannelId> channels;
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    channels.push_back(
        bench::need(writer.addChannel(fmt::format("/udp/19960/control{}", arm), "rk1", {})));
  }
  const auto shift_ns = static_cast<std::int64_t>(session) * 137'000;
  std::string text;
  for (std::int64_t i = 0; i < packets; ++i) {
    const std::size_t arm = static_cast<std::size_t>(i) % kArms;
    const std::int64_t sequence = i / static_cast<std::int64_t>(kArms);
    const std::int64_t ns = i * 1'000'000'000 / kRateHz;
    const double t = static_cast<double>(ns) * 1e-9;
    const bool restates = sequence % 2000 == 0;
    text = fmt::format("RK1 control{}@7f3a {} {:.6f}{}\n", arm, sequence, 1'770'091'506.0 + t,
                       restates && sequence > 0 ? " restated" : "");
    if (restates) text += fmt::format("order arm{} j0 j1 j2 j3 j4 j5\n", arm);
    text += fmt::format("joints arm{}", arm);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const double phase = static_cast<double>(joint);
      chance = chance * 6364136223846793005U + 1442695040888963407U;
      const double noise = (static_cast<double>(chance >> 40U) / double(1U << 24U) - 0.5) * 2e-4;
      text += fmt::format(" {:.5f}",
                          1.5 * std::sin((t - late_s) * (0.3 + 0.17 * phase) + phase) + noise);
    }
    text += "\n";
    if (signals > 0) text += fmt::format("signals arm{}", arm);
    for (std::size_t signal = 0; signal < signals; ++signal) {
      const double phase = static_cast<double>(signal);
      chance = chance * 6364136223846793005U + 1442695040888963407U;
      const double noise = (static_cast<double>(chance >> 40U) / double(1U << 24U) - 0.5) * 2;
      text += fmt::format(" s{:02}.effort={:.4f}", signal,
                          40 * std::sin((t - late_s) * (0.4 + 0.07 * phase) + phase) + noise);
    }
    if (signals > 0) text += "\n";
    if (arm == 0 && sequence % 20'000 == 10'000) text += "event \"reached\"\n";
    bench::need(writer.write(channels[arm], static_cast<std::uint32_t>(sequence),
                             LogTime(Nanoseconds(kOriginNs + shift_ns + ns + 200'000)),
                             kOriginNs + shift_ns + ns, bytesOf(text)));
  }
  bench::need(writer.log().close("done"));
}

struct Judged {
  double tracks_s = 0, judge_s = 0;  ///< on the wall
  double cpu_s = 0;
  std::size_t findings = 0;
  bool is_comparable = false;
  double sum() const { return tracks_s + judge_s; }
};

Judged judgeOnce(const Cell& cell, const std::vector<std::filesystem::path>& logs,
                 const TrackCache& cache) {
  Judged judged;
  const ParallelFor parallel = cli::workerThreads();
  const double cpu_before = bench::processSeconds();
  const double began = bench::wallSeconds();
  std::vector<SessionTrack> tracks(logs.size());
  parallel(logs.size(), [&](std::size_t i) {
    if (i == 0) {
      tracks[i] = bench::need(trackSession(cell, logs[i]));
      return;
    }
    Xxh3 hash;
    bench::need(readFileInParts(logs[i], std::uint64_t{1} << 40, [&](ByteView part, std::uint64_t) {
      hash.add(part);
      return Status{};
    }));
    tracks[i] = bench::need(cache.track(cell, logs[i], hexOf(hash.digest())));
  });
  judged.tracks_s = bench::wallSeconds() - began;
  std::vector<const SessionTrack*> band;
  for (std::size_t i = 1; i < tracks.size(); ++i) band.push_back(&tracks[i]);
  const RunJudgement found = judgeRun({}, band, tracks.front(), parallel);
  judged.judge_s = bench::wallSeconds() - began - judged.tracks_s;
  judged.cpu_s = bench::processSeconds() - cpu_before;
  judged.findings = found.findings.size();
  judged.is_comparable = found.comparable;
  return judged;
}

void tell(const char* what, const Judged& judged) {
  fmt::print("{:<28} {:6.2f} s: reading {:.2f}, judging {:.2f}; CPU {:.2f} s\n", what, judged.sum(),
             judged.tracks_s, judged.judge_s, judged.cpu_s);
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t seconds = argc > 1 ? std::atoll(argv[1]) : 600;
  const std::filesystem::path folder =
      argc > 2 ? std::filesystem::path(argv[2])
               : std::filesystem::temp_directory_path() / fmt::format("run_bench_{}", ::getpid());
  const std::size_t signals = argc > 3 ? static_cast<std::size_t>(std::atoll(argv[3])) : 0;
  std::filesystem::create_directories(folder);
  bench::writeArms(folder, kArms, kJoints);
  std::vector<std::filesystem::path> logs;
  for (std::size_t i = 0; i <= kAccepted; ++i) {
    logs.push_back(folder / fmt::format("{}.mcap", i));
    if (!std::filesystem::exists(logs.back())) writeLog(logs.back(), seconds * kRateHz, i, signals);
  }
  const Cell cell = bench::need(loadCell(folder / "cell.toml", {}));
  const TrackCache cache(folder / "tracks");
  const Judged first = judgeOnce(cell, logs, cache);
  const Judged again = judgeOnce(cell, logs, cache);
  tell("the first time", first);
  tell("tracks from the cache", again);
  fmt::print("{} findings\n", again.findings);
  logs[0] = folder / "late.mcap";
  if (!std::filesystem::exists(logs[0])) writeLog(logs[0], seconds * kRateHz, 9, signals, 0.05);
  const Judged late = judgeOnce(cell, logs, cache);
  tell("all of it 50 ms late", late);
  const bool is_met = again.cpu_s * 600 <= kBarCpuSeconds * static_cast<double>(seconds);
  fmt::print("bar: {} s of CPU for 10 minutes: {}\n", kBarCpuSeconds, is_met ? "met" : "missed");
  if (argc <= 2) std::filesystem::remove_all(folder);
  return again.is_comparable && again.findings == 0 && late.findings > 0 && is_met ? 0 : 1;
}
