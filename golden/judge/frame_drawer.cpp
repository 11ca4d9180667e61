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

/// The layers that contain a whole link; none for a removed device.
std::vector<std::string> layersOfLink(const PosedScene& scene, const IdentityName& name) {
  const PosedDevice* const device = scene.findDevice(name.device);
  if (device == nullptr) return {};
  std::vector<std::string> layers;
  if (!device->layer.empty()) layers.push_back(device->layer);
  const auto link = device->model->findLink(name.link);
  for (const PosedShare& share : device->shares) {
    if (link && share.holds(*link)) layers.emplace_back(share.layer);
  }
  return layers;
}

/// The layers of each name of an identity frame at that moment.
std::vector<std::vector<std::string>> layersOf(const IdentityFrame& frame,
                                               const PosedScene& scene) {
  std::vector<std::vector<std::string>> layers;
  for (const IdentityName& name : frame.names) {
    std::vector<std::string>& of_name = layers.emplace_back();
    if (name.device != "drawing") {
      of_name = layersOfLink(scene, name);
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

class SceneDrawer : public FrameDrawer {
 public:
  explicit SceneDrawer(FrameMaker maker) : maker_(std::move(maker)) {}

  Result<Picture> frame(const FrameRequest& request) override { return maker_.frame(request); }

  Result<SceneIdentity> identity(const FrameRequest& request) override {
    auto frame = maker_.identity(request);
    if (!frame.ok()) return frame.error();
    SceneIdentity identity{std::move(*frame), {}};
    const SessionState nothing_said;
    const SessionState* state = &nothing_said;
    if (maker_.session() != nullptr) {
      const auto at_time = maker_.session()->stateAt(request.time);
      if (!at_time.ok()) return at_time.error();
      state = *at_time;
    }
    identity.layers = layersOf(identity.frame, poseScene(maker_.cell(), *state));
    return identity;
  }

  std::string renderer() const override { return maker_.key().text(); }
  const std::string& inputsHash() const override { return maker_.inputsHash(); }
  FrameMaker* maker() override { return &maker_; }

 private:
  FrameMaker maker_;
};

}  // namespace

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
    return std::unique_ptr<FrameDrawer>(std::make_unique<SceneDrawer>(std::move(*maker)));
  };
}

}  // namespace rocinante
