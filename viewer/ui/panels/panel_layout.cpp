#include "viewer/ui/panels/panel_layout.h"

#include <algorithm>

namespace rocinante {

float listHeight(std::size_t rows, float row_height, float room) {
  constexpr float kLeastRows = 3;
  const float wanted = static_cast<float>(rows) * row_height;
  return std::max(std::min(wanted, room), kLeastRows * row_height);
}

PanelLayout panelLayout(float width, float height, bool live, bool has_time, bool any_selected) {
  const float usable = height - kPanelMargin - (has_time ? kTimeBarHeight : kPanelMargin);
  constexpr float kBriefWidth = 130;
  constexpr float kFullWidth = 280;
  constexpr float kFullHeight = 130;
  PanelLayout layout;
  const float scene_width = scenePanelWidth(live);
  layout.scene = width >= scene_width + kBriefWidth + 4 * kPanelMargin && usable >= 150;
  const float beside = layout.scene ? scene_width + kPanelMargin : 0;
  const bool device_fits = width >= beside + kDevicePanelWidth + 2 * kPanelMargin;
  const float wanted =
      any_selected && device_fits ? kFullHeight + 2 * kLeastDeviceHeight : kFullHeight;
  if (width >= beside + kFullWidth + 2 * kPanelMargin && usable >= wanted) {
    layout.figures = PanelLayout::Figures::full;
  } else if (width >= beside + kBriefWidth + 2 * kPanelMargin && usable >= 60) {
    layout.figures = PanelLayout::Figures::brief;
  }
  // In a very small window it would cover the selection.
  layout.device = any_selected && device_fits && usable >= 60 + kLeastDeviceHeight + 50;
  return layout;
}

}  // namespace rocinante
