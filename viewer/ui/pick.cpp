#include "viewer/ui/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The line in a mesh's own space. Its direction keeps its length there, so that a distance along
/// it is the same in both.
struct LocalLine {
  Vec3 from, direction;
};

LocalLine inSpaceOf(const Mat4& world, const SightLine& line) {
  const Mat4 inverse = glm::inverse(world);
  return {transformPoint(inverse, line.from), glm::dmat3(inverse) * line.direction};
}

bool meets(const LocalLine& line, const Bounds& bounds, double nearest) {
  double enters = 0;
  double leaves = nearest;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = line.from[axis];
    const double along = line.direction[axis];
    if (along == 0) {
      if (from < bounds.min[axis] || from > bounds.max[axis]) return false;
      continue;
    }
    const double first = (bounds.min[axis] - from) / along;
    const double second = (bounds.max[axis] - from) / along;
    enters = std::max(enters, std::min(first, second));
    leaves = std::min(leaves, std::max(first, second));
  }
  return enters <= leaves;
}

/// Moller and Trumbore's, for both sides; kNever when it misses.
double distanceTo(const LocalLine& line, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 p = glm::cross(line.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0) return kNever;
  const Vec3 offset = line.from - a;
  const double u = glm::dot(offset, p) / determinant;
  if (!(u >= 0 && u <= 1)) return kNever;
  const Vec3 q = glm::cross(offset, ab);
  const double v = glm::dot(line.direction, q) / determinant;
  if (!(v >= 0 && u + v <= 1)) return kNever;
  const double distance = glm::dot(ac, q) / determinant;
  return distance > 0 ? distance : kNever;
}

double distanceTo(const LocalLine& line, const Mesh& mesh, const MeshPart& part) {
  double nearest = kNever;
  const auto corner = [&](std::uint32_t i) {
    return Vec3(mesh.vertices[mesh.indices[i]].position);
  };
  for (std::uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
    nearest = std::min(nearest, distanceTo(line, corner(i), corner(i + 1), corner(i + 2)));
  }
  return nearest;
}

}  // namespace

SightLine sightLine(const Camera& camera, double x_px, double y_px) {
  const double right_px = x_px + 0.5 - camera.width() * 0.5;
  const double up_px = camera.height() * 0.5 - (y_px + 0.5);
  const double meters = camera.metersPerPixel(1);
  const Vec3 aside = camera.right() * (right_px * meters) + camera.up() * (up_px * meters);
  if (camera.orthographic()) return {camera.eye() + aside, camera.forward()};
  return {camera.eye(), glm::normalize(camera.forward() + aside)};
}

std::optional<Picked> pick(const PosedScene& scene, const ViewChoice& choice,
                           const SightLine& line) {
  std::optional<Picked> met;
  double nearest = kNever;
  for (std::size_t d = 0; d < scene.devices.size(); ++d) {
    const PosedDevice& device = scene.devices[d];
    if (device.model == nullptr) continue;
    for (std::size_t l = 0; l < device.model->links.size(); ++l) {
      const Link& link = device.model->links[l];
      if (link.visuals.empty() || !(choice.choosesParts(device) || choice.linkVisible(device, l))) {
        continue;
      }
      for (const Visual& visual : link.visuals) {
        if (!visual.mesh) continue;
        const Mat4 world =
            device.link_world[l] * matrixOf(visual.origin) * scaleMatrix(visual.scale);
        const LocalLine local = inSpaceOf(world, line);
        if (!meets(local, visual.mesh->bounds, nearest)) continue;
        for (std::size_t part = 0; part < visual.mesh->parts.size(); ++part) {
          const MeshPart& run = visual.mesh->parts[part];
          const bool used = visual.mesh_parts.empty() ||
                            std::ranges::find(visual.mesh_parts, part) != visual.mesh_parts.end();
          if (!used || (choice.choosesParts(device) && !choice.partVisible(device, l, run.group))) {
            continue;
          }
          const double distance = distanceTo(local, *visual.mesh, run);
          if (distance < nearest) {
            nearest = distance;
            met = Picked{d, l, distance, line.from + line.direction * distance};
          }
        }
      }
    }
  }
  return met;
}

}  // namespace rocinante
