// 500 cases at 640x480 of the demo: what judging adds to drawing, and what jobs pay.
//
//   golden_bench [FRAMES]
//
// floor: the same frames by FrameMaker::frame alone, in the order of the log. Each pass is a
// process of its own; wall and CPU of all its threads. The goldens are those that the floor drew.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>

#include "core/base/atomic_file.h"
#include "golden/judge/suite_jobs.h"
#include "tests/support/temporary_folder.h"
#include "viewer/gl/renderer_key.h"

namespace {

using namespace rocinante;

double steadyMs() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

struct Cost {
  double wall_ms = 0, cpu_ms = 0;
  bool done = false;
};

/// Runs `pass` in a process of its own: no context of another pass is there.
Cost costOf(const std::function<bool()>& pass) {
  std::fflush(nullptr);
  const double started = steadyMs();
  const ::pid_t pid = ::fork();
  if (pid == 0) ::_exit(pass() ? 0 : 1);
  int status = 0;
  struct rusage used {};
  ::wait4(pid, &status, 0, &used);
  const auto ms = [](const ::timeval& time) {
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_usec) * 1e-3;
  };
  return {steadyMs() - started, ms(used.ru_utime) + ms(used.ru_stime), status == 0};
}

bool tell(const Error& error) {
  fmt::print(stderr, "golden_bench: {}\n", error.text());
  return false;
}

bool drawFloor(const std::filesystem::path& suite, const SuiteOptions& options, bool accept) {
  auto session = SuiteSession::open(suite, options);
  if (!session.ok()) return tell(session.error());
  const auto drawer = session->drawer();
  if (!drawer.ok()) return tell(drawer.error());
  Manifest manifest;
  for (const std::size_t place : inLogOrder(session->frames())) {
    const SuiteFrame& frame = session->frames()[place];
    const auto drawn = (*drawer)->frame(session->request(frame));
    if (!drawn.ok()) return tell(drawn.error());
    if (!accept) continue;
    manifest.accept(frame.name, {*session->key(*frame.suite_case), frame.name + ".png",
                                 pictureXxh3(*drawn), "", "", "bench", "", ""});
  }
  if (!accept) return true;
  std::filesystem::create_directories(session->suite().goldens);
  const auto written = manifest.write(session->suite().goldens);
  return written ? true : tell(written.error());
}

bool judge(const std::filesystem::path& suite, const SuiteOptions& options, int jobs) {
  auto session = SuiteSession::open(suite, options);
  if (!session.ok()) return tell(session.error());
  JobOptions job_options;
  job_options.jobs = jobs;
  const auto judged = judgeAll(*session, job_options);
  if (!judged.ok()) return tell(judged.error());
  return std::ranges::all_of(
      *judged, [](const JudgedFrame& one) { return one.verdict == FrameVerdict::same; });
}

}  // namespace

int main(int argc, char** argv) {
  pinRendererEnvironment();
  const std::filesystem::path demo = ROCINANTE_DEMO_FOLDER;
  const int frames = argc > 1 ? std::atoi(argv[1]) : 500;
  if (frames < 1) {
    fmt::print(stderr, "usage: golden_bench [FRAMES]\n");
    return 2;
  }
  const test::TemporaryFolder folder;
  std::string text =
      fmt::format("format = 1\ncell = \"{}\"\nlog = \"{}\"\n", (demo / "demo.cell.toml").string(),
                  (demo / "session.mcap").string());
  for (int i = 0; i < frames; ++i) {
    text += fmt::format("[[case]]\nname = \"case-{0}\"\nat = \"{1}ms\"\ncamera = \"overview\"\n", i,
                        500 + i * 19'000 / frames);
  }
  const std::filesystem::path suite = folder / "suite.toml";
  if (const auto written = writeFileWhole(suite, bytesOf(text), true); !written) return 2;
  SuiteOptions options;
  options.now_ms = steadyMs;

  // The first pass also warms the caches of files and shaders.
  if (!costOf([&] { return drawFloor(suite, options, true); }).done) return 1;
  const Cost floor = costOf([&] { return drawFloor(suite, options, false); });
  fmt::print("{} cases, 640x480, 4 samples\n", frames);
  fmt::print("  {:<22} wall {:8.0f} ms  CPU {:8.0f} ms\n", "floor: drawn alone", floor.wall_ms,
             floor.cpu_ms);
  std::fflush(stdout);
  for (const int jobs : {1, 2}) {
    const Cost cost = costOf([&] { return judge(suite, options, jobs); });
    if (!cost.done) return 1;
    fmt::print("  {:<22} wall {:8.0f} ms  CPU {:8.0f} ms  {:.3f}x the wall, {:.3f}x the CPU\n",
               fmt::format("judged, {} job{}", jobs, jobs == 1 ? "" : "s"), cost.wall_ms,
               cost.cpu_ms, cost.wall_ms / floor.wall_ms, cost.cpu_ms / floor.cpu_ms);
    std::fflush(stdout);
  }
  return 0;
}
