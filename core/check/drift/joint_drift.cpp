#include "core/check/drift/joint_drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/figure_text.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

// Exporters print about six digits.
constexpr double kSameRatio = 1e-9;
constexpr double kSameLength_m = 1e-7;
constexpr double kSameAngle_deg = 1e-4;

std::string lengthText(double length_m) {
  return length_m < 1 ? fmt::format("{:.3g} mm", length_m * 1000)
                      : fmt::format("{:.4g} m", length_m);
}

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

const std::string& parentOf(const Model& model, const Joint& joint) {
  return model.links[joint.parent].name;
}
const std::string& childOf(const Model& model, const Joint& joint) {
  return model.links[joint.child].name;
}

bool isMovable(const Joint& joint) { return valueCount(joint.type) > 0 && !joint.mimic; }

/// Two joints of different names that are probably the same: same type, both mimics or neither, and
/// the same child link, or the same number in the file, origin and axis.
bool looksRenamed(const Model& recorded, const Joint& was, const Model& given, const Joint& is,
                  bool same_number) {
  if (was.type != is.type || was.mimic.has_value() != is.mimic.has_value()) return false;
  const bool same_child = childOf(recorded, was) == childOf(given, is);
  return same_child || (same_number && poseDrift(was.origin, is.origin).empty() &&
                        angleDrift_deg(was.axis, is.axis) == 0);
}

class JointDrift {
 public:
  JointDrift(const Model& recorded, const Model& given, DriftList& drift)
      : recorded_(recorded), given_(given), drift_(drift) {}

  std::map<std::string, std::string> find() {
    match();
    reportMissing();
    reportAdded();
    for (std::size_t i = 0; i < recorded_.joints.size(); ++i) {
      if (given_of_[i] != kNone) compare(recorded_.joints[i], given_.joints[given_of_[i]]);
    }
    compareOrder();
    return linkNames();
  }

 private:
  void match() {
    given_of_.assign(recorded_.joints.size(), kNone);
    recorded_of_.assign(given_.joints.size(), kNone);
    for (std::size_t i = 0; i < recorded_.joints.size(); ++i) {
      if (const auto same = given_.findJoint(recorded_.joints[i].name)) pair(i, *same);
    }
    for (std::size_t i = 0; i < recorded_.joints.size(); ++i) {
      if (given_of_[i] != kNone) continue;
      for (std::size_t k = 0; k < given_.joints.size(); ++k) {
        if (recorded_of_[k] != kNone) continue;
        const Joint &was = recorded_.joints[i], &is = given_.joints[k];
        if (!looksRenamed(recorded_, was, given_, is, i == k)) continue;
        pair(i, k);
        drift_.add("drift.joint-renamed",
                   fmt::format("joint {} of {} was renamed to {}: values under its old name would "
                               "move nothing",
                               was.name, drift_.subject(), is.name));
        break;
      }
    }
  }

  void pair(std::size_t recorded, std::size_t given) {
    given_of_[recorded] = given;
    recorded_of_[given] = recorded;
  }

  std::string countConsequence() const {
    const std::size_t was = recorded_.positionalCount(), is = given_.positionalCount();
    return was == is ? std::string()
                     : fmt::format(
                           "the log's `joints` have {} values and the model takes {}: "
                           "{} would not move",
                           was, is, drift_.subject());
  }

  void reportMissing() {
    for (std::size_t i = 0; i < recorded_.joints.size(); ++i) {
      if (given_of_[i] != kNone) continue;
      const Joint& joint = recorded_.joints[i];
      drift_.add(
          "drift.joint-removed",
          fmt::format("joint {} of {} is gone: {}", joint.name, drift_.subject(),
                      isMovable(joint) ? "its values in the log would move nothing"
                                       : "everything attached to it would be drawn elsewhere, or "
                                         "not at all"),
          isMovable(joint) ? countConsequence() : "");
    }
  }

  void reportAdded() {
    for (std::size_t k = 0; k < given_.joints.size(); ++k) {
      if (recorded_of_[k] != kNone) continue;
      const Joint& joint = given_.joints[k];
      drift_.add("drift.joint-added",
                 fmt::format("joint {} of {} is new: {}", joint.name, drift_.subject(),
                             isMovable(joint) ? "the log never drives it"
                                              : "what is attached to it was not there when the "
                                                "session was recorded"),
                 isMovable(joint) ? countConsequence() : "");
    }
  }

  void compare(const Joint& was, const Joint& is) {
    const std::string name = fmt::format("joint {} of {}", is.name, drift_.subject());
    if (was.type != is.type) {
      drift_.add("drift.joint-type",
                 fmt::format("{} was {} and is {}: {}", name, nameOf(was.type), nameOf(is.type),
                             typeConsequence(was.type, is.type)),
                 isMovable(was) == isMovable(is) ? "" : countConsequence());
    }
    compareAxis(name, was, is);
    if (const std::string moved = poseDrift(was.origin, is.origin); !moved.empty()) {
      drift_.add("drift.joint-origin",
                 fmt::format("{} {}: everything attached to it would be drawn there", name, moved));
    }
    const std::size_t parent = mappedLink(was.parent);
    if (parent != is.parent) {
      drift_.add("drift.joint-parent",
                 fmt::format("{} had parent link {} and has {}: it would move with the new one",
                             name, parentOf(recorded_, was), parentOf(given_, is)));
    }
    compareLimits(name, was, is);
    compareMimic(name, was, is);
  }

  static std::string_view typeConsequence(JointType was, JointType is) {
    if (valueCount(is) == 0) return "its value would move nothing";
    if (valueCount(was) == 0) return "it waits for a value that the log does not have";
    if (valueCount(was) != valueCount(is)) return "it takes a different number of values";
    const bool slid = was == JointType::prismatic, slides = is == JointType::prismatic;
    if (slid == slides) return "it would move the same way, within other bounds";
    return slides ? "its radians would be taken for metres"
                  : "its metres would be taken for radians";
  }

  void compareAxis(const std::string& name, const Joint& was, const Joint& is) {
    const bool has_axis = valueCount(was.type) > 0 && was.type != JointType::floating &&
                          valueCount(is.type) > 0 && is.type != JointType::floating;
    if (!has_axis) return;
    const double angle_deg = angleDrift_deg(was.axis, is.axis);
    if (angle_deg == 0) return;
    const bool reversed = angleDrift_deg(-was.axis, is.axis) == 0;
    drift_.add("drift.joint-axis",
               reversed
                   ? fmt::format("the axis of {} is reversed: it would move the other way", name)
                   : fmt::format("the axis of {} has turned by {:.4g}°: its values "
                                 "would move it another way",
                                 name, angle_deg));
  }

  void compareLimits(const std::string& name, const Joint& was, const Joint& is) {
    if (was.type != is.type) return;  // already reported
    const auto text = [](const Joint& joint) {
      if (!joint.limits) return std::string("unlimited");
      const bool turns = joint.type != JointType::prismatic;
      const auto value = [turns](double of) {
        return turns ? angleText(of) : fmt::format("{:.6g} m", of);
      };
      std::string limits =
          fmt::format("[{}, {}]", value(joint.limits->lower), value(joint.limits->upper));
      if (joint.limits->velocity) limits += fmt::format(" at {}/s", value(*joint.limits->velocity));
      return limits;
    };
    const bool same =
        was.limits.has_value() == is.limits.has_value() &&
        (!was.limits ||
         (isSameNumber(was.limits->lower, is.limits->lower) &&
          isSameNumber(was.limits->upper, is.limits->upper) &&
          isSameNumber(was.limits->velocity.value_or(-1), is.limits->velocity.value_or(-1)) &&
          isSameNumber(was.limits->effort.value_or(-1), is.limits->effort.value_or(-1))));
    if (same) return;
    const std::string before = text(was);
    const std::string after = text(is);
    const std::string change =
        before == after
            ? fmt::format("the effort limit of {} changed", name)
            : fmt::format("the limits of {} changed from {} to {}", name, before, after);
    drift_.add("drift.joint-limits", change + ": findings about them may differ");
  }

  void compareMimic(const std::string& name, const Joint& was, const Joint& is) {
    if (was.mimic.has_value() != is.mimic.has_value()) {
      drift_.add("drift.joint-mimic",
                 is.mimic ? fmt::format("{} mimics {} now: its own value would move nothing", name,
                                        given_.joints[is.mimic->joint].name)
                          : fmt::format("{} no longer mimics {}: it waits for a value that the "
                                        "log does not have",
                                        name, recorded_.joints[was.mimic->joint].name),
                 countConsequence());
      return;
    }
    if (!was.mimic) return;
    const bool same = given_of_[was.mimic->joint] == is.mimic->joint &&
                      isSameNumber(was.mimic->multiplier, is.mimic->multiplier) &&
                      isSameNumber(was.mimic->offset, is.mimic->offset);
    if (same) return;
    drift_.add("drift.joint-mimic",
               fmt::format("{} was {:.6g} times {} plus {:.6g} and is {:.6g} times {} plus {:.6g}: "
                           "it would be drawn elsewhere",
                           name, was.mimic->multiplier, recorded_.joints[was.mimic->joint].name,
                           was.mimic->offset, is.mimic->multiplier,
                           given_.joints[is.mimic->joint].name, is.mimic->offset));
  }

  /// Positional values that land on another joint.
  void compareOrder() {
    const std::vector<std::size_t> was = recorded_.movableJoints(), is = given_.movableJoints();
    if (recorded_.positionalCount() != given_.positionalCount() || was.size() != is.size()) return;
    std::vector<std::size_t> astray;
    for (std::size_t i = 0; i < was.size(); ++i) {
      // One without a counterpart is reported as removed.
      if (given_of_[was[i]] != kNone && given_of_[was[i]] != is[i]) astray.push_back(i);
    }
    if (astray.empty()) return;
    const auto joint = [&](std::size_t i) { return recorded_.joints[was[i]].name; };
    if (astray.size() == 2) {
      drift_.add("drift.joint-order",
                 fmt::format("joints {} and {} of {} have changed places: values {} and {} of "
                             "`joints` would drive each other's joint",
                             joint(astray[0]), joint(astray[1]), drift_.subject(), astray[0] + 1,
                             astray[1] + 1));
      return;
    }
    const std::size_t first = astray.front();
    drift_.add("drift.joint-order",
               fmt::format("the joints of {} are in a different order: {} values of `joints` "
                           "would drive a different joint, value {} {} instead of {}",
                           drift_.subject(), astray.size(), first + 1,
                           given_.joints[is[first]].name, joint(first)));
  }

  /// The counterpart in `given_` of a recorded link: by name, else the child of the same joint.
  std::size_t mappedLink(std::size_t recorded_link) const {
    const Link& link = recorded_.links[recorded_link];
    if (const auto same = given_.findLink(link.name)) return *same;
    if (!link.parent_joint) return given_.root;
    const std::size_t joint = given_of_[*link.parent_joint];
    return joint == kNone ? kNone : given_.joints[joint].child;
  }

  std::map<std::string, std::string> linkNames() const {
    std::map<std::string, std::string> names;
    for (std::size_t i = 0; i < recorded_.links.size(); ++i) {
      const std::size_t link = mappedLink(i);
      if (link == kNone) continue;
      const std::string& name = given_.links[link].name;
      // A link with a recorded name is that link, not another one renamed.
      if (name != recorded_.links[i].name && !recorded_.findLink(name)) {
        names.emplace(recorded_.links[i].name, name);
      }
    }
    return names;
  }

  const Model &recorded_, &given_;
  DriftList& drift_;
  std::vector<std::size_t> given_of_, recorded_of_;  ///< by joint; kNone: it has no counterpart
};

}  // namespace

bool isSameNumber(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  return std::abs(a - b) <= kSameLength_m + kSameRatio * std::max(std::abs(a), std::abs(b));
}

double angleDrift_deg(const Vec3& recorded, const Vec3& given) {
  // By the chord: an arc cosine loses half its digits where vectors are nearly the same.
  const double chord = lengthOf(given - recorded);
  const double angle_deg = degreesOf(2 * arcSine(std::min(1.0, chord / 2)));
  return angle_deg < kSameAngle_deg ? 0 : angle_deg;
}

std::string poseDrift(const Pose& recorded, const Pose& given) {
  const double moved_m = lengthOf(given.position - recorded.position);
  const Quat& a = recorded.orientation;
  const Quat& b = given.orientation;
  const double same = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  // A quaternion and its negative are the same rotation.
  const double sign = same < 0 ? -1 : 1;
  const double chord =
      std::sqrt((a.w - sign * b.w) * (a.w - sign * b.w) + (a.x - sign * b.x) * (a.x - sign * b.x) +
                (a.y - sign * b.y) * (a.y - sign * b.y) + (a.z - sign * b.z) * (a.z - sign * b.z));
  const double turned_deg = degreesOf(4 * arcSine(std::min(1.0, chord / 2)));
  const double rounding_m =
      kSameLength_m + kSameRatio * std::max(lengthOf(recorded.position), lengthOf(given.position));
  const bool moved = moved_m > rounding_m, turned = turned_deg > kSameAngle_deg;
  if (!moved && !turned) return "";
  std::string text = "has ";
  if (moved) text += "moved by " + lengthText(moved_m);
  if (moved && turned) text += " and ";
  if (turned) text += fmt::format("turned by {:.4g}°", turned_deg);
  return text;
}

std::map<std::string, std::string> addJointDrift(const Model& recorded, const Model& given,
                                                 DriftList& drift) {
  return JointDrift(recorded, given, drift).find();
}

}  // namespace rocinante
