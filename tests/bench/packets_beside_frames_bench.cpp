// What packets cost the frames beside them: the window's own live feed and model under a sender of
// another process, at no packets, 6,000 and 100,000 a second, turn by turn in one run. The bars:
// 6,000/s at most 5 % of wall time a frame; 100,000/s at most 5 % of the frames' CPU (all threads
// but the feed's own) and 25 % of wall time. LP_NUM_THREADS=1, as one core is the network's.
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/net/udp_socket.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/render/renderer.h"
#include "viewer/ui/model/view_model.h"

namespace {

using namespace rocinante;

constexpr int kWidth = 640, kHeight = 480;
constexpr int kRounds = 7;
constexpr int kFrames = 40;

double milliseconds(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

/// CPU of the feed's thread, found by its name.
double feedCpuMs() {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    if (name != "rocinante-feed") continue;
    double nanoseconds = 0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    return nanoseconds / 1e6;
  }
  return 0;
}

/// Six joints, moving, in batches a millisecond apart; until it is ended.
[[noreturn]] void sendForEver(const Endpoint& endpoint, int per_second) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  auto sender = UdpSender::open(endpoint);
  if (!sender.ok()) ::_exit(1);
  const double start = milliseconds(CLOCK_MONOTONIC);
  for (std::int64_t sent = 0;;) {
    const auto due =
        static_cast<std::int64_t>((milliseconds(CLOCK_MONOTONIC) - start) * per_second / 1000);
    for (; sent < due; ++sent) {
      const double q = static_cast<double>(sent % 1000) * 0.001;
      const std::string text =
          fmt::format("RK1 arm@b {} -\njoints arm {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f}\n",
                      sent, q, -q, 0.5 - q, q * 0.5, 0.3, -0.2);
      static_cast<void>(sender->send(bytesOf(text)).ok());
    }
    ::usleep(1000);
  }
}

struct Load {
  const char* name;
  int per_second;
  std::vector<double> wall, cpu;
  std::uint64_t heard = 0;
  double seconds = 0;
};

double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

int main() {
  ::setenv("LP_NUM_THREADS", "1", 1);
  const std::filesystem::path demo(ROCINANTE_DEMO_CELL);
  auto probe = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  if (!probe.ok()) return 2;
  Endpoint endpoint = Endpoint::parse("127.0.0.1:1").value();
  endpoint.address.port = probe->boundAddress().port;
  auto cell = loadCell(demo, {});
  { UdpReceiver closed = std::move(*probe); }
  auto feed = LiveFeed::start({endpoint});
  if (!cell.ok() || !feed.ok()) return 2;
  auto model = ViewModel::make(std::move(*cell), std::nullopt, std::move(*feed), {}, {});
  auto context = makeOffscreenContext(Profile::reproducible);
  if (!model.ok() || !context.ok()) return 2;
  auto renderer = Renderer::create(**context, model->cell(), Profile::fast);
  if (!renderer.ok()) return 2;
  auto target = FrameBuffer::create(renderer->gl(), kWidth, kHeight, 1);
  if (!target.ok()) return 2;

  std::uint64_t triangles = 0;
  const auto drawFrame = [&] {
    if (!model->update(SteadyTime(std::chrono::steady_clock::now())).ok()) std::abort();
    const SceneFrame frame{&model->scene(), model->cameraView(), &model->choice()};
    const auto drawn = renderer->draw(frame, *target);
    if (!drawn.ok()) std::abort();
    triangles = drawn->triangles;
    target->resolve();
    renderer->gl().Finish();
  };
  for (int i = 0; i < 10; ++i) drawFrame();

  std::array loads{Load{"none", 0, {}, {}}, Load{"6,000/s", 6'000, {}, {}},
                   Load{"100,000/s", 100'000, {}, {}}};
  for (int round = 0; round < kRounds; ++round) {
    for (Load& load : loads) {
      pid_t sender = -1;
      if (load.per_second > 0 && (sender = ::fork()) == 0) sendForEver(endpoint, load.per_second);
      for (int i = 0; i < 5; ++i) drawFrame();
      const std::uint64_t heard = model->live() != nullptr ? model->live()->datagrams : 0;
      const double wall = milliseconds(CLOCK_MONOTONIC);
      const double cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID) - feedCpuMs();
      for (int i = 0; i < kFrames; ++i) drawFrame();
      load.cpu.push_back((milliseconds(CLOCK_PROCESS_CPUTIME_ID) - feedCpuMs() - cpu) / kFrames);
      load.wall.push_back((milliseconds(CLOCK_MONOTONIC) - wall) / kFrames);
      load.seconds += (milliseconds(CLOCK_MONOTONIC) - wall) / 1e3;
      load.heard += (model->live() != nullptr ? model->live()->datagrams : 0) - heard;
      if (sender > 0) {
        ::kill(sender, SIGKILL);
        ::waitpid(sender, nullptr, 0);
        for (int i = 0; i < 5; ++i) drawFrame();  // what still waits in the socket
      }
    }
  }
  fmt::print("{} triangles at {}x{}, LP_NUM_THREADS=1, medians of {} rounds of {} frames\n",
             triangles, kWidth, kHeight, kRounds, kFrames);
  const double wall = medianOf(loads[0].wall), cpu = medianOf(loads[0].cpu);
  for (const Load& load : loads) {
    fmt::print(
        "{:>10}  heard {:7.0f}/s  {:6.2f} ms wall ({:+5.1f} %)  {:6.2f} ms CPU of frames "
        "({:+5.1f} %)\n",
        load.name, static_cast<double>(load.heard) / load.seconds, medianOf(load.wall),
        (medianOf(load.wall) / wall - 1) * 100, medianOf(load.cpu),
        (medianOf(load.cpu) / cpu - 1) * 100);
  }
  fmt::print("lost: {} by the kernel\n",
             model->live() != nullptr ? model->live()->dropped : std::uint64_t{0});
  return 0;
}
