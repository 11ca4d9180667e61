#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/mesh/mesh.h"
#include "viewer/cull/draw_list.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Overlapping surfaces of different parts in one plane would z-fight. Two kinds occur in real
/// models, each with its rule:
///
/// - both look the same way (a window painted onto its wall): the part with less area in all stands
///   one rank above the one with more, equal areas by their order in the file;
/// - they look opposite ways (a face with another material on its back, as SketchUp writes every
///   face): each is seen from its front alone.
struct CoplanarSurfaces {
  /// By part: the rank by which it is lifted, 0 to 15.
  std::vector<std::uint32_t> ranks;
  /// By triangle (three indices): non-zero when only its front is visible.
  std::vector<std::uint8_t> one_sided;
  bool any_one_sided = false;
};

using FlatCorners = std::array<Vec2, 3>;

/// Whether the insides of two triangles in one plane overlap by more than `slack`.
bool trianglesOverlap(const FlatCorners& a, const FlatCorners& b, double slack);

/// Pure. Costs about a sort of the triangles; stops after some millions of overlapping boxes, so
/// that no file can stall it.
///
/// `bodies`, by part: parts with different numbers may move apart, so their triangles do not become
/// one-sided. Empty: all are one body.
CoplanarSurfaces coplanarSurfaces(const Mesh& mesh, const std::vector<std::uint32_t>& bodies = {});

/// A list whose items may be lifted, with its catalog. Borrowed.
struct LiftedList {
  DrawList* list = nullptr;
  const SceneCatalog* catalog = nullptr;
};

/// Lifts surfaces of different visuals (of a link, of several links or devices) that currently lie
/// in one plane: docs/rendering.md, "Surfaces in one plane". The lift is larger than the distance
/// limit, so that the same surface shows while poses vibrate. Pure: the same items give the same
/// lifts in any order of devices. Stops after some hundred thousand pairs of neighbouring parts.
void liftCoplanarItems(std::span<const LiftedList> lists, const PosedScene& scene,
                       const Camera& camera);

}  // namespace rocinante
