#pragma once

#include <memory>

#include "core/foreign/session/session_format.h"

namespace rocinante {

/// Protobuf messages of package foxglove, for Foxglove, Lichtblick and whatever reads their
/// schemas: FrameTransforms on /tf/DEVICE, JointStates on /joints/DEVICE, SceneUpdate on
/// /drawings/SOURCE (lines and labels), PointCloud on /points/SOURCE/ID, Log on /events. Times are
/// log times.
std::unique_ptr<SessionFormat> makeFoxgloveFormat();

}  // namespace rocinante
