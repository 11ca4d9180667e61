#include "viewer/ui/model/view_cube.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rocinante {
namespace {

/// Of a face's half edge: what is nearer to its middle belongs to the face, the rest to its edges
/// and corners.
constexpr double kMiddle = 0.58;

struct SideWord {
  const char* word;
  int axis, sign;
};
/// In the order of names.
constexpr std::array kWords{SideWord{"top", 2, 1},   SideWord{"bottom", 2, -1},
                            SideWord{"front", 0, 1}, SideWord{"back", 0, -1},
                            SideWord{"left", 1, 1},  SideWord{"right", 1, -1}};

int& along(ViewSide& side, int axis) { return axis == 0 ? side.x : axis == 1 ? side.y : side.z; }

Vec2 shown(const ViewAxes& axes, const Vec3& point) {
  return {dotOf(point, axes.right), -dotOf(point, axes.up)};
}

/// Twice the area, above 0 for a clockwise order where y points down.
double turnOf(const std::array<Vec2, 4>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& from = corners[i];
    const Vec2& to = corners[(i + 1) % corners.size()];
    area += from.x * to.y - to.x * from.y;
  }
  return area;
}

/// From, to: of the face's other two axes, in half edges.
using Span = std::pair<double, double>;

/// A rectangle in the face of that axis and sign; empty when it faces away.
std::optional<CubePatch> patchOf(const ViewAxes& axes, int axis, int sign, const Span& first,
                                 const Span& second) {
  CubePatch patch;
  patch.facing = -sign * axes.forward[axis];
  if (patch.facing < 1e-6) return std::nullopt;
  along(patch.face, axis) = sign;
  const auto corner = [&](double a, double b) {
    Vec3 point(0, 0, 0);
    point[axis] = sign;
    point[(axis + 1) % 3] = a;
    point[(axis + 2) % 3] = b;
    return shown(axes, point);
  };
  patch.corners = {corner(first.first, second.first), corner(first.second, second.first),
                   corner(first.second, second.second), corner(first.first, second.second)};
  if (turnOf(patch.corners) < 0) std::ranges::reverse(patch.corners);
  return patch;
}

Span partSpan(int part) {
  if (part == 0) return {-kMiddle, kMiddle};
  return part > 0 ? Span(kMiddle, 1) : Span(-1, -kMiddle);
}

int partOf(double place) { return std::abs(place) <= kMiddle ? 0 : place > 0 ? 1 : -1; }

}  // namespace

std::string nameOf(const ViewSide& side) {
  std::string name;
  for (const SideWord& one : kWords) {
    if (side[one.axis] == one.sign) name += (name.empty() ? "" : " ") + std::string(one.word);
  }
  return name;
}

std::optional<ViewSide> viewSideOf(std::span<const std::string> words) {
  if (words.size() == 1 && words[0] == "isometric") return ViewSide{1, -1, 1};
  ViewSide side;
  for (const std::string& word : words) {
    const auto known = std::ranges::find(kWords, word, &SideWord::word);
    if (known == kWords.end() || side[known->axis] != 0) return std::nullopt;
    along(side, known->axis) = known->sign;
  }
  if (words.empty()) return std::nullopt;
  return side;
}

Vec3 directionFrom(const ViewSide& side) {
  const Vec3 way(side.x, side.y, side.z);
  const double length = lengthOf(way);
  return length > 0 ? way / length : Vec3(1, 0, 0);
}

std::vector<CubePatch> visibleFaces(const ViewAxes& axes) {
  std::vector<CubePatch> faces;
  for (const SideWord& one : kWords) {
    if (auto face = patchOf(axes, one.axis, one.sign, {-1, 1}, {-1, 1})) faces.push_back(*face);
  }
  return faces;
}

std::vector<CubePatch> visiblePatches(const ViewAxes& axes, const ViewSide& side) {
  std::vector<CubePatch> patches;
  for (int axis = 0; axis < 3; ++axis) {
    if (side[axis] == 0) continue;
    if (auto patch = patchOf(axes, axis, side[axis], partSpan(side[(axis + 1) % 3]),
                             partSpan(side[(axis + 2) % 3]))) {
      patches.push_back(*patch);
    }
  }
  return patches;
}

std::optional<ViewSide> cubeSideAt(const ViewAxes& axes, const Vec2& at) {
  // A line into the picture enters the cube where it is inside of all three pairs of planes.
  const Vec3 from = axes.right * at.x - axes.up * at.y;
  double enters = -std::numeric_limits<double>::infinity();
  double leaves = -enters;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double speed = axes.forward[axis];
    if (std::abs(speed) < 1e-9) {
      if (std::abs(from[axis]) > 1) return std::nullopt;
      continue;
    }
    const double near = ((speed > 0 ? -1 : 1) - from[axis]) / speed;
    const double far = ((speed > 0 ? 1 : -1) - from[axis]) / speed;
    if (near > enters) {
      enters = near;
      face = axis;
    }
    leaves = std::min(leaves, far);
  }
  if (!(enters <= leaves)) return std::nullopt;
  const Vec3 point = from + axes.forward * enters;
  ViewSide side;
  for (int axis = 0; axis < 3; ++axis) along(side, axis) = partOf(point[axis]);
  along(side, face) = axes.forward[face] > 0 ? -1 : 1;
  return side;
}

std::optional<PixelRectangle> placeViewCube(const PixelRectangle& room,
                                            std::span<const PixelRectangle> others, int size,
                                            int margin) {
  const int taken = size + margin;
  if (taken * 3 > room.width || taken * 3 > room.height) return std::nullopt;
  const PixelRectangle first{room.x + room.width - taken, room.y + margin, size, size};
  PixelRectangle place = first;
  const auto inTheWay = [&] {
    const auto found = std::ranges::find_if(
        others, [&](const PixelRectangle& other) { return overlapOf(place, other).width > 0; });
    return found == others.end() ? nullptr : &*found;
  };
  while (place.y + 2 * taken <= room.y + room.height) {
    const PixelRectangle* const other = inTheWay();
    if (other == nullptr) return place;
    place.y = other->y + other->height + margin;
  }
  place = first;
  while (place.x >= room.x + margin) {
    const PixelRectangle* const other = inTheWay();
    if (other == nullptr) return place;
    place.x = other->x - taken;
  }
  return std::nullopt;
}

}  // namespace rocinante
