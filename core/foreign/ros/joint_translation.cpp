#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/foreign/ros/names.h"
#include "core/foreign/ros/topic_translation.h"
#include "core/packet/packet_limits.h"

namespace rocinante::ros {
namespace {

using Outcome = RosTranslator::Outcome;

/// What a message has one value a joint of, and how packets name it.
struct Quantity {
  StatementKind kind;
  std::string_view suffix;  ///< behind the joint's name
};
constexpr std::array<Quantity, 3> kQuantities = {{{StatementKind::joint, ""},
                                                  {StatementKind::signals, ".velocity"},
                                                  {StatementKind::signals, ".effort"}}};

/// One statement of a device: `joint DEVICE NAME=q ...` or `signals DEVICE NAME.effort=q ...`.
struct StatementPlan {
  std::vector<std::size_t> places;  ///< in the message
  std::vector<std::string> names;
};
/// The joints of one device in a message, a plan for each quantity.
struct DevicePlan {
  std::string device;
  std::array<StatementPlan, kQuantities.size()> statements;
};

/// sensor_msgs/JointState. Senders repeat the same names in every message, so the bytes of the last
/// ones are kept, with all that follows from them.
class JointTranslation final : public TopicTranslation {
 public:
  using TopicTranslation::TopicTranslation;

  Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime,
                    Translated& out) override {
    FieldCursor cursor(message, layout);
    const Header header = readHeader(cursor);
    if (!readNames(cursor, message)) return Outcome::malformed;
    for (std::vector<double>& values : values_) cursor.numbers(values);
    if (!cursor.atEnd()) return Outcome::malformed;
    for (const std::string& sentence : left_out_) note(sentence);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (values_[i].empty()) continue;
      passive_[i] += passive_names_;
      if (values_[i].size() == names_) continue;
      if (i == 0) return Outcome::malformed;
      note("joint states with another number of speeds or efforts than of joints");
      values_[i].clear();
    }
    begin(header.stamp_ns);
    say(header.stamp_ns);
    if (packet_.statements.empty()) {
      if (values_[0].empty() && names_ > 0) note("joint states without positions");
      return Outcome::nothing;
    }
    out = {packet_text_.text(), &packet_};
    return Outcome::packet;
  }

  void use(const ChannelNames& stated) override { stated_ = stated.device; }

  void addLeftOut(Account& account) const override {
    constexpr const char* kPassive = "of fixed and mimic joints, which the model moves";
    addValues(account, "position", kPassive, passive_[0]);
    addValues(account, "velocity", kPassive, passive_[1]);
    addValues(account, "effort", kPassive, passive_[2]);
  }

 private:
  /// Makes the plan anew when the names are not those of the last message.
  bool readNames(FieldCursor& cursor, ByteView message) {
    const std::size_t from = cursor.position();
    if (!name_bytes_.empty() && from % 8 == names_at_ % 8 &&
        name_bytes_.size() <= cursor.remaining() &&
        std::memcmp(message.data() + from, name_bytes_.data(), name_bytes_.size()) == 0) {
      cursor.moveTo(from + name_bytes_.size());
      return true;
    }
    const std::uint32_t count = cursor.count(4);
    std::vector<std::string_view> names;
    for (std::uint32_t i = 0; i < count && cursor.ok(); ++i) names.push_back(cursor.string());
    if (!cursor.ok()) return false;
    const ByteView bytes = message.subspan(from, cursor.position() - from);
    name_bytes_.assign(bytes.begin(), bytes.end());
    names_at_ = from;
    names_ = names.size();
    makePlan(names);
    return true;
  }

  void makePlan(const std::vector<std::string_view>& names) {
    plans_.clear();
    left_out_.clear();
    passive_names_ = 0;
    const std::vector<DeviceFinder::JointHome> homes = devices_.homesOf(topic_, names, stated_);
    for (std::size_t i = 0; i < homes.size(); ++i) {
      const DeviceFinder::JointHome& home = homes[i];
      if (home.match == DeviceFinder::JointMatch::driven && isName(home.name) &&
          isName(home.device)) {
        addToPlan(home, i);
      } else if (home.match == DeviceFinder::JointMatch::ambiguous) {
        leaveOut("joint states with joints of several devices; name the device in the topic");
      } else if (home.match == DeviceFinder::JointMatch::passive) {
        ++passive_names_;
      } else {
        leaveOut("joint states with joints of no device; `log import --device` names one");
      }
    }
  }

  void addToPlan(const DeviceFinder::JointHome& home, std::size_t place) {
    DevicePlan* plan = nullptr;
    for (DevicePlan& each : plans_) {
      const bool has_room = each.statements[0].names.size() < limits::kJointValues;
      if (each.device == home.device && has_room) plan = &each;
    }
    if (plan == nullptr) {
      plan = &plans_.emplace_back();
      plan->device = home.device;
    }
    for (std::size_t i = 0; i < kQuantities.size(); ++i) {
      std::string name = home.name + std::string(kQuantities[i].suffix);
      if (isName(name)) {
        plan->statements[i].places.push_back(place);
        plan->statements[i].names.push_back(std::move(name));
      } else {
        leaveOut("speeds and efforts of joints with too long a name");
      }
    }
  }

  void leaveOut(std::string sentence) {
    if (left_out_.empty() || left_out_.back() != sentence) left_out_.push_back(std::move(sentence));
  }

  /// Writes the text and the packet that decoding it would give.
  void say(std::int64_t stamp_ns) {
    // All are reserved, so that the statements' views stay valid.
    std::size_t most = 0;
    for (const std::vector<double>& values : values_) most += values.size();
    numbers_.clear();
    numbers_.reserve(most);
    stated_names_.clear();
    stated_names_.reserve(most);
    if (kinds_.size() < most) kinds_.assign(most, SignalKind::number);
    statements_.clear();
    all_finite_ = true;
    for (const DevicePlan& plan : plans_) {
      for (std::size_t i = 0; i < kQuantities.size(); ++i) {
        if (!values_[i].empty()) addStatement(plan, i);
      }
    }
    if (!all_finite_) note("joint states with values that are not finite");
    packet_ = {};
    packet_.header.source = source_;
    if (stamp_ns > 0) packet_.header.time_ns = stamp_ns;
    packet_.statements = statements_;
  }

  void addStatement(const DevicePlan& plan, std::size_t quantity) {
    const StatementPlan& its = plan.statements[quantity];
    const std::size_t first = numbers_.size();
    for (std::size_t i = 0; i < its.places.size(); ++i) {
      const double value = values_[quantity][its.places[i]];
      if (!std::isfinite(value)) {
        all_finite_ = false;
        continue;
      }
      numbers_.push_back(value + 0.0);  // -0 to 0, as it is written
      stated_names_.push_back(its.names[i]);
    }
    const std::size_t count = numbers_.size() - first;
    if (count == 0) return;
    Statement& statement = statements_.emplace_back();
    statement.kind = kQuantities[quantity].kind;
    statement.line = static_cast<std::uint32_t>(statements_.size() + 1);
    if (isSignal(statement.kind)) {
      statement.path.first = plan.device;
      statement.signal_kinds = std::span(kinds_).first(count);
    } else {
      statement.name = plan.device;
    }
    statement.numbers = std::span(numbers_).subspan(first, count);
    statement.names = std::span(stated_names_).subspan(first, count);
    add(statement);
  }

  std::string stated_;        ///< the device that the channel names; empty: none
  Bytes name_bytes_;          ///< of the last message, with their count
  std::size_t names_at_ = 0;  ///< where they began: it decides their padding
  std::size_t names_ = 0;
  std::vector<DevicePlan> plans_;
  std::vector<std::string> left_out_;  ///< sentences for every message with these names
  std::size_t passive_names_ = 0;      ///< of fixed and mimic joints
  std::array<std::uint64_t, kQuantities.size()> passive_{};  ///< values of these
  std::array<std::vector<double>, kQuantities.size()> values_;
  std::vector<double> numbers_;
  std::vector<std::string_view> stated_names_;
  std::vector<SignalKind> kinds_;  ///< all of them numbers
  bool all_finite_ = true;
  std::vector<Statement> statements_;
  Packet packet_;
};

}  // namespace

std::unique_ptr<TopicTranslation> makeJointTranslation(std::string_view topic,
                                                       const DeviceFinder& devices,
                                                       FrameTree& frames) {
  return std::make_unique<JointTranslation>(topic, devices, frames);
}

}  // namespace rocinante::ros
