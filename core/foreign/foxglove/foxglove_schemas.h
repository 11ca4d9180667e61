#pragma once

#include <string_view>

#include "core/foreign/session/message_schema.h"

namespace rocinante {

/// The schema of a message of package `foxglove` that is written here, with everything it refers
/// to: names, numbers and types are those of the published definitions
/// (https://docs.foxglove.dev/docs/visualization/message-schemas). Made on the first call; `name`
/// is one of FrameTransforms, JointStates, SceneUpdate, PointCloud, Log.
const MessageSchema& foxgloveSchema(std::string_view name);

}  // namespace rocinante
