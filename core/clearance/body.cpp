#include "core/clearance/body.h"

#include <algorithm>
#include <cmath>

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

}  // namespace rocinante
