#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

#include "core/math/transform.h"
#include "viewer/cull/coplanar_surfaces.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kMaxRanks = 15;
constexpr std::size_t kMaxTests = 400'000;
constexpr std::size_t kMaxTriangles = 20'000;
/// Planes this close count as one: a twentieth of a millimetre, a thousandth of a small face, or
/// the float error of a large one.
constexpr double kNear_m = 5e-5;
constexpr double kNearShare = 1e-3;
constexpr double kRounding = 1e-6;

/// An item with its bounding box in world space.
struct Candidate {
  DrawItem* item = nullptr;
  const CatalogPart* part = nullptr;
  const Mesh* mesh = nullptr;
  Vec3 center, half;
  double area = 0;
};

struct WorldFace {
  Vec3 normal, center, half;
};

Vec3 halfInWorld(const Mat4& m, const Vec3& half) {
  Vec3 world;
  for (int row = 0; row < 3; ++row) {
    world[row] =
        std::abs(m[0][row]) * half.x + std::abs(m[1][row]) * half.y + std::abs(m[2][row]) * half.z;
  }
  return world;
}

WorldFace worldFace(const DrawItem& item, const FlatFace& face) {
  const Mat4& m = item.world;
  const Vec3 x(m[0]);
  const Vec3 y(m[1]);
  const Vec3 z(m[2]);
  Vec3 normal =
      crossOf(y, z) * face.normal.x + crossOf(z, x) * face.normal.y + crossOf(x, y) * face.normal.z;
  const double length = lengthOf(normal);
  normal = length > 0 ? normal / (item.mirrored ? -length : length) : Vec3(0, 0, 0);
  return {normal, transformPoint(m, face.center), halfInWorld(m, face.half)};
}

bool boxesMeet(const Vec3& a, const Vec3& a_half, const Vec3& b, const Vec3& b_half, double slack) {
  for (int axis = 0; axis < 3; ++axis) {
    // Negated so that NaN meets nothing.
    if (!(std::abs(a[axis] - b[axis]) <= a_half[axis] + b_half[axis] + slack)) return false;
  }
  return true;
}

/// Largest distance of the planes of two faces that cover each other; 0: they are not one plane.
double nearness(const WorldFace& above, const WorldFace& below) {
  const double small = 2 * std::min(lengthOf(above.half), lengthOf(below.half));
  const double large = 2 * std::max(lengthOf(above.half), lengthOf(below.half));
  const double near = std::max(std::min(kNear_m, kNearShare * small), kRounding * large);
  if (!boxesMeet(above.center, above.half, below.center, below.half, near)) return 0;
  // Faces side by side do not overlap: they must share more than that along at least two axes.
  int shared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double overlap =
        above.half[axis] + below.half[axis] - std::abs(above.center[axis] - below.center[axis]);
    shared += overlap > 2 * near ? 1 : 0;
  }
  if (shared < 2) return 0;
  const double off = std::abs(dotOf(below.normal, above.center - below.center));
  const Vec3 turned = crossOf(above.normal, below.normal);
  return off <= near && lengthOf(turned) * small <= 2 * near ? near : 0;
}

/// The triangles of a face that reach into a box, projected along a world axis.
std::vector<FlatCorners> flattened(const Candidate& one, const FlatFace& face, int along,
                                   const WorldFace& box) {
  std::vector<FlatCorners> triangles;
  for (const std::uint32_t first : face.triangles) {
    Vec3 low(1e300, 1e300, 1e300);
    Vec3 high(-1e300, -1e300, -1e300);
    FlatCorners flat;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vertex& vertex = one.mesh->vertices[one.mesh->indices[first + k]];
      const Vec3 at = transformPoint(one.item->world, Vec3(vertex.position));
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
      flat[k] = Vec2(at[(along + 1) % 3], at[(along + 2) % 3]);
    }
    if (boxesMeet((low + high) * 0.5, (high - low) * 0.5, box.center, box.half, kNear_m)) {
      triangles.push_back(flat);
    }
  }
  return triangles;
}

/// Whether two faces in one plane overlap. Faces with too many triangles to test count as
/// overlapping.
bool cover(const Candidate& one, const FlatFace& face, const WorldFace& where,
           const Candidate& other, const FlatFace& other_face, const WorldFace& other_where,
           double slack) {
  if (face.triangles.size() + other_face.triangles.size() > kMaxTriangles) return true;
  int along = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(where.normal[axis]) > std::abs(where.normal[along])) along = axis;
  }
  const auto mine = flattened(one, face, along, other_where);
  const auto others = flattened(other, other_face, along, where);
  if (mine.size() * others.size() > kMaxTriangles) return true;
  for (const FlatCorners& a : mine) {
    for (const FlatCorners& b : others) {
      if (trianglesOverlap(a, b, slack)) return true;
    }
  }
  return false;
}

/// Distance limit of the planes in which `above` lies on `below`; 0: it does not.
double liesOn(const Candidate& above, const Candidate& below) {
  std::vector<std::pair<const FlatFace*, WorldFace>> others;
  for (const FlatFace& face : below.part->faces.faces) {
    const WorldFace other = worldFace(*below.item, face);
    if (boxesMeet(other.center, other.half, above.center, above.half, kNear_m)) {
      others.emplace_back(&face, other);
    }
  }
  if (others.empty()) return 0;
  for (const FlatFace& a : above.part->faces.faces) {
    const WorldFace face = worldFace(*above.item, a);
    if (!boxesMeet(face.center, face.half, below.center, below.half, kNear_m)) continue;
    for (const auto& [b, other] : others) {
      const double facing = dotOf(face.normal, other.normal);
      if (!(std::abs(facing) > 0.9)) continue;
      // Where solids touch, neither side is visible.
      if (facing < 0 && !above.part->faces.sheet) continue;
      const double near = nearness(face, other);
      if (near > 0 && cover(above, a, face, below, *b, other, near)) return near;
    }
  }
  return 0;
}

bool ofOneVisual(const DrawItem& a, const DrawItem& b) {
  return a.mesh == b.mesh && a.device == b.device && a.link == b.link &&
         std::memcmp(&a.world, &b.world, sizeof a.world) == 0;
}

/// Translucent items are drawn later, which decides where depths are equal.
bool fallTogether(const DrawItem& a, const DrawItem& b) {
  return a.mesh == b.mesh && a.translucent != b.translucent &&
         std::memcmp(&a.world, &b.world, sizeof a.world) == 0;
}

/// Which of two equal-looking items shows is invisible, but other faces of a lifted solid might
/// show.
bool lookAlike(const DrawItem& a, const DrawItem& b) {
  const auto look = [](const DrawItem& item) {
    const Material& material = *item.material;
    return std::tie(material.specular, material.emission, material.shininess);
  };
  return a.texture < 0 && b.texture < 0 && !a.tinted && !b.tinted && a.diffuse == b.diffuse &&
         !a.translucent && look(a) == look(b);
}

/// Which item lies on top: translucent over opaque, then the smaller one, then by name.
bool belongsBelow(const Candidate& a, const Candidate& b, const PosedScene& scene) {
  if (a.item->translucent != b.item->translucent) return b.item->translucent;
  if (std::abs(a.area - b.area) > 1e-6 * (a.area + b.area)) return a.area > b.area;
  const auto key = [&](const DrawItem& item) {
    return std::tie(scene.devices[item.device].name, item.link, item.mesh, item.part);
  };
  return key(*a.item) < key(*b.item);
}

/// `metres` at the item in units of depth (glPolygonOffset).
float unitsOf(double metres, const DrawItem& item, const Camera& camera) {
  constexpr double kUnits = 1 << 24;
  double depth = 0;
  if (camera.orthographic()) {
    depth = metres * 0.25 / (camera.depthAt(0.25) - camera.depthAt(0.5));
  } else {
    depth = metres / std::max(item.distance, camera.near());
  }
  return static_cast<float>(std::min(depth, 1e-2) * kUnits);
}

/// The common case of a crowd: thousands of parts that look alike.
bool allLookAlike(std::span<const LiftedList> lists) {
  const DrawItem* first = nullptr;
  for (const LiftedList& one : lists) {
    for (const auto* items : {&one.list->opaque, &one.list->translucent}) {
      for (const DrawItem& item : *items) {
        if (one.catalog->meshes()[item.mesh].parts[item.part].faces.faces.empty()) continue;
        if (first == nullptr) first = &item;
        if (!lookAlike(item, *first)) return false;
      }
    }
  }
  return true;
}

std::vector<Candidate> candidatesOf(std::span<const LiftedList> lists) {
  std::vector<Candidate> candidates;
  for (const LiftedList& one : lists) {
    for (auto* items : {&one.list->opaque, &one.list->translucent}) {
      for (DrawItem& item : *items) {
        const CatalogPart& part = one.catalog->meshes()[item.mesh].parts[item.part];
        if (part.faces.faces.empty()) continue;
        const double scale = scaleBound(item.world);
        candidates.push_back({&item, &part, one.catalog->meshes()[item.mesh].mesh,
                              transformPoint(item.world, part.center),
                              halfInWorld(item.world, part.half), part.faces.area * scale * scale});
      }
    }
  }
  return candidates;
}

}  // namespace

void liftCoplanarItems(std::span<const LiftedList> lists, const PosedScene& scene,
                       const Camera& camera) {
  if (allLookAlike(lists)) return;
  std::vector<Candidate> candidates = candidatesOf(lists);
  // Sweep along x: only boxes with overlapping ranges are tested.
  const auto left = [](const Candidate& one) { return one.center.x - one.half.x; };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](const Candidate& one) { return std::isnan(left(one)); }),
                   candidates.end());
  std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
    if (left(a) != left(b)) return left(a) < left(b);
    return belongsBelow(a, b, scene);
  });
  struct Pair {
    DrawItem *above, *below;
    double near;
  };
  std::vector<Pair> pairs;
  std::size_t tests = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double right = candidates[i].center.x + candidates[i].half.x + kNear_m;
    for (std::size_t j = i + 1; j < candidates.size() && left(candidates[j]) <= right; ++j) {
      if (++tests > kMaxTests) break;
      const Candidate& a = candidates[i];
      const Candidate& b = candidates[j];
      if (!boxesMeet(a.center, a.half, b.center, b.half, kNear_m)) continue;
      if (ofOneVisual(*a.item, *b.item) || fallTogether(*a.item, *b.item)) continue;
      if (lookAlike(*a.item, *b.item)) continue;
      const bool b_above = belongsBelow(a, b, scene);
      const double near = b_above ? liesOn(b, a) : liesOn(a, b);
      if (near > 0) pairs.push_back({b_above ? b.item : a.item, b_above ? a.item : b.item, near});
    }
  }
  // Lift each item above all items below it, which may lie on others.
  bool changed = !pairs.empty();
  for (std::uint32_t round = 0; changed && round < kMaxRanks; ++round) {
    changed = false;
    for (const Pair& pair : pairs) {
      const std::uint32_t rank = std::min(pair.below->coplanar_rank + 1, kMaxRanks);
      const float units = pair.below->lift_units + unitsOf(2 * pair.near, *pair.above, camera);
      if (pair.above->coplanar_rank >= rank && pair.above->lift_units >= units) continue;
      pair.above->coplanar_rank = std::max(pair.above->coplanar_rank, rank);
      pair.above->lift_units = std::max(pair.above->lift_units, units);
      changed = true;
    }
  }
}

}  // namespace rocinante
