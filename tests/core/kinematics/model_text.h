#pragma once

#include <fmt/format.h>

#include <string>

#include "core/kinematics/model.h"
#include "core/report/account.h"
#include "core/report/finding.h"

namespace rocinante::test {

inline std::string poseText(const Pose& pose) {
  const Vec3& p = pose.position;
  const Quat& q = pose.orientation;
  return fmt::format("{} {} {} / {} {} {} {}", p.x, p.y, p.z, q.x, q.y, q.z, q.w);
}

inline std::string visualText(const Visual& visual) {
  std::string text = fmt::format("  {} at {} scale {} {} {}", visual.name, poseText(visual.origin),
                                 visual.scale.x, visual.scale.y, visual.scale.z);
  if (visual.mesh) {
    const Bounds& bounds = visual.mesh->bounds;
    text += fmt::format(" mesh {} {} to {} {} {} to {}", visual.mesh->triangleCount(), bounds.min.x,
                        bounds.max.x, bounds.max.y, bounds.min.z, bounds.max.z);
  }
  for (const std::size_t part : visual.mesh_parts) text += fmt::format(" part {}", part);
  if (const auto& material = visual.material) {
    const glm::vec4& d = material->diffuse;
    const glm::vec3& e = material->emission;
    text += fmt::format(" material {} {} {} {} {} glows {} {} {} map {}", material->name, d.r, d.g,
                        d.b, d.a, e.r, e.g, e.b, material->diffuse_map.filename().string());
  }
  return text + "\n";
}

/// Everything that a model has, for comparing.
inline std::string modelText(const Model& model) {
  std::string text = model.name + "\n";
  for (const Link& link : model.links) {
    text += "link " + link.name + "\n";
    for (const Visual& visual : link.visuals) text += " visual" + visualText(visual);
    for (const Visual& visual : link.collisions) text += " collision" + visualText(visual);
  }
  for (const Joint& joint : model.joints) {
    text += fmt::format("joint {} {} {} to {} at {} about {} {} {}", joint.name, nameOf(joint.type),
                        joint.parent, joint.child, poseText(joint.origin), joint.axis.x,
                        joint.axis.y, joint.axis.z);
    if (joint.limits) {
      text += fmt::format(" limits {} {} {} {}", joint.limits->lower, joint.limits->upper,
                          joint.limits->velocity.value_or(-1), joint.limits->effort.value_or(-1));
    }
    if (joint.mimic) {
      text += fmt::format(" mimics {} {} {}", joint.mimic->joint, joint.mimic->multiplier,
                          joint.mimic->offset);
    }
    text += "\n";
  }
  return text;
}

/// What a reader gave: the model, its account and its other findings, without places, which a
/// mutation may move.
inline std::string outcomeText(const std::optional<Model>& model, const Findings& faults) {
  std::string text = model ? modelText(*model) : "no model\n";
  for (const Finding& fault : faults) text += fault.rule + ": " + sentenceOf(fault) + "\n";
  return text;
}

}  // namespace rocinante::test
