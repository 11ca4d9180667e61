#include <fmt/format.h>

#include <array>
#include <limits>

#include "core/base/name_hint.h"
#include "core/document/fault_list.h"
#include "core/kinematics/urdf_element.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::array<JointType, 6> kTypes = {JointType::revolute,  JointType::continuous,
                                             JointType::prismatic, JointType::fixed,
                                             JointType::planar,    JointType::floating};

JointType typeOf(const UrdfElement& element, const std::string& quoted) {
  const auto name = element.requiredText("type");
  if (!name) return JointType::fixed;
  std::vector<std::string_view> names;
  for (const JointType type : kTypes) {
    if (nameOf(type) == *name) return type;
    names.push_back(nameOf(type));
  }
  std::string hint = didYouMean(*name, names);
  if (hint.empty()) hint = "types are revolute, continuous, prismatic, fixed, planar, floating";
  element.faults().error("urdf.unknown-joint-type", element.place("type"),
                         fmt::format("joint {} has the unknown type {}; it is taken as fixed",
                                     quoted, quotedInFault(*name)),
                         std::move(hint));
  return JointType::fixed;
}

void readAxis(const UrdfElement& element, const std::string& quoted, Joint& joint) {
  const auto axis = element.child("axis");
  // Without an axis URDF means x; for planar joints all readers take the floor's x and y.
  if (joint.type == JointType::planar) joint.axis = {0, 0, 1};
  if (!axis || joint.type == JointType::fixed || joint.type == JointType::floating) return;
  if (!axis->has("xyz")) {
    element.faults().error("urdf.missing-attribute", axis->place(),
                           "<axis> lacks its attribute `xyz`");
    return;
  }
  const auto given = axis->vector("xyz");
  if (!given) return;
  if (const auto unit = normalized(*given)) {
    joint.axis = *unit;
  } else {
    element.faults().error("urdf.zero-axis", axis->place("xyz"),
                           fmt::format("the axis of joint {} has no direction", quoted),
                           "x is taken");
  }
}

void readLimits(const UrdfElement& element, const std::string& quoted, Joint& joint) {
  const bool bounded = joint.type == JointType::revolute || joint.type == JointType::prismatic;
  const auto limit = element.child("limit");
  if (!limit) {
    if (bounded) {
      element.faults().warning("urdf.missing-limit", element.place(),
                               fmt::format("{} joint {} has no <limit>; it is taken as unlimited",
                                           nameOf(joint.type), quoted),
                               "URDF requires one; other readers refuse the file");
    }
    return;
  }
  if (!bounded && joint.type != JointType::continuous) return;
  JointLimits limits;
  limits.velocity = limit->number("velocity");
  limits.effort = limit->number("effort");
  for (const char* attribute : {"effort", "velocity"}) {
    if (bounded && !limit->has(attribute)) {
      element.faults().warning("urdf.missing-limit-attribute", limit->place(),
                               fmt::format("the limit of joint {} lacks `{}`", quoted, attribute),
                               "URDF requires it; other readers refuse the file");
    }
  }
  if (bounded) {
    limits.lower = limit->number("lower").value_or(0.0);
    limits.upper = limit->number("upper").value_or(0.0);
    if (!limit->has("lower") && !limit->has("upper")) {
      element.faults().warning(
          "urdf.no-motion", limit->place(),
          fmt::format("the limit of joint {} has neither `lower` nor `upper`: it cannot move",
                      quoted),
          "both default to 0");
    }
    if (limits.lower > limits.upper) {
      element.faults().error(
          "urdf.limit-order", limit->place("lower"),
          fmt::format("the lower limit {} of joint {} is above its upper limit {}", limits.lower,
                      quoted, limits.upper),
          "the joint is taken as unlimited");
      return;
    }
  } else {
    for (const char* attribute : {"lower", "upper"}) {
      if (limit->number(attribute).value_or(0.0) == 0.0) continue;
      element.faults().leaveOut("attribute", std::string("limit/@") + attribute,
                                limit->place(attribute), "a continuous joint has no bounds");
    }
    limits.lower = -std::numeric_limits<double>::infinity();
    limits.upper = std::numeric_limits<double>::infinity();
  }
  joint.limits = limits;
}

}  // namespace

std::optional<JointDraft> readUrdfJoint(const UrdfElement& element) {
  JointDraft draft;
  draft.place = element.place();
  const auto name = element.requiredText("name");
  const std::string quoted = quotedInFault(name.value_or("?"));
  draft.joint.type = typeOf(element, quoted);
  draft.joint.origin = element.origin();
  readAxis(element, quoted, draft.joint);
  readLimits(element, quoted, draft.joint);

  bool sound = name.has_value();
  struct End {
    const char* tag;
    std::string& link;
    Place& place;
  };
  for (const End& end : {End{"parent", draft.parent, draft.parent_place},
                         End{"child", draft.child, draft.child_place}}) {
    const auto given = element.child(end.tag);
    if (!given) {
      element.faults().error("urdf.missing-element", element.place(),
                             fmt::format("joint {} has no <{}>", quoted, end.tag));
      sound = false;
      continue;
    }
    const auto link = given->requiredText("link");
    end.link = link.value_or("");
    end.place = given->place("link");
    sound = sound && link.has_value();
  }
  if (const auto mimic = element.child("mimic")) {
    if (const auto followed = mimic->requiredText("joint")) {
      draft.mimic = MimicDraft{*followed, mimic->number("multiplier").value_or(1.0),
                               mimic->number("offset").value_or(0.0), mimic->place("joint")};
    }
  }
  if (!sound) return std::nullopt;
  draft.joint.name = *name;
  return draft;
}

}  // namespace rocinante
