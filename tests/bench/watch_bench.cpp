// A standing watch beside 6,000 packets a second: six arms of six joints, one joint of which is
// beyond its limits for a second of every ten, so that findings begin and end. CPU of one thread as
// a part of the session's own time. The bar is a tenth of a core.
// usage: watch_bench [SECONDS]
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/check/watch/finding_watch.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kRateHz = 6'000;
constexpr std::int64_t kArms = 6, kJoints = 6;
constexpr double kBar = 0.1;

/// The packet of this number, sent at `ns`.
void writePacket(std::int64_t number, std::int64_t ns, std::string& text) {
  const std::int64_t arm = number % kArms, sequence = number / kArms;
  const double t = static_cast<double>(ns) * 1e-9;
  const bool restates = sequence % 2000 == 0;
  const bool is_beyond = arm == 0 && ns / 1'000'000'000 % 10 == 5;
  text.clear();
  fmt::format_to(std::back_inserter(text), "RK1 control{}@7f3a {} {:.6f}{}\n", arm, sequence,
                 1'770'091'506.0 + t, restates && sequence > 0 ? " restated" : "");
  if (restates) fmt::format_to(std::back_inserter(text), "order arm{} j0 j1 j2 j3 j4 j5\n", arm);
  fmt::format_to(std::back_inserter(text), "joints arm{}", arm);
  for (std::int64_t joint = 0; joint < kJoints; ++joint) {
    const double phase = static_cast<double>(joint);
    const double value = is_beyond && joint == 3 ? 3.5 : 1.5 * std::sin(t * 0.3 + phase);
    fmt::format_to(std::back_inserter(text), " {:.5f}", value);
  }
  text += "\n";
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t seconds = argc > 1 ? std::atoll(argv[1]) : 120;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("watch_bench_{}", ::getpid());
  std::filesystem::create_directories(folder);
  bench::writeArms(folder, kArms, kJoints);
  const Result<Cell> cell = loadCell(folder / "cell.toml", {});
  std::filesystem::remove_all(folder);
  if (!cell) return 2;
  FindingWatch watch(*cell, {});
  std::string text;
  double spent = 0;
  std::size_t told_bytes = 0;
  constexpr std::int64_t kBatch = 600;
  for (std::int64_t done = 0; done < seconds * kRateHz; done += kBatch) {
    // What makes the packets is not what is measured.
    std::vector<std::string> batch;
    for (std::int64_t i = done; i < done + kBatch; ++i) {
      writePacket(i, i * 1'000'000'000 / kRateHz, text);
      batch.push_back(text);
    }
    const double began = bench::processSeconds();
    for (std::int64_t i = 0; i < kBatch; ++i) {
      const std::int64_t ns = (done + i) * 1'000'000'000 / kRateHz + 200'000;
      const LogTime time(Nanoseconds(1'770'091'506'000'000'000 + ns));
      for (const FindingChange& each : watch.reach(time)) {
        told_bytes += findingChangeJson(each).size();
      }
      watch.add(time, "rk1", true, bytesOf(batch[static_cast<std::size_t>(i)]));
    }
    spent += bench::processSeconds() - began;
  }
  const double part = spent / static_cast<double>(seconds);
  fmt::print("{} s at {}/s: {} findings began, {} bytes of JSON\n", seconds, kRateHz, watch.begun(),
             told_bytes);
  fmt::print("watch  {:.2f} s of CPU, {:.1f} % of a core; bar {:.0f} %: {}\n", spent, part * 100,
             kBar * 100, part <= kBar ? "met" : "MISSED");
  return watch.begun() > 0 ? 0 : 1;
}
