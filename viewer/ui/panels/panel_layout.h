#pragma once

#include <cstddef>

namespace rocinante {

constexpr float kPanelMargin = 10;
constexpr float kDevicePanelWidth = 300;
constexpr float kTimeBarHeight = 92;
constexpr float kLeastDeviceHeight = 90;  ///< less would show no value

/// Height of a list of `rows`: all of them if there is room, at least three. Pure.
float listHeight(std::size_t rows, float row_height, float room);

/// Wide enough for the names of its tabs; a live session has one more.
constexpr float scenePanelWidth(bool live) { return live ? 380 : 316; }

}  // namespace rocinante
