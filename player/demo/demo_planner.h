#pragma once

#include <cstddef>

#include "core/base/time.h"
#include "player/demo/demo_speaker.h"

namespace rocinante {

/// The planner's part of one turn: the gantry's and the arm's paths as drawings that appear, fade
/// and disappear, the events "picked" and "placed", and a shared view of the lid. Begins at
/// `start`.
void sayPlanner(DemoSpeaker& speaker, Nanoseconds start, Nanoseconds restate_period,
                std::size_t mtu_bytes);

}  // namespace rocinante
