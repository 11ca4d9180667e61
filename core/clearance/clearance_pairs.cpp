#include "core/clearance/clearance_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/pattern.h"
#include "core/cell/layer_index.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr double kRoundWithin_m = 1e-5;
constexpr std::uint32_t kFewestSides = 24, kMaxSides = 1024;

bool isFinite(const Vec3& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

void add(const Solid& solid, std::vector<Solid>& solids) {
  for (const Vec3& corner : solid.triangle) {
    if (!isFinite(corner)) return;
  }
  solids.push_back(solid);
}

/// The sagitta of a side is r (1 - cos(pi / n)), below r * 5 / n^2.
std::uint32_t sidesFor(double radius_m) {
  const double sides = std::ceil(std::sqrt(5 * radius_m / kRoundWithin_m));
  if (!(sides < kMaxSides)) return kMaxSides;
  return std::max(kFewestSides, static_cast<std::uint32_t>(sides));
}

void addCylinder(const Mat4& placement, double radius_m, double length_m,
                 std::vector<Solid>& solids) {
  const std::uint32_t sides = sidesFor(radius_m);
  const auto corner = [&](std::uint32_t i, double z) {
    const double angle = 2 * kPi * static_cast<double>(i % sides) / static_cast<double>(sides);
    return transformPoint(placement, {radius_m * cosine(angle), radius_m * sine(angle), z});
  };
  const double top = length_m / 2;
  const Vec3 above = transformPoint(placement, {0, 0, top});
  const Vec3 below = transformPoint(placement, {0, 0, -top});
  for (std::uint32_t i = 0; i < sides; ++i) {
    const Vec3 a = corner(i, -top), b = corner(i + 1, -top), c = corner(i + 1, top);
    const Vec3 d = corner(i, top);
    for (const Triangle& triangle :
         {Triangle{a, b, c}, Triangle{a, c, d}, Triangle{below, b, a}, Triangle{above, d, c}}) {
      add({triangle, 0}, solids);
    }
  }
}

/// Shapes that are better than their meshes; false when the triangles serve.
bool addShape(const Visual& visual, const Mat4& placement, std::vector<Solid>& solids) {
  const std::optional<ShapeSize>& shape = visual.mesh->shape;
  const Vec3& scale = visual.scale;
  if (!shape || scale.x != scale.y || scale.y != scale.z || !(scale.x > 0)) return false;
  const double radius = shape->size[0] * scale.x, length = shape->size[2] * scale.x;
  switch (shape->kind) {
    case ShapeSize::Kind::box:
      return false;
    case ShapeSize::Kind::sphere: {
      const Vec3 middle = positionOf(placement);
      add({{middle, middle, middle}, radius}, solids);
      return true;
    }
    case ShapeSize::Kind::capsule: {
      const Vec3 top = transformPoint(placement, {0, 0, length / 2});
      const Vec3 bottom = transformPoint(placement, {0, 0, -length / 2});
      add({{bottom, top, top}, radius}, solids);
      return true;
    }
    case ShapeSize::Kind::cylinder:
      addCylinder(placement, radius, length, solids);
      return true;
  }
  return false;
}

void addPart(const Mesh& mesh, const MeshPart& part, const Mat4& to_link,
             std::vector<Solid>& solids) {
  const std::size_t end =
      std::min<std::size_t>(std::size_t{part.first_index} + part.index_count, mesh.indices.size());
  for (std::size_t i = part.first_index; i + 2 < end; i += 3) {
    Solid solid;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = mesh.indices[i + corner];
      if (vertex >= mesh.vertices.size()) return;
      solid.triangle[corner] = transformPoint(to_link, Vec3(mesh.vertices[vertex].position));
    }
    add(solid, solids);
  }
}

void addVisual(const Visual& visual, std::vector<Solid>& solids) {
  if (!visual.mesh) return;
  const Mesh& mesh = *visual.mesh;
  const Mat4 placement = matrixOf(visual.origin);
  if (visual.mesh_parts.empty() && addShape(visual, placement, solids)) return;
  const Mat4 to_link = placement * scaleMatrix(visual.scale);
  if (visual.mesh_parts.empty()) {
    for (const MeshPart& part : mesh.parts) addPart(mesh, part, to_link, solids);
  }
  for (const std::size_t part : visual.mesh_parts) {
    if (part < mesh.parts.size()) addPart(mesh, mesh.parts[part], to_link, solids);
  }
}

/// The links that one pattern names.
using Members = std::vector<std::vector<bool>>;  // by device and link

class LinkPatterns {
 public:
  LinkPatterns(const Cell& cell, const PosedScene& scene, const CellPlacement& placement)
      : layers_(layerNames(cell)), scene_(scene), placement_(placement) {}

  const Members& named(const std::string& pattern) {
    const auto [found, is_new] = known_.try_emplace(pattern);
    if (is_new) found->second = find(pattern);
    return found->second;
  }

 private:
  Members find(const std::string& pattern) const {
    constexpr std::string_view kLayer = "layer/";
    std::vector<std::string_view> layers;
    if (pattern.starts_with(kLayer)) {
      const std::string_view wanted = std::string_view(pattern).substr(kLayer.size());
      for (const std::string& layer : layers_) {
        if (patternMatches(wanted, layer)) layers.push_back(layer);
      }
    }
    Members members;
    for (const PlacedDevice& device : placement_.devices) {
      const PosedDevice* const posed = scene_.findDevice(device.name);
      const bool is_whole = patternMatches(pattern, device.name);
      std::vector<bool>& links = members.emplace_back();
      for (std::size_t link = 0; link < device.model->links.size(); ++link) {
        const auto is_in = [&](std::string_view layer) {
          return posed != nullptr && posed->inLayer(layer, link);
        };
        links.push_back(
            is_whole || std::ranges::any_of(layers, is_in) ||
            patternMatches(pattern, device.name + "/" + device.model->links[link].name));
      }
    }
    return members;
  }

  std::set<std::string, std::less<>> layers_;
  const PosedScene& scene_;
  const CellPlacement& placement_;
  std::map<std::string, Members> known_;
};

/// By link: the first link of those that fixed joints join to it.
std::vector<std::size_t> rigidGroups(const Model& model) {
  std::vector<std::size_t> group(model.links.size());
  for (std::size_t link = 0; link < group.size(); ++link) group[link] = link;
  for (const std::size_t i : model.update_order) {
    const Joint& joint = model.joints[i];
    if (joint.type == JointType::fixed) group[joint.child] = group[joint.parent];
  }
  return group;
}

bool areAdjacent(const Model& model, const std::vector<std::size_t>& group, std::size_t a,
                 std::size_t b) {
  if (group[a] == group[b]) return true;
  return std::ranges::any_of(model.joints, [&](const Joint& joint) {
    const std::size_t parent = group[joint.parent], child = group[joint.child];
    return (parent == group[a] && child == group[b]) || (parent == group[b] && child == group[a]);
  });
}

class PairFinder {
 public:
  PairFinder(const Cell& cell, const PosedScene& scene, const CellPlacement& placement,
             BodyStore& bodies)
      : cell_(cell), placement_(placement), bodies_(bodies), patterns_(cell, scene, placement) {
    for (const PlacedDevice& device : placement.devices) {
      if (!groups_.contains(device.model)) groups_[device.model] = rigidGroups(*device.model);
    }
  }

  ClearancePairs find() {
    for (std::size_t i = 0; i < cell_.clearances.size(); ++i) {
      const std::size_t before = found_.pairs.size();
      findOf(i);
      if (found_.pairs.size() == before) found_.empty.push_back(i);
    }
    return std::move(found_);
  }

 private:
  void findOf(std::size_t clearance) {
    const CellClearance& wanted = cell_.clearances[clearance];
    const Members& first = patterns_.named(wanted.between.first);
    const Members& second = patterns_.named(wanted.between.second);
    std::vector<std::pair<const Members*, const Members*>> except;
    for (const ClearancePatterns& each : wanted.except) {
      except.emplace_back(&patterns_.named(each.first), &patterns_.named(each.second));
    }
    const auto is_either = [](const Members& x, const Members& y, LinkId a, LinkId b) {
      return (x[a.device][a.link] && y[b.device][b.link]) ||
             (x[b.device][b.link] && y[a.device][a.link]);
    };
    forEachPair(wanted.is_self, [&](LinkId a, LinkId b) {
      if (!is_either(first, second, a, b) || areJoined(a, b)) return;
      for (const auto& [x, y] : except) {
        if (is_either(*x, *y, a, b)) return;
      }
      add(clearance, a, b);
    });
  }

  template <class Each>
  void forEachPair(bool is_self, const Each& each) const {
    const auto linksOf = [&](std::size_t device) {
      return placement_.devices[device].model->links.size();
    };
    for (std::size_t a = 0; a < placement_.devices.size(); ++a) {
      for (std::size_t b = is_self ? a : a + 1; b < (is_self ? a + 1 : placement_.devices.size());
           ++b) {
        for (std::size_t i = 0; i < linksOf(a); ++i) {
          for (std::size_t j = is_self ? i + 1 : 0; j < linksOf(b); ++j) each({a, i}, {b, j});
        }
      }
    }
  }

  bool areJoined(LinkId a, LinkId b) const {
    const PlacedDevice& device_a = placement_.devices[a.device];
    const PlacedDevice& device_b = placement_.devices[b.device];
    if (a.device == b.device) {
      return areAdjacent(*device_a.model, groups_.at(device_a.model), a.link, b.link);
    }
    return device_a.carrier == b || device_b.carrier == a;
  }

  void add(std::size_t clearance, LinkId a, LinkId b) {
    if (found_.pairs.size() >= kMaxClearancePairs) {
      found_.too_many = true;
      return;
    }
    ClearancePair pair{clearance, a, b, nullptr, nullptr, std::nullopt};
    pair.body_a = bodies_.find(*placement_.devices[a.device].model, a.link);
    if (pair.body_a == nullptr) return;
    pair.body_b = bodies_.find(*placement_.devices[b.device].model, b.link);
    if (pair.body_b == nullptr) return;
    pair.common = commonCarrier(placement_, a, b);
    found_.pairs.push_back(pair);
  }

  const Cell& cell_;
  const CellPlacement& placement_;
  BodyStore& bodies_;
  LinkPatterns patterns_;
  std::map<const Model*, std::vector<std::size_t>> groups_;
  ClearancePairs found_;
};

}  // namespace

std::vector<Solid> solidsOf(const Link& link) {
  std::vector<Solid> solids;
  for (const Visual& collision : link.collisions) addVisual(collision, solids);
  if (!solids.empty()) return solids;
  for (const Visual& visual : link.visuals) addVisual(visual, solids);
  return solids;
}

const TriangleTree* BodyStore::find(const Model& model, std::size_t link) {
  const auto [found, is_new] = bodies_.try_emplace({&model, link});
  if (is_new) found->second = std::make_unique<const TriangleTree>(solidsOf(model.links[link]));
  return found->second->empty() ? nullptr : found->second.get();
}

ClearancePairs clearancePairs(const Cell& cell, const PosedScene& scene,
                              const CellPlacement& placement, BodyStore& bodies) {
  return PairFinder(cell, scene, placement, bodies).find();
}

}  // namespace rocinante
