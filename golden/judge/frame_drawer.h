#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/cell/cell.h"
#include "golden/judge/case_mask.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// What draws the frames of a suite. A test hands in one of its own.
class FrameDrawer {
 public:
  virtual ~FrameDrawer() = default;

  virtual Result<Picture> frame(const FrameRequest& request) = 0;
  virtual Result<SceneIdentity> identity(const FrameRequest& request) = 0;
  /// RendererKey::text.
  virtual std::string renderer() const = 0;
  virtual const std::string& inputsHash() const = 0;
  /// Null when no FrameMaker draws.
  virtual FrameMaker* maker() { return nullptr; }
};

/// Makes a drawer with a context and a session of its own.
using MakeDrawer = std::function<Result<std::unique_ptr<FrameDrawer>>()>;

/// In the reproducible profile, each with its own context. `log` empty: the cell at rest.
MakeDrawer sceneDrawers(Cell cell, std::optional<std::filesystem::path> log);

}  // namespace rocinante
