#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/gtc/matrix_inverse.hpp>
#include <tuple>
#include <utility>

#include "core/math/transform.h"
#include "viewer/cull/draw_list.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxItems = 2000;
constexpr double kInsideSlack = 1e-6;

struct Box {
  const DrawItem* item = nullptr;
  const CatalogPart* part = nullptr;
  Vec3 center;
  double radius = 0;
};

/// A box with volume that does not contain the eye, and its local space.
struct Container {
  Mat4 own_from_world;
  bool possible = false;
};

bool isInside(const CatalogPart& part, const Vec3& at) {
  const Vec3 off = at - part.center;
  for (int axis = 0; axis < 3; ++axis) {
    // Negated so that NaN is inside of nothing.
    if (!(std::abs(off[axis]) <= part.half[axis] * (1 + kInsideSlack))) return false;
  }
  return true;
}

Container containerOf(const Box& box, const Camera& camera) {
  const Vec3& half = box.part->half;
  const Mat4& world = box.item->world;
  if (!(half.x > 0 && half.y > 0 && half.z > 0)) return {};
  if (!(std::abs(glm::determinant(glm::dmat3(world))) > 0)) return {};
  const Container made{glm::affineInverse(world), true};
  const bool eye_inside = !camera.orthographic() &&
                          isInside(*box.part, transformPoint(made.own_from_world, camera.eye()));
  return eye_inside ? Container{} : made;
}

bool holds(const Box& outer, const Container& container, const Box& inner) {
  // A box of equal size may be the same object.
  if (!(inner.radius < outer.radius * (1 - 1e-3))) return false;
  if (!(lengthOf(inner.center - outer.center) <= outer.radius)) return false;
  const Mat4 own = container.own_from_world * inner.item->world;
  for (unsigned k = 0; k < 8; ++k) {
    const Vec3 sign((k & 1U) != 0 ? 1 : -1, (k & 2U) != 0 ? 1 : -1, (k & 4U) != 0 ? 1 : -1);
    const Vec3 corner = inner.part->center + sign * inner.part->half;
    if (!isInside(*outer.part, transformPoint(own, corner))) return false;
  }
  return true;
}

}  // namespace

void sortFromBackToFront(std::vector<DrawItem>& items, const SceneCatalog& catalog,
                         const Camera& camera) {
  struct Place {
    double distance;
    std::size_t held;  ///< number of boxes inside; of nested boxes the outer comes last
    std::size_t number;
  };
  std::vector<Place> places;
  std::vector<Box> boxes;
  for (const DrawItem& item : items) {
    places.push_back({item.distance, 0, places.size()});
    const CatalogPart& part = catalog.meshes()[item.mesh].parts[item.part];
    const Mat4& m = item.world;
    const Vec3 across(m[0] * part.half.x + m[1] * part.half.y + m[2] * part.half.z);
    boxes.push_back({&item, &part, transformPoint(m, part.center), 0});
    // In an unevenly scaled box another diagonal may be longer.
    double longest = lengthOf(across);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 other = across - Vec3(m[axis]) * (2 * part.half[axis]);
      longest = std::max(longest, lengthOf(other));
    }
    boxes.back().radius = longest;
  }
  for (std::size_t b = 0; b < boxes.size() && boxes.size() <= kMaxItems; ++b) {
    const Container container = containerOf(boxes[b], camera);
    if (!container.possible) continue;
    for (const Box& inner : boxes) {
      if (!holds(boxes[b], container, inner)) continue;
      places[b].distance = std::min(places[b].distance, inner.item->distance);
      places[b].held += 1;
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tuple(-a.distance, a.held, a.number) < std::tuple(-b.distance, b.held, b.number);
  });
  std::vector<DrawItem> sorted;
  sorted.reserve(items.size());
  for (const Place& place : places) sorted.push_back(items[place.number]);
  items = std::move(sorted);
}

}  // namespace rocinante
