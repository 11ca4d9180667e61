#include <fmt/format.h>

#include <limits>

#include "core/base/name_hint.h"
#include "core/cell/inline_model.h"
#include "core/document/fault_list.h"
#include "core/kinematics/kinematics.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

std::optional<JointType> readJointType(TomlTable& table) {
  const auto name = table.requiredText("type");
  if (!name) return std::nullopt;
  std::vector<std::string_view> names;
  for (const JointType type : {JointType::fixed, JointType::revolute, JointType::continuous,
                               JointType::prismatic, JointType::planar, JointType::floating}) {
    if (nameOf(type) == *name) return type;
    names.push_back(nameOf(type));
  }
  std::string hint = didYouMean(*name, names);
  if (hint.empty()) hint = "types are fixed, revolute, continuous, prismatic, planar, floating";
  table.error("cell.unknown-word", "type",
              fmt::format("{} is not a joint type", quotedInFault(*name)), std::move(hint));
  return std::nullopt;
}

void readJointAxis(TomlTable& table, Joint& joint) {
  const bool turns_or_slides = joint.type == JointType::revolute ||
                               joint.type == JointType::continuous ||
                               joint.type == JointType::prismatic;
  if (joint.type == JointType::planar) joint.axis = {0, 0, 1};
  const auto axis = turns_or_slides ? table.requiredVector("axis") : table.vector("axis");
  if (!axis) return;
  if (const auto unit = table.direction("axis")) {
    joint.axis = *unit;
  } else {
    table.error("cell.zero-axis", "axis", "the axis has no direction", "x is taken");
  }
}

// A limit of velocity or effort.
std::optional<double> readRate(TomlTable& table, std::string_view key) {
  const auto rate = table.number(key);
  if (!rate || *rate >= 0.0) return rate;
  table.error("cell.bad-number", key, fmt::format("`{}` of {} is below 0", key, table.what()));
  return std::nullopt;
}

void readJointLimits(TomlTable& table, Joint& joint) {
  const auto limits = table.range("limits");
  const auto limits_deg = table.range("limits_deg");
  const auto velocity = readRate(table, "velocity"), effort = readRate(table, "effort");
  const bool bounded = joint.type == JointType::revolute || joint.type == JointType::prismatic;
  const bool turns_or_slides = bounded || joint.type == JointType::continuous;
  for (const char* key : {"limits", "limits_deg", "velocity", "effort"}) {
    const bool may = *key == 'l' ? bounded : turns_or_slides;
    if (table.has(key) && !may) {
      table.error(
          "cell.useless-limits", key,
          fmt::format("a {} joint has no {}", nameOf(joint.type), *key == 'l' ? "limits" : key));
    }
  }
  if (limits_deg && joint.type == JointType::prismatic) {
    table.error("cell.useless-limits", "limits_deg",
                "a prismatic joint slides: it takes no "
                "degrees",
                "use `limits`, in metres");
    return;
  }
  if (limits && limits_deg) {
    table.error("cell.two-limits", "limits_deg", "the joint has both limits and limits_deg");
  }
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  JointLimits read{-kNoEnd, kNoEnd, velocity, effort};
  if (bounded && limits) {
    read.lower = limits->first;
    read.upper = limits->second;
  } else if (bounded && limits_deg) {
    read.lower = radiansOf(limits_deg->first);
    read.upper = radiansOf(limits_deg->second);
  } else if (!turns_or_slides || (!velocity && !effort)) {
    return;
  }
  joint.limits = read;
}

}  // namespace

std::optional<JointDraft> readInlineJoint(TomlTable& table, const std::string& parent,
                                          const std::string& child) {
  JointDraft draft;
  draft.place = table.place();
  const auto name = table.requiredName("name");
  const auto type = readJointType(table);
  draft.joint.type = type.value_or(JointType::fixed);
  if (const TomlNode* origin = table.node("origin")) {
    if (origin->kind == TomlNode::Kind::table) {
      TomlTable pose(*origin, "origin", table.faults());
      draft.joint.origin = pose.pose();
      pose.finish();
    } else {
      draft.joint.origin.position = table.vector("origin").value_or(Vec3{0, 0, 0});
    }
  }
  if (type) {
    readJointAxis(table, draft.joint);
    readJointLimits(table, draft.joint);
  } else {
    for (const char* key : {"axis", "limits", "limits_deg", "velocity", "effort"}) {
      static_cast<void>(table.node(key));
    }
  }
  if (auto mimic = table.table("mimic", "mimic")) {
    if (const auto followed = mimic->requiredText("joint")) {
      draft.mimic = MimicDraft{*followed, mimic->number("multiplier").value_or(1.0),
                               mimic->number("offset").value_or(0.0), mimic->place("joint")};
    }
    mimic->finish();
  }
  table.finish();
  if (!name) return std::nullopt;
  draft.joint.name = *name;
  draft.parent = parent;
  draft.child = child;
  return draft;
}

}  // namespace rocinante
