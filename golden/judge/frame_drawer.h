#pragma once

#include <functional>
#include <memory>
#include <string>

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
  /// Null without a FrameMaker.
  virtual FrameMaker* maker() { return nullptr; }
};

/// Makes a drawer with its own context and session.
using MakeDrawer = std::function<Result<std::unique_ptr<FrameDrawer>>()>;

/// Makes drawers with the reproducible profile, each with its own context. `log` empty: the cell at
/// rest.
MakeDrawer sceneDrawers(Cell cell, std::optional<std::filesystem::path> log);

}  // namespace rocinante
