#include "core/check/judges/device_judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/figure_text.h"
#include "core/kinematics/kinematics.h"

namespace rocinante {
namespace {

/// The same as for a pose (docs/packet-format.md).
constexpr double kUnitSlack = 1e-3;
/// Most names that are counted separately per device; only a hostile session has more.
constexpr std::size_t kMaxDeviceNames = 200;
constexpr std::size_t kMaxStrangers = 20;
/// A place of the cell nearer to the origin is met by chance.
constexpr double kLeastAway_m = 0.1;
constexpr double kSameThousandfold = 0.01;

template <class Tallies>
void hitName(Tallies& tallies, std::string_view name, const PacketPlace& place) {
  auto found = tallies.find(name);
  if (found == tallies.end()) {
    if (tallies.size() == kMaxDeviceNames) return;
    found = tallies.emplace(std::string(name), Tally()).first;
  }
  found->second.hit(place);
}

/// "a, b, c", the first twelve.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxListed = 12;
  const std::size_t count = std::min(names.size(), kMaxListed);
  std::string text = fmt::format(
      "{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count), ", "));
  if (names.size() > count) text += fmt::format(" and {} more", names.size() - count);
  return text;
}

}  // namespace

bool DeviceOwners::allow(std::string_view source) const {
  if (!names.empty()) return std::find(names.begin(), names.end(), source) != names.end();
  return bound == nullptr || !bound->contains(source);
}

void DeviceJudge::appearInCell(const Model* model, Standing standing) {
  in_cell_ = is_known_ = true;
  is_optional_ = standing != Standing::there;
  is_ghost_ = standing == Standing::ghost;
  if (standing != Standing::optional) presence_.markPresent();
  useModel(model);
}

void DeviceJudge::appearByAdd(const Model* model, const Statement& add, const PacketPlace& place) {
  is_known_ = true;
  presence_.add(place);
  if (model == nullptr) {
    if (unknown_model_.hit(place)) unknown_model_name_ = std::string(add.text);
    return;
  }
  if (model != model_) useModel(model);
  if (add.kinematics && *add.kinematics != kinematicsHash(*model)) other_kinematics_.hit(place);
}

void DeviceJudge::disappear(const PacketPlace& place) { presence_.remove(place); }

void DeviceJudge::dropFindings() {
  presence_.dropFindings();
  for (Value& value : values_) value.judge.dropFindings();
  mentioned_ = unknown_model_ = other_kinematics_ = joint_count_ = repeated_joint_ = not_unit_ =
      millimetres_ = {};
  unknown_links_.clear();
  unknown_joints_.clear();
  undrivable_joints_.clear();
  two_drivers_.tally = two_posers_.tally = {};
  earlier_.clear();
  // The next to write is judged again.
  strangers_.clear();
  stranger_ = nullptr;
  writer_ = kNobody;
}

void DeviceJudge::useModel(const Model* model) {
  reportValues(earlier_);
  model_ = model;
  values_.clear();
  quaternions_.clear();
  value_by_name_.clear();
  if (model == nullptr) return;
  listValues(*model);
  for (auto& [source, order] : orders_) resolve(order);
  for (const auto& [link, tally] : std::exchange(early_links_, {})) {
    if (!model->findLink(link)) unknown_links_[link].merge(tally);
  }
  for (const auto& [joint, tally] : std::exchange(early_joints_, {})) {
    if (value_by_name_.contains(joint)) continue;
    (model->findJoint(joint) ? undrivable_joints_ : unknown_joints_)[joint].merge(tally);
  }
}

void DeviceJudge::listValues(const Model& model) {
  for (const std::size_t number : model.movableJoints()) {
    const Joint& joint = model.joints[number];
    if (joint.type == JointType::floating) quaternions_.push_back(values_.size() + 3);
    const std::size_t count = valueCount(joint.type);
    MotionThresholds thresholds;
    thresholds.velocity_factor = rules_->threshold("joint.velocity", name_, joint.name);
    thresholds.acceleration = rules_->threshold("joint.acceleration", name_, joint.name);
    thresholds.limit_slack = rules_->threshold("joint.limit", name_, joint.name);
    for (std::size_t component = 0; component < count; ++component) {
      values_.push_back({JointJudge(joint, component, thresholds)});
      value_by_name_.emplace(values_.back().judge.name(), values_.size() - 1);
    }
  }
}

void DeviceJudge::judgeLink(std::string_view link, const PacketPlace& place) {
  if (link.empty()) return;
  if (model_ == nullptr) {
    if (!is_known_) hitName(early_links_, link, place);
    return;
  }
  if (!model_->findLink(link)) hitName(unknown_links_, link, place);
}

void DeviceJudge::judgeJoints(std::span<const double> values, bool ordered,
                              const PacketPlace& place) {
  is_driven_ = true;
  ++statements_;
  const auto known = ordered ? orders_.find(place.source) : orders_.end();
  if (known == orders_.end()) return judgePositional(values, place);
  const Order& order = known->second;
  if (order.names.size() != values.size()) {
    if (joint_count_.hit(place)) {
      joint_count_text_ = fmt::format("{} under an order of {}", countText(values.size(), "value"),
                                      countText(order.names.size(), "name"));
      joint_count_hint_ = "its order is: " + listed(order.names);
    }
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (order.values[i] != kNoValue) judgeValue(order.values[i], values[i], place);
  }
  if (!quaternions_.empty()) judgeUnitQuaternions(place);
}

std::string DeviceJudge::expectedOrder() const {
  std::vector<std::string> names;
  for (const Value& value : values_) names.push_back(value.judge.name());
  return names.empty() ? std::string("the model has no driven joint")
                       : "`joints` takes them in this order: " + listed(names);
}

void DeviceJudge::judgePositional(std::span<const double> values, const PacketPlace& place) {
  if (model_ == nullptr) return;
  if (values.size() != values_.size() && joint_count_.hit(place)) {
    joint_count_text_ =
        fmt::format("{}, and its model {} takes {}", countText(values.size(), "value"),
                    model_->name, values_.size());
    joint_count_hint_ = expectedOrder();
  }
  const std::size_t shared = std::min(values.size(), values_.size());
  for (std::size_t i = 0; i < shared; ++i) judgeValue(i, values[i], place);
  if (!quaternions_.empty()) judgeUnitQuaternions(place);
}

void DeviceJudge::judgeNamed(std::span<const std::string_view> names,
                             std::span<const double> values, const PacketPlace& place) {
  is_driven_ = true;
  ++statements_;
  if (model_ == nullptr) {
    for (const std::string_view name : names) hitName(early_joints_, name, place);
    return;
  }
  for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) {
    const std::size_t value = valueNamed(names[i], place);
    if (value == kNoValue) continue;
    if (values_[value].stated_in == statements_ && repeated_joint_.hit(place)) {
      repeated_joint_name_ = names[i];
    }
    judgeValue(value, values[i], place);
  }
  if (!quaternions_.empty()) judgeUnitQuaternions(place);
}

void DeviceJudge::judgeEarlier(std::string_view value_name, double value,
                               const PacketPlace& place) {
  const auto found = value_by_name_.find(value_name);
  if (found != value_by_name_.end()) judgeValue(found->second, value, place);
}

void DeviceJudge::judgeOrder(std::span<const std::string_view> names, const PacketPlace& place) {
  Order& order = orders_[place.source];
  // Orders are restated every few seconds and hardly ever change.
  const bool is_same =
      std::equal(names.begin(), names.end(), order.names.begin(), order.names.end());
  if (!is_same) {
    order.names.assign(names.begin(), names.end());
    resolve(order);
    std::vector<std::string_view> sorted(names.begin(), names.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end() && repeated_joint_.hit(place)) repeated_joint_name_ = *twice;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (model_ == nullptr) {
      hitName(early_joints_, names[i], place);
    } else if (order.values[i] == kNoValue) {
      valueNamed(names[i], place);
    }
  }
}

void DeviceJudge::resolve(Order& order) const {
  order.values.clear();
  for (const std::string& name : order.names) {
    const auto found = value_by_name_.find(name);
    order.values.push_back(found == value_by_name_.end() ? kNoValue : found->second);
  }
}

std::size_t DeviceJudge::valueNamed(std::string_view value_name, const PacketPlace& place) {
  const auto found = value_by_name_.find(value_name);
  if (found != value_by_name_.end()) return found->second;
  // A fixed or mimic joint exists, but no value of a sender moves it.
  hitName(model_->findJoint(value_name) ? undrivable_joints_ : unknown_joints_, value_name, place);
  return kNoValue;
}

void DeviceJudge::judgeValue(std::size_t number, double q, const PacketPlace& place) {
  Value& value = values_[number];
  value.stated_in = statements_;
  two_drivers_.note(value.writer, place);
  value.judge.judge(q, place);
}

void DeviceJudge::judgeUnitQuaternions(const PacketPlace& place) {
  for (const std::size_t first : quaternions_) {
    double square = 0;
    bool is_whole = true;
    for (std::size_t i = first; i < first + 4; ++i) {
      is_whole = is_whole && values_[i].stated_in == statements_;
      square += values_[i].judge.value() * values_[i].judge.value();
    }
    if (is_whole && std::abs(std::sqrt(square) - 1) > kUnitSlack) not_unit_.hit(place);
  }
}

void DeviceJudge::judgePose(const Statement& pose, const PacketPlace& place) {
  two_posers_.note(pose_writer_, place);
  if (of_cell_ != nullptr && in_millimetres_.value_or(true)) judgeUnitOfPose(pose, place);
}

// Only the first pose is sure to tell: a vehicle on a map may come past any place.
void DeviceJudge::judgeUnitOfPose(const Statement& pose, const PacketPlace& place) {
  const Vec3 here{pose.numbers[0], pose.numbers[1], pose.numbers[2]};
  const Vec3& meant = of_cell_->pose.position;
  const double away = lengthOf(meant);
  if (!in_millimetres_) {
    const bool on_the_same = pose.carrier.first == of_cell_->on_device &&
                             pose.carrier.second == of_cell_->on_link && !pose.carrier.is_layer;
    in_millimetres_ = on_the_same && away >= kLeastAway_m &&
                      lengthOf(here - meant * 1000.0) <= kSameThousandfold * 1000 * away;
  }
  if (!*in_millimetres_ || lengthOf(here) < 500 * away) return;
  if (millimetres_.hit(place)) {
    millimetres_text_ =
        fmt::format("({:.6g}, {:.6g}, {:.6g}) m, a thousand times ({:.6g}, {:.6g}, {:.6g})", here.x,
                    here.y, here.z, meant.x, meant.y, meant.z);
  }
}

void DeviceJudge::writtenBy(std::string_view source_name, const PacketPlace& place) {
  if (writer_ != place.source) {
    writer_ = place.source;
    stranger_ = nullptr;
    if (!owners_.allow(source_name) && strangers_.size() < kMaxStrangers) {
      stranger_ = &strangers_[place.source];
      stranger_->name = source_name;
    }
  }
  if (stranger_ != nullptr) stranger_->tally.hit(place);
}

bool DeviceJudge::isUndriven() const {
  return in_cell_ && !is_optional_ && !is_driven_ && !values_.empty();
}

}  // namespace rocinante
