#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "viewer/shown/short_names.h"

namespace rocinante {

constexpr float kPanelMargin = 10;
constexpr float kDevicePanelWidth = 300;
constexpr float kTimeBarHeight = 92;
constexpr float kLeastDeviceHeight = 90;  ///< less would show no value

/// Height of a list of `rows`: all of them if there is room, at least three. Pure.
float listHeight(std::size_t rows, float row_height, float room);

/// The text with line breaks at spaces, so that each line has room; a word that is wider is left
/// whole. A number stays on the line of its unit: of a word of at most four bytes behind it ("0.12
/// mm"), where both have room together. Its own line breaks stay. Pure.
std::string inLines(std::string_view text, float room, const TextWidth& width);

/// Wide enough for the names of its tabs; a live session has one more.
constexpr float scenePanelWidth(bool live) { return live ? 380 : 316; }

}  // namespace rocinante
