// A session of 10 minutes at 6,000 packets a second (six arms of six joints), judged against a band
// of five accepted ones, as `golden run` judges it: its log is read, each accepted log is hashed,
// and its track comes from the cache (the first time it is made). CPU of one thread. usage:
// run_bench [SECONDS [FOLDER]]
#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/log/log_writer.h"
#include "core/recording/session_writer.h"
#include "golden/run/run_judge.h"
#include "golden/run/track_cache.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;
constexpr std::int64_t kRateHz = 6'000;
constexpr std::size_t kArms = 6, kJoints = 6;
constexpr std::size_t kAccepted = 5;
constexpr Nanoseconds kStep = std::chrono::milliseconds(20);
constexpr double kBarSeconds = 6;

double cpuSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

template <class T>
T need(Result<T> result) {
  if (result) return std::move(*result);
  fmt::print(stderr, "{}\n", result.error().text());
  std::exit(2);
}
void need(const Status& status) {
  if (status) return;
  fmt::print(stderr, "{}\n", status.error().text());
  std::exit(2);
}

void writeCell(const std::filesystem::path& folder) {
  std::ofstream urdf(folder / "arm.urdf");
  urdf << "<robot name=\"arm\"> <link name=\"link0\"/>\n";
  for (std::size_t i = 0; i < kJoints; ++i) {
    urdf << fmt::format(
        "<link name=\"link{1}\"/> <joint name=\"j{0}\" type=\"revolute\"> <parent "
        "link=\"link{0}\"/> "
        "<child link=\"link{1}\"/> <axis xyz=\"0 0 1\"/> <limit lower=\"-3\" upper=\"3\" "
        "effort=\"1\" velocity=\"3\"/> </joint>\n",
        i, i + 1);
  }
  urdf << "</robot>\n";
  std::ofstream cell(folder / "cell.toml");
  cell << "format = 1\n";
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    cell << fmt::format("[[device]]\nname = \"arm{}\"\nmodel = \"arm.urdf\"\n", arm);
  }
}

/// Sessions of one motion: each begins a little later, and its encoders have noise of their own.
void writeLog(const std::filesystem::path& path, std::int64_t packets, std::uint64_t session) {
  std::uint64_t chance = 0x9E3779B97F4A7C15U * (session + 1);
  SessionWriter writer(need(LogWriter::create(path, {}, "run bench")), {});
  std::vector<ChannelId> channels;
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    channels.push_back(
        need(writer.addChannel(fmt::format("/udp/19960/control{}", arm), "rk1", {})));
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
      text += fmt::format(" {:.5f}", 1.5 * std::sin(t * (0.3 + 0.17 * phase) + phase) + noise);
    }
    text += "\n";
    if (arm == 0 && sequence % 20'000 == 10'000) text += "event \"reached\"\n";
    need(writer.write(channels[arm], static_cast<std::uint32_t>(sequence),
                      LogTime(Nanoseconds(kOriginNs + shift_ns + ns + 200'000)),
                      kOriginNs + shift_ns + ns, bytesOf(text)));
  }
  need(writer.log().close("done"));
}

struct Judged {
  double tracks_s = 0, session_s = 0, judge_s = 0;
  std::size_t findings = 0;
  bool is_comparable = false;
  double sum() const { return tracks_s + session_s + judge_s; }
};

Judged judgeOnce(const Cell& cell, const std::vector<std::filesystem::path>& logs,
                 const TrackCache& cache) {
  Judged judged;
  const double began = cpuSeconds();
  std::vector<SessionTrack> accepted;
  for (std::size_t i = 1; i < logs.size(); ++i) {
    Xxh3 hash;
    need(readFileInParts(logs[i], std::uint64_t{1} << 40, [&](ByteView part, std::uint64_t) {
      hash.add(part);
      return Status{};
    }));
    accepted.push_back(need(cache.track(cell, logs[i], hexOf(hash.digest()), kStep)));
  }
  const double read = cpuSeconds();
  const SessionTrack session = need(trackSession(cell, logs[0], kStep));
  const double tracked = cpuSeconds();
  std::vector<const SessionTrack*> band;
  for (const SessionTrack& one : accepted) band.push_back(&one);
  const RunJudgement found = judgeRun({}, band, session);
  judged.judge_s = cpuSeconds() - tracked;
  judged.session_s = tracked - read;
  judged.tracks_s = read - began;
  judged.findings = found.findings.size();
  judged.is_comparable = found.comparable;
  return judged;
}

void tell(const char* what, const Judged& judged) {
  fmt::print("{:<28} {:6.2f} s: accepted {:.2f}, session {:.2f}, judging {:.2f}\n", what,
             judged.sum(), judged.tracks_s, judged.session_s, judged.judge_s);
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t seconds = argc > 1 ? std::atoll(argv[1]) : 600;
  const std::filesystem::path folder =
      argc > 2 ? std::filesystem::path(argv[2])
               : std::filesystem::temp_directory_path() / fmt::format("run_bench_{}", ::getpid());
  std::filesystem::create_directories(folder);
  writeCell(folder);
  std::vector<std::filesystem::path> logs;
  for (std::size_t i = 0; i <= kAccepted; ++i) {
    logs.push_back(folder / fmt::format("{}.mcap", i));
    if (!std::filesystem::exists(logs.back())) writeLog(logs.back(), seconds * kRateHz, i);
  }
  const Cell cell = need(loadCell(folder / "cell.toml", {}));
  const TrackCache cache(folder / "tracks");
  const Judged first = judgeOnce(cell, logs, cache);
  const Judged again = judgeOnce(cell, logs, cache);
  tell("the first time", first);
  tell("tracks from the cache", again);
  fmt::print("{:.0f} ns a packet of the session; {} findings\n",
             again.session_s * 1e9 / static_cast<double>(seconds * kRateHz), again.findings);
  const bool is_met = again.sum() * 600 <= kBarSeconds * static_cast<double>(seconds);
  fmt::print("bar: {} s for 10 minutes: {}\n", kBarSeconds, is_met ? "met" : "missed");
  if (argc <= 2) std::filesystem::remove_all(folder);
  return again.is_comparable && again.findings == 0 && is_met ? 0 : 1;
}
