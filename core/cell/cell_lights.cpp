#include <fmt/format.h>

#include "core/cell/cell_sections.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

// Each is a term in the shader of all surfaces.
constexpr std::size_t kMaxLights = 8;
constexpr double kMaxStrength = 100;

}  // namespace

void readLights(TomlTable& root, CellNames& names, Cell& cell) {
  for (TomlTable& table : root.tables("light", "[[light]]")) {
    CellLight light;
    const auto name = names.take(table);
    const auto direction = table.requiredVector("direction");
    if (const auto color = table.color("color")) light.color = glm::vec3(*color);
    if (const auto strength = table.number("strength")) {
      if (*strength >= 0 && *strength <= kMaxStrength) {
        light.strength = *strength;
      } else {
        table.error("cell.bad-number", "strength", "`strength` is between 0 and 100");
      }
    }
    table.finish();
    if (direction && !normalized(*direction)) {
      table.error("cell.no-direction", "direction", "`direction` has no length");
      continue;
    }
    if (!name || !direction) continue;
    light.direction = *direction;
    if (cell.scene.lights.size() == kMaxLights) {
      table.error("cell.too-many", "name",
                  fmt::format("the cell has more than {} lights", kMaxLights));
      return;
    }
    cell.scene.lights.push_back(light);
  }
}

void finishLights(Cell& cell) {
  if (cell.scene.lights.empty()) return;
  cell.scene.light_direction = glm::vec3(cell.scene.lights.front().direction);
}

}  // namespace rocinante
