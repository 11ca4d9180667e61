#include "core/kinematics/mesh_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rocinante {
namespace {

/// The joints of a model reach at most this many times the size of its median mesh.
constexpr double kMaxReachOverMeshes = 500;
constexpr double kMaxOverOther = 8, kMaxOverMiddle = 20, kMaxOverReach = 5;
constexpr std::size_t kLeastJoints = 3, kLeastMeshes = 3;  // below these nothing is judged
constexpr const char* kHint =
    "the file may be in millimetres or inches: say so with `scale` of its <mesh>";

double lengthOfOrigin(const Joint& joint) {
  const Vec3& p = joint.origin.position;
  return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
}

/// How far the model can reach, at most; zero when it has too few joints to tell.
double reachOf(const Model& model) {
  double reach = 0;
  std::size_t offsets = 0;
  for (const Joint& joint : model.joints) {
    const double length = lengthOfOrigin(joint);
    reach += length;
    if (length > 1e-3) ++offsets;
    if (joint.type != JointType::prismatic || !joint.limits) continue;
    const double travel = std::max(std::fabs(joint.limits->lower), std::fabs(joint.limits->upper));
    if (std::isfinite(travel)) reach += travel;
  }
  return offsets >= kLeastJoints ? reach : 0;
}

double middleOf(std::vector<double> sizes) {
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

}  // namespace

void judgeScale(const Model& model, const std::vector<MeshUse>& uses, FaultList& faults) {
  std::vector<double> sizes;
  std::map<std::string, double> other_of[2];  // by link: the largest visual, the largest collision
  for (const MeshUse& use : uses) {
    if (!use.is_collision) sizes.push_back(use.size_m);
    double& largest = other_of[use.is_collision ? 1 : 0][use.link];
    largest = std::max(largest, use.size_m);
  }
  const double middle = sizes.size() >= kLeastMeshes ? middleOf(sizes) : 0;
  const double reach = reachOf(model);
  if (reach > 0 && middle > reach * kMaxOverReach) {
    const auto first = std::find_if(uses.begin(), uses.end(),
                                    [](const MeshUse& use) { return !use.is_collision; });
    faults.warning(
        "model.scale", first->place,
        fmt::format("the meshes are {:.3g} m large, and the joints reach {:.3g} m", middle, reach),
        kHint);
    return;
  }
  if (middle > 0 && reach > middle * kMaxReachOverMeshes) {
    const auto first = std::find_if(uses.begin(), uses.end(),
                                    [](const MeshUse& use) { return !use.is_collision; });
    faults.warning(
        "model.scale", first->place,
        fmt::format("the joints reach {:.3g} m, and the meshes are {:.3g} m large", reach, middle),
        "the origins of the joints may be in millimetres, or the `scale` of the meshes may be a "
        "thousandth too much");
    return;
  }
  for (const MeshUse& use : uses) {
    const auto& others = other_of[use.is_collision ? 0 : 1];
    const auto other = others.find(use.link);
    if (other != others.end() && other->second > 0 && use.size_m > other->second * kMaxOverOther) {
      faults.warning("model.scale", use.place,
                     fmt::format("the {} {} of link {} is {:.3g} m large, and its {} {:.3g} m",
                                 use.is_collision ? "collision" : "visual",
                                 quotedPathInFault(use.file), quotedInFault(use.link), use.size_m,
                                 use.is_collision ? "visual" : "collision", other->second),
                     kHint);
    } else if (!use.is_collision && middle > 0 && use.size_m > middle * kMaxOverMiddle) {
      faults.warning("model.scale", use.place,
                     fmt::format("the mesh {} is {:.3g} m large, where the model's are {:.3g} m",
                                 quotedPathInFault(use.file), use.size_m, middle),
                     kHint);
    }
  }
}

}  // namespace rocinante
