// The report of DeviceJudge. One cause is reported by one rule; its consequences are not.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "core/base/figure_text.h"
#include "core/base/name_hint.h"
#include "core/check/judges/device_judge.h"
#include "core/report/traffic_findings.h"

namespace rocinante {
namespace {

/// After this many statements every driven joint has got a value.
constexpr std::uint64_t kKnownStatements = 20;

}  // namespace

void DeviceJudge::report(const SessionRoster& roster, Findings& findings) const {
  if (!is_known_) {
    if (mentioned_.count == 0) return;
    const Finding unknown = unknownDevice(name_);
    findings.push_back(mentioned_.finding(unknown.rule, name_, unknown.text));
    findings.back().hint = unknown.hint;
    if (const std::string meant = didYouMean(name_, roster.devices); !meant.empty()) {
      findings.back().hint = meant + " " + findings.back().hint;
    }
    return;
  }
  if (mentioned_.count > 0 && !presence_.everThere()) {
    findings.push_back(mentioned_.finding(
        "device.unadded", name_,
        fmt::format("device {} is optional, and no `add` brings it: it is not drawn", name_)));
  }
  findings.insert(findings.end(), earlier_.begin(), earlier_.end());
  reportNames(findings);
  if (!reportDegrees(findings) && !reportPercent(findings)) reportValues(findings);
  reportWriters(roster, findings);
  reportUndriven(roster, findings);
}

void DeviceJudge::reportNames(Findings& findings) const {
  const auto add = [&](const Tally& tally, const char* rule, std::string text,
                       std::string hint = {}) {
    if (tally.count == 0) return;
    findings.push_back(tally.finding(rule, name_, std::move(text)));
    findings.back().hint = std::move(hint);
  };
  add(unknown_model_, "packet.unknown-model",
      fmt::format("`add` gives device {} the model {}, which the cell does not know", name_,
                  unknown_model_name_));
  add(other_kinematics_, "packet.other-kinematics",
      fmt::format("the sender's kinematics of device {} differ from those of the model here",
                  name_),
      "one of the two has another version of the model file");
  presence_.report(name_, findings);
  add(millimetres_, "device.millimetres",
      fmt::format("packets put device {} at {}, where the cell has it", name_, millimetres_text_),
      "did you mean metres? these look like millimetres");
  add(joint_count_, "packet.joint-count",
      fmt::format("device {} gets {}", name_, joint_count_text_), joint_count_hint_);
  add(repeated_joint_, "packet.repeated-joint",
      fmt::format("one statement names joint {} of device {} twice", repeated_joint_name_, name_));
  std::vector<std::string_view> value_names, link_names;
  if (!unknown_joints_.empty()) {
    for (const Value& value : values_) value_names.push_back(value.judge.name());
  }
  if (!unknown_links_.empty()) {
    for (const Link& link : model_->links) link_names.push_back(link.name);
  }
  for (const auto& [joint, tally] : unknown_joints_) {
    add(tally, "packet.unknown-joint",
        fmt::format("the model {} of device {} has no joint {}", model_->name, name_, joint),
        whatThereIs(joint, value_names));
  }
  for (const auto& [joint, tally] : undrivable_joints_) {
    add(tally, "packet.undrivable-joint",
        fmt::format("joint {} of device {} is fixed, or mimics another: its value moves nothing",
                    joint, name_));
  }
  for (const auto& [link, tally] : unknown_links_) {
    add(tally, "packet.unknown-link", fmt::format("device {} has no link {}", name_, link),
        didYouMean(link, link_names));
  }
  add(not_unit_, "joint.unnormalised",
      fmt::format("a floating joint of device {} has a quaternion off unit length by more than "
                  "0.001",
                  name_));
}

void DeviceJudge::reportValues(Findings& findings) const {
  for (const Value& value : values_) value.judge.report(name_, findings);
}

// Degrees are far beyond the limits in radians, but well within them when read as degrees.
bool DeviceJudge::reportDegrees(Findings& findings) const {
  std::size_t angles = 0, beyond = 0;
  double largest = 0;
  Tally tally;
  for (const Value& value : values_) {
    const JointJudge& joint = value.judge;
    if (!joint.isAngle() || !joint.isLimited() || !joint.isWritten()) continue;
    if (!joint.fitsAsDegrees()) return false;
    ++angles;
    beyond += joint.wasBeyond();
    largest = std::max(largest, joint.largest());
    joint.collect(tally);
  }
  if (beyond == 0 || 2 * beyond < angles || largest <= 2 * std::numbers::pi) return false;
  findings.push_back(tally.finding(
      "joint.degrees", name_,
      fmt::format("the joint values of device {} are up to {:.6g}, which fits its limits as "
                  "degrees",
                  name_, largest)));
  findings.back().hint = "packets give angles in radians";
  findings.back().worst = statedValue(largest);
  for (const Value& value : values_) {
    if (!value.judge.isAngle()) value.judge.report(name_, findings);
  }
  return true;
}

// One joint beyond its limits, or only sliding ones, could as well be in millimetres.
bool DeviceJudge::reportPercent(Findings& findings) const {
  std::size_t limited = 0, beyond = 0, turning = 0;
  double largest = 0;
  Tally tally;
  for (const Value& value : values_) {
    const JointJudge& joint = value.judge;
    if (!joint.isLimited() || !joint.isWritten()) continue;
    if (!joint.fitsAsPercent()) return false;
    ++limited;
    beyond += joint.wasBeyond();
    turning += joint.wasBeyond() && joint.isAngle();
    largest = std::max(largest, joint.largest());
    joint.collect(tally);
  }
  if (beyond < 2 || 2 * beyond < limited || turning == 0 || largest <= 2 * std::numbers::pi) {
    return false;
  }
  findings.push_back(tally.finding(
      "joint.percent", name_,
      fmt::format("the joint values of device {} are from 0 up to {:.6g}, which fits percent of "
                  "their ranges",
                  name_, largest)));
  findings.back().hint =
      "packets give radians and metres: lower + value / 100 * (upper - lower) of each joint";
  findings.back().worst = statedValue(largest);
  for (const Value& value : values_) {
    if (!value.judge.isLimited()) value.judge.report(name_, findings);
  }
  return true;
}

void DeviceJudge::reportUndriven(const SessionRoster& roster, Findings& findings) const {
  if (isUndriven()) {
    findings.push_back(makeFinding("device.undriven", name_,
                                   fmt::format("device {} has {}, and no source drives it", name_,
                                               countText(values_.size(), "joint value"))));
    findings.back().hint = "if it is meant to stand still, let its source send its values once";
    for (const std::string& owner : owners_.names) {
      if (!roster.missing.contains(owner)) continue;
      findings.back().hint =
          fmt::format("its source {} never sent a packet; {}", owner, findings.back().hint);
    }
    return;
  }
  // A wrong name or count explains missing values.
  const bool is_explained =
      joint_count_.count > 0 || !unknown_joints_.empty() || !undrivable_joints_.empty();
  if (!is_driven_ || is_explained || statements_ < kKnownStatements) return;
  std::string names;
  std::size_t count = 0;
  for (const Value& value : values_) {
    if (value.judge.isWritten()) continue;
    if (++count <= 8) names += (names.empty() ? "" : ", ") + value.judge.name();
  }
  if (count == 0) return;
  if (count > 8) names += fmt::format(" and {} more", count - 8);
  findings.push_back(makeFinding(
      "joint.undriven", name_, fmt::format("device {} is driven, but never its {}", name_, names)));
}

std::string DeviceJudge::stranger() const {
  return strangers_.empty() ? std::string() : strangers_.begin()->second.name;
}

void DeviceJudge::reportWriters(const SessionRoster& roster, Findings& findings) const {
  // Where an owner never sent a packet, a different name is the likely cause: see source.missing.
  const bool has_missing_owner =
      std::any_of(owners_.names.begin(), owners_.names.end(),
                  [&](const std::string& owner) { return roster.missing.contains(owner); });
  if (!has_missing_owner) {
    for (const auto& [number, stranger] : strangers_) {
      std::string text = fmt::format("source {} writes device {}, which the cell does not give it",
                                     stranger.name, name_);
      if (!owners_.names.empty()) {
        text = fmt::format("source {} writes device {}, which the cell gives to {}", stranger.name,
                           name_, fmt::join(owners_.names, ", "));
      }
      findings.push_back(stranger.tally.finding("source.unlisted-device", name_, std::move(text)));
    }
  }
  const auto two = [&](const TwoSources& found, const char* what) {
    // Sources that the cell does not list for it are already reported.
    if (strangers_.contains(found.before) || strangers_.contains(found.now)) return;
    found.report(name_, fmt::format("the {} of device {} are", what, name_), roster.sources,
                 findings);
  };
  two(two_drivers_, "joints");
  two(two_posers_, "poses");
}

}  // namespace rocinante
