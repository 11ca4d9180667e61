#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/math/vector.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// A side from which a scene is seen: -1, 0 or 1 along the world's x (the front is at 1), y (the
/// left) and z (the top). One of them alone is a face of a cube, two an edge, three a corner.
struct ViewSide {
  int x = 0, y = 0, z = 0;
  bool operator==(const ViewSide&) const = default;

  int operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// "top", "front left", "bottom back right": in this order.
std::string nameOf(const ViewSide& side);
/// The side of these words, in any order; "isometric" alone is "top front right". Empty for other
/// words, opposite ones, a word twice, and none.
std::optional<ViewSide> viewSideOf(std::span<const std::string> words);
/// From the target to the eye, of unit length.
Vec3 directionFrom(const ViewSide& side);

/// The axes of a picture in the world: unit vectors to its right, to its top, and into it.
struct ViewAxes {
  Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};
};

/// A part of a cube that shows from where the scene is seen; drawn without perspective.
struct CubePatch {
  ViewSide face;                ///< the face that it lies in
  std::array<Vec2, 4> corners;  ///< clockwise, from the cube's middle, in its half edges; y down
  double facing = 0;            ///< 1: seen from straight before it, above 0
};

/// The faces of the cube that can be seen, one to three. They do not overlap. Pure.
std::vector<CubePatch> visibleFaces(const ViewAxes& axes);
/// What can be seen of the part of the cube that stands for the side: of a corner up to three
/// patches, one a face. Pure.
std::vector<CubePatch> visiblePatches(const ViewAxes& axes, const ViewSide& side);
/// The side whose part of the cube is there, as CubePatch has its places; empty: beside the cube.
/// Pure.
std::optional<ViewSide> cubeSideAt(const ViewAxes& axes, const Vec2& at);

/// Where a square of `size` lies in `room`, all in pixels: at the top right, with a margin, below
/// what is in its way; without room there, to the left of it. Empty where it would cover more than
/// a third of the room's width or height, or lie over any of `others`. Pure.
std::optional<PixelRectangle> placeViewCube(const PixelRectangle& room,
                                            std::span<const PixelRectangle> others, int size,
                                            int margin);

}  // namespace rocinante
