#pragma once

#include <cstdint>
#include <vector>

#include "core/model/mesh.h"

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

/// Pure. Costs about a sort of the triangles; gives up looking (and finds nothing more) after some
/// millions of overlapping boxes, so that no file can hold it up.
CoplanarSurfaces coplanarSurfaces(const Mesh& mesh);

}  // namespace rocinante
