#include "viewer/ui/panels/panel_layout.h"

#include <algorithm>

namespace rocinante {

float listHeight(std::size_t rows, float row_height, float room) {
  constexpr float kLeastRows = 3;
  const float wanted = static_cast<float>(rows) * row_height;
  return std::max(std::min(wanted, room), kLeastRows * row_height);
}

}  // namespace rocinante
