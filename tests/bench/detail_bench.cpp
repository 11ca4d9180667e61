// Whether detail scaling holds 10 frames/s at 1280x720 with 300,000 and 3,000,000 triangles: the
// governor and the scaled view of rocinante-view, over OSMesa, on scenes that are made here, the
// camera circling all the while. Prints where it came to rest, what a frame then costs (wall time,
// and CPU of all threads, which a shared machine bends less), and the same with everything drawn.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/math/trigonometry.h"
#include "tests/support/temporary_folder.h"
#include "viewer/detail/governor.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/render/renderer.h"
#include "viewer/render/scaled_view.h"

namespace {

using namespace rocinante;

constexpr int kWidth = 1280, kHeight = 720;
constexpr double kTargetMs = 100;
constexpr int kSettleFrames = 150;
constexpr int kMeasuredFrames = 30;

double milliseconds(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

/// A closed, bumpy body a metre across: `rings` * `sectors` * 2 triangles of smooth surface.
Mesh bodyMesh(int rings, int sectors, int kind) {
  Mesh mesh;
  const double bumps = 3 + kind;
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s <= sectors; ++s) {
      const double u = 2 * M_PI * r / rings, v = 2 * M_PI * s / sectors;
      const double tube = 0.16 * (1 + 0.25 * std::sin(bumps * u) * std::cos(2 * v));
      const Vec3 ring(std::cos(u), std::sin(u), 0);
      const Vec3 normal = ring * std::cos(v) + Vec3(0, 0, 1) * std::sin(v);
      const Vec3 at = ring * 0.34 + normal * tube;
      mesh.vertices.push_back(
          {glm::vec3(at), glm::vec3(normal), {static_cast<float>(u), static_cast<float>(v)}});
      mesh.bounds.add(at);
    }
  }
  const auto index = [sectors](int r, int s) {
    return static_cast<std::uint32_t>(r * (sectors + 1) + s);
  };
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      const std::uint32_t a = index(r, s), b = index(r + 1, s), c = index(r + 1, s + 1),
                          d = index(r, s + 1);
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  mesh.parts = {{"body", 0, 0, static_cast<std::uint32_t>(mesh.indices.size())}};
  Material material;
  material.diffuse = {0.35F + 0.06F * static_cast<float>(kind), 0.5F, 0.7F, 1};
  material.specular = {0.3F, 0.3F, 0.3F};
  material.shininess = 40;
  mesh.materials = {material};
  return mesh;
}

/// 100 bodies of ten kinds on a square, all of them in sight: no distance and no culling helps.
Cell yardOf(std::size_t triangles) {
  Cell cell;
  const int side = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 100 / 2));
  std::vector<std::shared_ptr<const Model>> kinds;
  for (int kind = 0; kind < 10; ++kind) {
    auto model = std::make_shared<Model>();
    model->name = fmt::format("kind{}", kind);
    Visual visual;
    visual.mesh = std::make_shared<const Mesh>(bodyMesh(side * 2, side / 2, kind));
    Link link;
    link.name = "body";
    link.visuals.push_back(std::move(visual));
    model->links.push_back(std::move(link));
    cell.models[model->name] = model;
  }
  for (int i = 0; i < 100; ++i) {
    CellDevice device;
    device.name = fmt::format("body{}", i);
    device.model = fmt::format("kind{}", i % 10);
    device.pose.position = {(i % 10 - 4.5) * 1.1, (i / 10 - 4.5) * 1.1, 0.3};
    cell.devices.push_back(std::move(device));
  }
  return cell;
}

CameraView circling(int frame) {
  const SineCosine turn = sineCosine(frame * 0.01);
  CameraView view;
  view.eye = {8 * turn.cosine, 8 * turn.sine, 6};
  return view;
}

struct Cost {
  double wall_ms = 0, cpu_ms = 0;
  std::uint64_t triangles = 0;
};

class Drawer {
 public:
  Drawer(Renderer& renderer, const PosedScene& scene) : renderer_(renderer), scene_(scene) {}

  Cost draw(int rung) {
    const DetailRung& detail = kDetailRungs[static_cast<std::size_t>(rung)];
    const double wall = milliseconds(CLOCK_MONOTONIC), cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    if (!view_.prepare(renderer_.gl(), kWidth, kHeight, 4, detail)) std::abort();
    SceneFrame frame;
    frame.scene = &scene_;
    frame.camera = circling(frame_++);
    frame.choice = &choice_;
    const auto drawn = view_.draw(renderer_, frame);
    if (!drawn.ok()) std::abort();
    renderer_.gl().Finish();
    return {milliseconds(CLOCK_MONOTONIC) - wall, milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu,
            drawn->triangles};
  }

  /// Medians of some frames; the 95th percentile of wall time apart.
  Cost typical(int rung, int frames, double& p95_ms) {
    std::vector<double> wall, cpu;
    Cost last;
    draw(rung);
    for (int i = 0; i < frames; ++i) {
      last = draw(rung);
      wall.push_back(last.wall_ms);
      cpu.push_back(last.cpu_ms);
    }
    std::ranges::sort(wall);
    std::ranges::sort(cpu);
    p95_ms = wall[wall.size() * 95 / 100];
    return {wall[wall.size() / 2], cpu[cpu.size() / 2], last.triangles};
  }

 private:
  Renderer& renderer_;
  const PosedScene& scene_;
  ViewChoice choice_;
  ScaledView view_;
  int frame_ = 0;
};

void bench(std::size_t triangles) {
  const Cell cell = yardOf(triangles);
  auto context = makeOffscreenContext(Profile::reproducible);
  if (!context.ok()) std::abort();
  auto renderer = Renderer::create(**context, cell, Profile::fast);
  if (!renderer.ok()) std::abort();
  const PosedScene scene = poseScene(cell, SessionState{});
  Drawer drawer(*renderer, scene);
  double p95 = 0;
  const Cost full = drawer.typical(0, 4, p95);
  fmt::print("{} triangles\n", full.triangles);
  fmt::print("  everything, 4 samples      {:8.1f} ms wall {:8.1f} ms CPU a frame\n", full.wall_ms,
             full.cpu_ms);

  // Coarser meshes: made, and kept; then read again.
  const test::TemporaryFolder folder;
  const DetailCache cache(folder.path());
  double started = milliseconds(CLOCK_MONOTONIC);
  renderer->prepareDetail(cache, 1);
  const double begun_ms = milliseconds(CLOCK_MONOTONIC) - started;

  Governor governor({kTargetMs, kCoarsestRung});
  int held_since = -1, changes = 0;
  double made_ms = 0, waited_ms = 0;
  for (int frame = 0; frame < kSettleFrames; ++frame) {
    if (renderer->takeReadyDetail()) governor.forget();
    if (made_ms == 0 && renderer->detailReady()) {
      made_ms = milliseconds(CLOCK_MONOTONIC) - started;
    }
    const int rung = governor.rung();
    const Cost cost = drawer.draw(rung);
    if (held_since < 0) waited_ms += cost.wall_ms;
    if (held_since < 0 && frame > 0 && cost.wall_ms <= kTargetMs) held_since = frame;
    changes += governor.frameDrawn(cost.wall_ms) != rung ? 1 : 0;
  }
  const int rung = governor.rung();
  const Cost held = drawer.typical(rung, kMeasuredFrames, p95);
  fmt::print(
      "  held at rung {}             {:8.1f} ms wall {:8.1f} ms CPU a frame, p95 {:.1f} ms: "
      "target {:.0f} ms {}\n",
      rung, held.wall_ms, held.cpu_ms, p95, kTargetMs,
      held.wall_ms <= kTargetMs ? "held" : "MISSED");
  fmt::print(
      "  {} triangles drawn; first frame within the target: number {}, after {:.1f} s; {} "
      "changes of rung in {} frames\n",
      held.triangles, held_since, waited_ms / 1e3, changes, kSettleFrames);
  started = milliseconds(CLOCK_MONOTONIC);
  auto again = Renderer::create(**context, cell, Profile::fast);
  const double created_ms = milliseconds(CLOCK_MONOTONIC) - started;
  started = milliseconds(CLOCK_MONOTONIC);
  again->prepareDetail(cache, 1);
  again->takeReadyDetail(true);
  fmt::print(
      "  coarser meshes: begun in {:.1f} ms, made beside the frames in {:.1f} s, from the "
      "cache in {:.0f} ms (the renderer itself: {:.0f} ms)\n",
      begun_ms, made_ms / 1e3, milliseconds(CLOCK_MONOTONIC) - started, created_ms);
}

}  // namespace

int main() {
  fmt::print("10 frames/s at {}x{}\n", kWidth, kHeight);
  for (const std::size_t triangles : {std::size_t{300'000}, std::size_t{3'000'000}}) {
    bench(triangles);
  }
  return 0;
}
