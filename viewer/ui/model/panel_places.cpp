#include "viewer/ui/model/panel_places.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rocinante {
namespace {

/// The start of a stretch of `length` that is nearest to `start` among `wanted`, if within reach.
float nearest(float start, std::span<const float> wanted, float reach) {
  float best = start;
  float best_distance = reach;
  for (const float place : wanted) {
    const float distance = std::abs(place - start);
    if (distance <= best_distance) {
      best_distance = distance;
      best = place;
    }
  }
  return best;
}

bool overlap(float start_a, float length_a, float start_b, float length_b) {
  return start_a < start_b + length_b && start_b < start_a + length_a;
}

}  // namespace

const PanelPlace* PanelPlaces::find(const std::string& panel) const {
  const auto found = places.find(panel);
  return found == places.end() ? nullptr : &found->second;
}

PanelRectangle snapped(PanelRectangle moving, std::span<const PanelRectangle> others,
                       float window_width, float window_height, float margin, float reach) {
  std::vector<float> lefts{margin, window_width - margin - moving.width};
  std::vector<float> tops{margin, window_height - margin - moving.height};
  for (const PanelRectangle& other : others) {
    // Edges in line, or side by side.
    if (overlap(moving.y, moving.height + margin + reach, other.y, other.height + margin + reach)) {
      lefts.insert(lefts.end(), {other.x, other.x + other.width - moving.width,
                                 other.x + other.width + margin, other.x - margin - moving.width});
    }
    if (overlap(moving.x, moving.width + margin + reach, other.x, other.width + margin + reach)) {
      tops.insert(tops.end(), {other.y, other.y + other.height - moving.height,
                               other.y + other.height + margin, other.y - margin - moving.height});
    }
  }
  moving.x = nearest(moving.x, lefts, reach);
  moving.y = nearest(moving.y, tops, reach);
  moving.x = std::clamp(moving.x, 0.0F, std::max(0.0F, window_width - moving.width));
  moving.y = std::clamp(moving.y, 0.0F, std::max(0.0F, window_height - moving.height));
  return moving;
}

PanelPlace placeOf(const PanelRectangle& panel, float window_width, float window_height) {
  PanelPlace place;
  place.moved = true;
  const float right = window_width - panel.x - panel.width;
  const float bottom = window_height - panel.y - panel.height;
  place.from_right = right < panel.x;
  place.from_bottom = bottom < panel.y;
  place.across = place.from_right ? right : panel.x;
  place.down = place.from_bottom ? bottom : panel.y;
  return place;
}

PanelRectangle rectangleOf(const PanelPlace& place, float width, float height, float window_width,
                           float window_height) {
  PanelRectangle panel{place.across, place.down, width, height};
  if (place.from_right) panel.x = window_width - width - place.across;
  if (place.from_bottom) panel.y = window_height - height - place.down;
  panel.x = std::clamp(panel.x, 0.0F, std::max(0.0F, window_width - width));
  panel.y = std::clamp(panel.y, 0.0F, std::max(0.0F, window_height - height));
  return panel;
}

}  // namespace rocinante
