#pragma once

#include <cstddef>

namespace rocinante {

/// Which panels a window has room for: in a small one they leave themselves out, most of the
/// figures first and the time line last, so that they never lie over one another.
struct PanelLayout {
  enum class Figures { none, brief, full };
  bool scene = false;
  Figures figures = Figures::none;
  bool device = false;  ///< values of what is selected; where its panel begins decides too
};

constexpr float kPanelMargin = 10;
constexpr float kScenePanelWidth = 292;
constexpr float kDevicePanelWidth = 300;
constexpr float kTimeBarHeight = 70;      ///< with the margin above and below it
constexpr float kLeastDeviceHeight = 90;  ///< less would show no value

/// How high a list of so many rows is: as high as they are where there is room, and never less than
/// three of them. Pure.
float listHeight(std::size_t rows, float row_height, float room);

/// Of a window of that size, in units of the interface (pixels at scale 1). Pure.
PanelLayout panelLayout(float width, float height, bool has_time, bool any_selected);

}  // namespace rocinante
