#include "golden/judge/frame_drawer.h"

#include <utility>

#include "core/cell/posed_scene.h"

namespace rocinante {
namespace {

std::string_view layerOfDrawing(StatementKind kind) {
  return kind == StatementKind::label    ? "labels"
         : kind == StatementKind::points ? "points"
                                         : "lines";
}

/// The layers of each name of an identity frame at that moment.
std::vector<std::vector<std::string>> layersOf(const IdentityFrame& frame,
                                               const PosedScene& scene) {
  std::vector<std::vector<std::string>> layers;
  for (const IdentityName& name : frame.names) {
    std::vector<std::string>& of_name = layers.emplace_back();
    if (name.device != "drawing") {
      // None for a removed device.
      const PosedDevice* const device = scene.findDevice(name.device);
      if (device != nullptr) of_name = layersOfLink(*device, name.link);
      continue;
    }
    for (const PosedDrawing& drawing : scene.drawings) {
      if (drawing.drawing == nullptr || drawing.source + "/" + drawing.id != name.link) continue;
      of_name.emplace_back(layerOfDrawing(drawing.drawing->kind));
      break;
    }
  }
  return layers;
}

struct HeldMaker {
  FrameMaker maker;
};

/// With a maker of its own, which is there before what borrows it.
class OwnSceneDrawer : HeldMaker, public SceneDrawer {
 public:
  explicit OwnSceneDrawer(FrameMaker its) : HeldMaker{std::move(its)}, SceneDrawer(maker) {}
};

}  // namespace

Result<SceneIdentity> SceneDrawer::identity(const FrameRequest& request) {
  auto frame = maker_.identity(request);
  if (!frame.ok()) return frame.error();
  const auto session_state = state(request);
  if (!session_state.ok()) return session_state.error();
  SceneIdentity identity{std::move(*frame), {}};
  identity.layers = layersOf(identity.frame, poseScene(maker_.cell(), *session_state));
  return identity;
}

Result<SessionState> SceneDrawer::state(const FrameRequest& request) {
  if (maker_.session() == nullptr) return SessionState{};
  const auto session_state = maker_.session()->stateAt(request.time);
  if (!session_state.ok()) return session_state.error();
  // A copy: the next question to the session takes back what it answered.
  return **session_state;
}

MakeDrawer sceneDrawers(Cell cell, std::optional<std::filesystem::path> log) {
  return [cell = std::move(cell), log = std::move(log)]() -> Result<std::unique_ptr<FrameDrawer>> {
    std::optional<Timeline> session;
    if (log) {
      auto opened = Timeline::open(*log);
      if (!opened.ok()) return opened.error();
      session = std::move(*opened);
    }
    auto maker = FrameMaker::open(cell, std::move(session), Profile::reproducible);
    if (!maker.ok()) return maker.error();
    return std::unique_ptr<FrameDrawer>(std::make_unique<OwnSceneDrawer>(std::move(*maker)));
  };
}

}  // namespace rocinante
