#pragma once

#include <cstddef>

#include "core/base/time.h"
#include "player/demo/demo_speaker.h"

namespace rocinante {

/// The planner's part of one turn: the gantry's way and the arm's path as drawings that come, fade
/// and go, the events "picked" and "placed", and a shared view of the lid. Begins at `start`.
void sayPlanner(DemoSpeaker& speaker, Nanoseconds start, Nanoseconds restate_period,
                std::size_t mtu_bytes);

}  // namespace rocinante
