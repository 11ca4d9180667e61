#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/math/vector.h"
#include "viewer/view/units.h"

namespace rocinante {

class ViewModel;

/// The numbers of a device's pose in fields: x, y, z in metres, then angles in radians about fixed
/// axes, as URDF has them. A field is known by its number in this list.
constexpr std::array<std::string_view, 6> kPoseFields{"x", "y", "z", "roll", "pitch", "yaw"};
constexpr bool isAngleField(std::size_t field) { return field >= 3; }

/// A number of a pose that is being typed. Plain values.
struct PoseTyping {
  std::string device;
  std::size_t field = 0;
  std::string opened;           ///< what was there when typing began
  std::array<char, 48> text{};  ///< NUL-terminated
  int frame = 0;                ///< the last one, of Dear ImGui, in which it had the keyboard
};

/// What the fields remember. Plain values.
struct PoseFields {
  std::optional<PoseTyping> typing;
  std::string trouble;  ///< why the last number was not taken; a sentence, or empty
  /// Where the mouse has rested, in pixels, since a number was typed.
  std::optional<std::array<float, 2>> rests_at;
};

/// A length or an angle that is typed for a pose, in metres or radians; without a unit it is in
/// `unit`. bad_argument, as a sentence, for what is none, with examples that begin with `unit`, and
/// beyond 1000 km or 1000 turns.
Result<double> typedLength(std::string_view text, LengthUnit unit);
Result<double> typedAngle(std::string_view text, AngleUnit unit);

/// The number as panels have it, without its unit.
std::string poseFieldText(const Pose& pose, std::size_t field, const Units& units);
/// The same as it is to be typed over: as exactly as `save-pose` writes a pose, to a micrometre and
/// a millionth of a degree.
std::string openedPoseText(const Pose& pose, std::size_t field, const Units& units);

/// `before` with the number that was typed: `before` itself, to the last bit, where the text is as
/// it was opened, or says the same number. The errors of typedLength and typedAngle. Pure.
Result<Pose> typedPose(const Pose& before, const PoseTyping& typed, const Units& units);

/// Typing is over: the device is put there, as by `move` and `turn`, in one step to undo, or the
/// fields have a new trouble. Nothing when nothing is typed.
void takeTypedPose(ViewModel& model);

/// Whether the panel of the selected device has its pose in fields: while the gizmo is shown.
bool hasPoseFields(const ViewModel& model);

/// In how many columns the fields stand: x, y, z beside roll, pitch, yaw, which takes the width
/// `both`, or all below each other where `room` is narrower. Pure.
std::size_t poseFieldColumns(float room, float both);

}  // namespace rocinante
