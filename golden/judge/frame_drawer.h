#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "golden/judge/case_mask.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// Draws the frames of a suite. Tests substitute their own.
class FrameDrawer {
 public:
  virtual ~FrameDrawer() = default;

  virtual Result<Picture> frame(const FrameRequest& request) = 0;
  virtual Result<SceneIdentity> identity(const FrameRequest& request) = 0;
  /// RendererKey::text.
  virtual std::string renderer() const = 0;
  virtual const std::string& inputsHash() const = 0;
  /// The main view, then the drawn insets in order.
  virtual Result<std::vector<PicturedView>> views(const FrameRequest& request) = 0;
  /// What the session has said by then; empty for a cell at rest.
  virtual Result<SessionState> state(const FrameRequest& request) = 0;
  virtual const Cell& cell() const = 0;
  /// Textures that are there and cannot be read, after the first frame.
  virtual std::vector<std::string> warnings() const { return {}; }
};

/// Draws by a FrameMaker, which it borrows.
class SceneDrawer : public FrameDrawer {
 public:
  explicit SceneDrawer(FrameMaker& maker) : maker_(maker) {}

  Result<Picture> frame(const FrameRequest& request) override { return maker_.frame(request); }
  Result<SceneIdentity> identity(const FrameRequest& request) override;
  std::string renderer() const override { return maker_.key().text(); }
  const std::string& inputsHash() const override { return maker_.inputsHash(); }
  Result<std::vector<PicturedView>> views(const FrameRequest& request) override {
    return maker_.views(request);
  }
  Result<SessionState> state(const FrameRequest& request) override;
  const Cell& cell() const override { return maker_.cell(); }
  std::vector<std::string> warnings() const override { return maker_.warnings(); }

 private:
  FrameMaker& maker_;
};

/// Makes a drawer with its own context and session.
using MakeDrawer = std::function<Result<std::unique_ptr<FrameDrawer>>()>;

/// Makes drawers with the reproducible profile, each with its own context. `log` empty: the cell at
/// rest.
MakeDrawer sceneDrawers(Cell cell, std::optional<std::filesystem::path> log);

}  // namespace rocinante
