#include "core/check/device_judge.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

/// A value is outside its limits when it is so by more than this: senders round.
constexpr double kLimitSlack = 1e-6;
/// Names that are told apart in one device; a hostile session has more, nobody reads them.
constexpr std::size_t kMostNames = 200;

using NameTallies = std::map<std::string, Tally, std::less<>>;

void hitName(NameTallies& tallies, std::string_view name, const Place& place) {
  auto found = tallies.find(name);
  if (found == tallies.end()) {
    if (tallies.size() == kMostNames) return;
    found = tallies.emplace(std::string(name), Tally()).first;
  }
  found->second.hit(place);
}

constexpr std::array kPlanar = {".x", ".y", ".yaw"};
constexpr std::array kFloating = {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw"};

}  // namespace

void DeviceJudge::appearInCell(const Model* model, bool optional) {
  in_cell_ = true;
  optional_ = optional;
  useModel(model);
}

void DeviceJudge::appearByAdd(const Model* model, const Statement& add, const Place& place) {
  added_ = true;
  if (model == nullptr) {
    if (unknown_model_.hit(place)) unknown_model_name_ = std::string(add.text);
    return;
  }
  if (model != model_) useModel(model);
  if (add.kinematics && *add.kinematics != kinematicsHash(*model)) other_kinematics_.hit(place);
}

void DeviceJudge::useModel(const Model* model) {
  model_ = model;
  values_.clear();
  value_by_name_.clear();
  if (model != nullptr) listValues(*model);
  for (auto& [source, order] : orders_) resolve(order);
}

void DeviceJudge::listValues(const Model& model) {
  for (const std::size_t number : model.movableJoints()) {
    const Joint& joint = model.joints[number];
    const std::size_t count = valueCount(joint.type);
    for (std::size_t component = 0; component < count; ++component) {
      Value value;
      value.name = joint.name;
      if (count == kPlanar.size()) value.name += kPlanar[component];
      if (count == kFloating.size()) value.name += kFloating[component];
      value.unit = joint.type == JointType::prismatic ? "m" : "rad";
      const bool limited = joint.type == JointType::revolute || joint.type == JointType::prismatic;
      if (limited && joint.limits) {
        value.lower = joint.limits->lower;
        value.upper = joint.limits->upper;
      }
      value_by_name_.emplace(value.name, values_.size());
      values_.push_back(std::move(value));
    }
  }
}

void DeviceJudge::judgeLink(std::string_view link, const Place& place) {
  if (model_ == nullptr || link.empty() || model_->findLink(link)) return;
  hitName(unknown_links_, link, place);
}

void DeviceJudge::judgeJoints(std::span<const double> values, bool ordered, std::uint32_t source,
                              const Place& place) {
  driven_ = true;
  const auto known = ordered ? orders_.find(source) : orders_.end();
  if (known == orders_.end()) return judgePositional(values, source, place);
  const Order& order = known->second;
  if (order.names.size() != values.size()) {
    if (joint_count_.hit(place)) {
      joint_count_text_ =
          fmt::format("{} values under an order of {} names", values.size(), order.names.size());
    }
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (order.values[i] != kNoValue) judgeValue(order.values[i], values[i], source, place);
  }
}

void DeviceJudge::judgePositional(std::span<const double> values, std::uint32_t source,
                                  const Place& place) {
  if (model_ == nullptr) return;
  if (values.size() != values_.size() && joint_count_.hit(place)) {
    joint_count_text_ = fmt::format("{} values, and its model {} takes {}", values.size(),
                                    model_->name, values_.size());
  }
  const std::size_t shared = std::min(values.size(), values_.size());
  for (std::size_t i = 0; i < shared; ++i) judgeValue(i, values[i], source, place);
}

void DeviceJudge::judgeNamed(std::span<const std::string_view> names,
                             std::span<const double> values, std::uint32_t source,
                             const Place& place) {
  driven_ = true;
  if (model_ == nullptr) return;
  for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) {
    const std::size_t value = valueNamed(names[i], place);
    if (value != kNoValue) judgeValue(value, values[i], source, place);
  }
}

void DeviceJudge::judgeOrder(std::span<const std::string_view> names, std::uint32_t source,
                             const Place& place) {
  if (model_ != nullptr) {
    for (const std::string_view name : names) valueNamed(name, place);
  }
  Order& order = orders_[source];
  // Orders are restated every few seconds and hardly ever change.
  if (std::equal(names.begin(), names.end(), order.names.begin(), order.names.end())) return;
  order.names.assign(names.begin(), names.end());
  resolve(order);
}

void DeviceJudge::resolve(Order& order) const {
  order.values.clear();
  for (const std::string& name : order.names) {
    const auto found = value_by_name_.find(name);
    order.values.push_back(found == value_by_name_.end() ? kNoValue : found->second);
  }
}

std::size_t DeviceJudge::valueNamed(std::string_view value_name, const Place& place) {
  const auto found = value_by_name_.find(value_name);
  if (found != value_by_name_.end()) return found->second;
  // A fixed joint or one that mimics another is there, but nothing that a sender says moves it.
  hitName(model_->findJoint(value_name) ? undrivable_joints_ : unknown_joints_, value_name, place);
  return kNoValue;
}

void DeviceJudge::judgeValue(std::size_t number, double q, std::uint32_t source,
                             const Place& place) {
  Value& value = values_[number];
  noteWriter(value.writer, source, two_drivers_, place);
  const double excess = std::max(value.lower - q, q - value.upper);
  if (excess <= kLimitSlack) return;
  value.beyond.hit(place);
  if (excess > value.worst_excess) {
    value.worst_excess = excess;
    value.worst = q;
    value.worst_at = place.time;
  }
}

void DeviceJudge::judgePose(std::uint32_t source, const Place& place) {
  noteWriter(pose_writer_, source, two_posers_, place);
}

void DeviceJudge::noteWriter(std::uint32_t& writer, std::uint32_t source, TwoSources& two,
                             const Place& place) {
  if (writer == source) return;
  if (writer != kNobody && two.tally.hit(place)) {
    two.before = writer;
    two.now = source;
  }
  writer = source;
}

void DeviceJudge::report(const std::vector<std::string>& sources,
                         std::vector<Finding>& findings) const {
  const auto add = [&](const Tally& tally, const char* rule, Severity severity, std::string text,
                       std::string hint = {}) {
    if (tally.count == 0) return;
    findings.push_back(tally.finding(rule, severity, name_, std::move(text)));
    findings.back().hint = std::move(hint);
  };
  if (!in_cell_ && !added_) {
    add(mentioned_, "packet.unknown-device", Severity::error,
        fmt::format("the cell has no device {}, and no `add` brings it", name_),
        "name the device as the cell does, or let the source `add` it");
    return;
  }
  add(unknown_model_, "packet.unknown-model", Severity::error,
      fmt::format("`add` gives device {} the model {}, which the cell does not know", name_,
                  unknown_model_name_));
  add(other_kinematics_, "packet.other-kinematics", Severity::error,
      fmt::format("the sender's kinematics of device {} are not those of the model here", name_),
      "one of the two has another version of the model file");
  add(joint_count_, "packet.joint-count", Severity::error,
      fmt::format("device {} gets {}", name_, joint_count_text_));
  for (const auto& [joint, tally] : unknown_joints_) {
    add(tally, "packet.unknown-joint", Severity::error,
        fmt::format("the model {} of device {} has no joint {}", model_->name, name_, joint));
  }
  for (const auto& [joint, tally] : undrivable_joints_) {
    add(tally, "packet.undrivable-joint", Severity::warning,
        fmt::format("joint {} of device {} is fixed, or mimics another: what is said of it moves "
                    "nothing",
                    joint, name_));
  }
  for (const auto& [link, tally] : unknown_links_) {
    add(tally, "packet.unknown-link", Severity::error,
        fmt::format("device {} has no link {}", name_, link));
  }
  for (const Value& value : values_) {
    add(value.beyond, "joint.limit", Severity::error,
        fmt::format("{}/{} is outside its limits [{:.6g}, {:.6g}] {}; the worst is {:.6g}", name_,
                    value.name, value.lower, value.upper, value.unit, value.worst));
  }
  const auto two = [&](const TwoSources& found, const char* what) {
    if (found.tally.count == 0) return;
    add(found.tally, "packet.two-sources", Severity::warning,
        fmt::format("the {} of device {} are written by {} and by {}; the last to write wins", what,
                    name_, sources[found.before], sources[found.now]));
  };
  two(two_drivers_, "joints");
  two(two_posers_, "poses");
  if (in_cell_ && !optional_ && !driven_ && !values_.empty()) {
    Finding finding;
    finding.rule = "device.undriven";
    finding.severity = Severity::error;
    finding.subject = name_;
    finding.text =
        fmt::format("device {} has {} joint values, and nobody drives it", name_, values_.size());
    finding.hint = "if it is meant to stand still, let its source say so once";
    findings.push_back(std::move(finding));
  }
}

}  // namespace rocinante
