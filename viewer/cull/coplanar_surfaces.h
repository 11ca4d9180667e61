#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace rocinante {

/// Surfaces of different parts that lie in one plane and overlap would fight for every pixel, and
/// rounding would decide. Two kinds occur in real models, and each has its rule:
///
/// - both look the same way (a window painted onto its wall): the part with less area in all stands
///   one rank above the one with more, equal areas by their order in the file;
/// - they look opposite ways (a face with another material on its back, as SketchUp writes every
///   face): each is seen from its front alone.
struct CoplanarSurfaces {
  /// By part: how far it is to be lifted off what it lies in. 0 to 15.
  std::vector<std::uint32_t> ranks;
  /// By triangle (three indices): non-zero when it is seen from its front alone.
  std::vector<std::uint8_t> one_sided;
  bool any_one_sided = false;
};

using FlatCorners = std::array<Vec2, 3>;

/// Whether the insides of two triangles in one plane overlap by more than `slack`.
bool trianglesOverlap(const FlatCorners& a, const FlatCorners& b, double slack);

/// Pure. Costs about a sort of the triangles; gives up looking (and finds nothing more) after some
/// millions of overlapping boxes, so that no file can hold it up.
///
/// `bodies`, by part: of parts with different numbers, which may move apart, no triangle is seen
/// from one side alone. Empty: all are one body.
CoplanarSurfaces coplanarSurfaces(const Mesh& mesh, const std::vector<std::uint32_t>& bodies = {});

}  // namespace rocinante
