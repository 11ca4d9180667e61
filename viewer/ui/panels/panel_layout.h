#pragma once

#include <cstddef>

namespace rocinante {

/// The panels that fit a window: a small one drops most of the figures first and the time line
/// last, so that panels never overlap.
struct PanelLayout {
  enum class Figures { none, brief, full };
  bool scene = false;
  Figures figures = Figures::none;
  bool device = false;  ///< values of the selection; also depends on its panel's top
};

constexpr float kPanelMargin = 10;
constexpr float kDevicePanelWidth = 300;
constexpr float kTimeBarHeight = 112;     ///< with the margin above and below it
constexpr float kLeastDeviceHeight = 90;  ///< less would show no value

/// Height of a list of `rows`: all of them if there is room, at least three. Pure.
float listHeight(std::size_t rows, float row_height, float room);

/// Wide enough for the names of its tabs; a live session has one more.
constexpr float scenePanelWidth(bool live) { return live ? 380 : 316; }

/// The layout of a window of that size, in interface units (pixels at scale 1). Pure.
PanelLayout panelLayout(float width, float height, bool live, bool has_time, bool any_selected);

}  // namespace rocinante
