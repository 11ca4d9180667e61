#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/foreign/session/message_sink.h"
#include "core/foreign/session/session_format.h"

namespace rocinante {

/// The schema of a message of package `foxglove` that is written here, with everything it refers
/// to: names, numbers and types are those of the published definitions
/// (https://docs.foxglove.dev/docs/visualization/message-schemas). Made on the first call; `name`
/// is one of FrameTransforms, JointStates, SceneUpdate, PointCloud, Log.
const MessageSchema& foxgloveSchema(std::string_view name);

/// What a message has of an owner's signals: what is new, for who reads every message, or all.
enum class SignalMessages : std::uint8_t { recent, whole };

/// Protobuf messages of package foxglove, for Foxglove, Lichtblick and whatever reads their
/// schemas: FrameTransforms on /tf/DEVICE, JointStates on /joints/DEVICE, SceneUpdate on
/// /drawings/SOURCE (lines and labels), PointCloud on /points/SOURCE/ID, Log on /events. Signals
/// are JSON on /signals/PATH (signal_json.h), once knowSignals() was called; again when
/// there are more, whose channels have new schemas. Times are log times.
std::unique_ptr<SessionFormat> makeFoxgloveFormat(SignalMessages signals = SignalMessages::recent);

}  // namespace rocinante
