#include "viewer/ui/model/pose_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "viewer/ui/model/inspection.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

constexpr double kFarthest_m = 1e6;
constexpr double kMostTurns = 1000;

Error notTyped(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

/// Metres or radians.
double poseNumber(const Pose& pose, std::size_t field) {
  const auto axis = static_cast<int>(field % 3);
  return isAngleField(field) ? rpyOf(pose.orientation)[axis] : pose.position[axis];
}

}  // namespace

Result<double> typedLength(std::string_view text, LengthUnit unit) {
  const auto metres = parseLength(text, unit);
  if (!metres) {
    const bool has_metres = unit == LengthUnit::metres;
    return notTyped(fmt::format("`{}` is not a length: {}", text,
                                has_metres ? "0.12, 0.12m, 120mm" : "120, 120mm, 0.12m"));
  }
  if (std::abs(*metres) > kFarthest_m) return notTyped(fmt::format("`{}` is beyond 1000 km", text));
  return *metres;
}

Result<double> typedAngle(std::string_view text, AngleUnit unit) {
  const auto radians = parseAngle(text, unit);
  if (!radians) {
    const bool has_radians = unit == AngleUnit::radians;
    return notTyped(fmt::format("`{}` is not an angle: {}", text,
                                has_radians ? "0.5, 0.5rad, 30deg" : "30, 30deg, 0.5rad"));
  }
  if (std::abs(degreesOf(*radians)) > kMostTurns * 360) {
    return notTyped(fmt::format("`{}` is beyond 1000 turns", text));
  }
  return *radians;
}

std::string poseFieldText(const Pose& pose, std::size_t field, const Units& units) {
  const double number = poseNumber(pose, field);
  return isAngleField(field) ? angleNumber(number, units.angle)
                             : lengthNumber(number, units.length);
}

std::string openedPoseText(const Pose& pose, std::size_t field, const Units& units) {
  double number = poseNumber(pose, field);
  double keep = 1e6;  // parts of one
  if (isAngleField(field)) {
    if (units.angle == AngleUnit::degrees) number = degreesOf(number);
    if (units.angle == AngleUnit::radians) keep = 1e9;
  } else if (units.length == LengthUnit::millimetres) {
    number *= 1e3;
    keep = 1e3;
  }
  const double rounded = std::round(number * keep) / keep;
  return fmt::format("{}", rounded == 0 ? 0.0 : rounded);  // never -0
}

Result<Pose> typedPose(const Pose& before, const PoseTyping& typed, const Units& units) {
  const std::string_view text = typed.text.data();
  if (text == typed.opened) return before;
  const bool is_angle = isAngleField(typed.field);
  const auto number = is_angle ? typedAngle(text, units.angle) : typedLength(text, units.length);
  if (!number) return number.error();
  if (*number == poseNumber(before, typed.field)) return before;
  const auto axis = static_cast<int>(typed.field % 3);
  Pose after = before;
  if (is_angle) {
    Vec3 rpy = rpyOf(before.orientation);
    rpy[axis] = *number;
    after.orientation = quaternionFromRpy(rpy);
  } else {
    after.position[axis] = *number;
  }
  return after;
}

void takeTypedPose(ViewModel& model) {
  PoseFields& fields = model.viewer.panels.pose_fields;
  const auto typed = std::exchange(fields.typing, std::nullopt);
  if (!typed) return;
  fields.trouble.clear();
  if (typed->text.data() == typed->opened) return;
  const auto before = model.movablePose(typed->device);
  const auto after = before ? typedPose(*before, *typed, model.hand.units) : before;
  if (!after) {
    fields.trouble =
        fmt::format("{} of {}: {}", kPoseFields[typed->field], typed->device, after.error().what);
  } else if (*after != *before) {
    model.moves.put(typed->device, *after);
  }
}

bool hasPoseFields(const ViewModel& model) {
  return model.viewer.gizmo.shown && !model.selected.device.empty();
}

std::size_t poseFieldColumns(float room, float both) { return room >= both ? 2 : 1; }

}  // namespace rocinante
