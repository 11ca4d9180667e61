#pragma once

#include <string>

namespace rocinante {

/// What the window does with the picture.
enum class FrameState { drawing, refining, at_rest };

/// "at rest", "refining", "drawing 30/s": of a frame that takes `frame_ms`, where more than
/// `target_fps` a second are not wanted; "drawing slowly" below one a second. Pure.
std::string frameStateText(FrameState state, double frame_ms, double target_fps);

/// "12.3 ms, 81 frames/s"; from a second on "10.0 s a frame". Pure.
std::string frameCostText(double frame_ms);

}  // namespace rocinante
