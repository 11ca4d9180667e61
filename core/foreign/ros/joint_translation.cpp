#include <cmath>
#include <cstring>
#include <vector>

#include "core/foreign/ros/names.h"
#include "core/foreign/ros/topic_translation.h"
#include "core/packet/packet_limits.h"

namespace rocinante::ros {
namespace {

using Outcome = RosTranslator::Outcome;

/// The joints of one device in a message: `joint DEVICE NAME=q ...`.
struct DevicePlan {
  std::string device;
  std::vector<std::size_t> places;  ///< in the message
  std::vector<std::string> names;
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
    cursor.numbers(positions_);
    const auto velocities = cursor.count(sizeof(double));
    cursor.skip(velocities, sizeof(double));
    const auto efforts = cursor.count(sizeof(double));
    cursor.skip(efforts, sizeof(double));
    if (!cursor.atEnd()) return Outcome::malformed;
    velocities_ += velocities;
    efforts_ += efforts;
    passive_ += passive_names_;
    for (const std::string& sentence : left_out_) note(sentence);
    if (positions_.empty()) {
      if (names_ > 0) note("joint states without positions");
      return Outcome::nothing;
    }
    if (positions_.size() != names_) return Outcome::malformed;
    begin(header.stamp_ns);
    say(header.stamp_ns);
    if (packet_.statements.empty()) return Outcome::nothing;
    out = {packet_text_.text(), &packet_};
    return Outcome::packet;
  }

  void addLeftOut(Account& account) const override {
    addValues(account, "velocity", "packets have no speeds of joints", velocities_);
    addValues(account, "effort", "packets have no efforts", efforts_);
    addValues(account, "position", "of fixed and mimic joints, which the model moves", passive_);
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
    const std::vector<DeviceFinder::JointHome> homes = devices_.homesOf(topic_, names);
    for (std::size_t i = 0; i < homes.size(); ++i) {
      const DeviceFinder::JointHome& home = homes[i];
      if (home.fate == DeviceFinder::Fate::said && isName(home.name) && isName(home.device)) {
        addToPlan(home, i);
      } else if (home.fate == DeviceFinder::Fate::ambiguous) {
        leaveOut("joint states with joints of several devices; name the device in the topic");
      } else if (home.fate == DeviceFinder::Fate::passive) {
        ++passive_names_;
      } else {
        leaveOut("joint states with joints of no device; `log import --device` names one");
      }
    }
  }

  void addToPlan(const DeviceFinder::JointHome& home, std::size_t place) {
    DevicePlan* plan = nullptr;
    for (DevicePlan& each : plans_) {
      if (each.device == home.device && each.names.size() < limits::kJointValues) plan = &each;
    }
    if (plan == nullptr) {
      plan = &plans_.emplace_back();
      plan->device = home.device;
    }
    plan->places.push_back(place);
    plan->names.push_back(home.name);
  }

  void leaveOut(std::string sentence) {
    if (left_out_.empty() || left_out_.back() != sentence) left_out_.push_back(std::move(sentence));
  }

  /// Writes the text and the packet that decoding it would give.
  void say(std::int64_t stamp_ns) {
    // Both are reserved, so that the statements' views stay valid.
    numbers_.clear();
    numbers_.reserve(positions_.size());
    said_names_.clear();
    said_names_.reserve(positions_.size());
    statements_.clear();
    bool all_finite = true;
    for (const DevicePlan& plan : plans_) {
      const std::size_t first = numbers_.size();
      for (std::size_t i = 0; i < plan.places.size(); ++i) {
        const double value = positions_[plan.places[i]];
        if (!std::isfinite(value)) {
          all_finite = false;
          continue;
        }
        numbers_.push_back(value + 0.0);  // -0 to 0, as it is written
        said_names_.push_back(plan.names[i]);
      }
      const std::size_t count = numbers_.size() - first;
      if (count == 0) continue;
      Statement& statement = statements_.emplace_back();
      statement.kind = StatementKind::joint;
      statement.line = static_cast<std::uint32_t>(statements_.size() + 1);
      statement.name = plan.device;
      statement.numbers = std::span(numbers_).subspan(first, count);
      statement.names = std::span(said_names_).subspan(first, count);
      add(statement);
    }
    if (!all_finite) note("joint states with values that are not finite");
    packet_ = {};
    packet_.header.source = source_;
    if (stamp_ns > 0) packet_.header.time_ns = stamp_ns;
    packet_.statements = statements_;
  }

  Bytes name_bytes_;          ///< of the last message, with their count
  std::size_t names_at_ = 0;  ///< where they began: it decides their padding
  std::size_t names_ = 0;
  std::vector<DevicePlan> plans_;
  std::vector<std::string> left_out_;  ///< sentences for every message with these names
  std::size_t passive_names_ = 0;      ///< of fixed and mimic joints
  std::uint64_t velocities_ = 0, efforts_ = 0, passive_ = 0;
  std::vector<double> positions_, numbers_;
  std::vector<std::string_view> said_names_;
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
