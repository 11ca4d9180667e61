#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace rocinante {

/// The usual signs of a player; those of events have a shape of their own, a diamond.
enum class TransportSign {
  to_start,
  step_back,
  play,
  play_back,
  pause,
  step_on,
  to_end,
  event_before,
  event_after
};

struct SignPoint {
  float x = 0, y = 0;
};

/// A convex part of a sign, in a square from 0 to 1, y downwards; its corners go round clockwise on
/// the screen.
struct SignPart {
  std::array<SignPoint, 4> corners{};
  std::size_t count = 0;
};

/// Pure.
std::vector<SignPart> partsOf(TransportSign sign);

/// Draws a button with the sign in the present ImGui window; true when it is pressed, and again and
/// again while it is held, if it `repeats`. `id`: unique there. `words`: on hover.
bool drawSignButton(const char* id, TransportSign sign, const char* words, bool repeats = false);

}  // namespace rocinante
