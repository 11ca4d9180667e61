#include "core/foreign/ros/topic_translation.h"

#include <fmt/format.h>

#include "core/base/plain_text.h"
#include "core/foreign/ros/names.h"
#include "core/foreign/ros/signal_translation.h"
#include "core/math/transform.h"
#include "core/packet/packet_limits.h"

namespace rocinante::ros {
namespace {

using Outcome = RosTranslator::Outcome;

/// Bytes of a first case in a note; a stranger's name may be long.
constexpr std::size_t kMostOfFirst = 64;

class TransformTranslation final : public TopicTranslation {
 public:
  using TopicTranslation::TopicTranslation;

  Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime,
                    Translated& out) override {
    FieldCursor cursor(message, layout);
    const std::uint32_t count = cursor.count(kLeastTransformBytes);
    transforms_.clear();
    for (std::uint32_t i = 0; i < count && cursor.ok(); ++i) {
      transforms_.push_back(readTransform(cursor));
    }
    if (!cursor.atEnd()) return Outcome::malformed;
    for (const Transform& each : transforms_) {
      if (!isUsable(each.pose, "transforms")) continue;
      if (frames_.place(each.header.frame, each.child, each.pose, FrameTree::Origin::transform) ==
          FrameTree::Taken::refused) {
        noteRefused(each.header.frame, each.child, "transforms");
      }
    }
    begin(transforms_.empty() ? 0 : transforms_.front().header.stamp_ns);
    for (const FrameTree::Moved& each : frames_.takeMoved()) addPose(*each.device, each.place);
    return end(out);
  }

 private:
  std::vector<Transform> transforms_;
};

class OdometryTranslation final : public SignalTranslation {
 public:
  using SignalTranslation::SignalTranslation;

  Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime,
                    Translated& out) override {
    if (!readSignals(message, layout)) return Outcome::malformed;
    FieldCursor cursor(message, layout);
    const Transform placed = readTransform(cursor);
    begin(placed.header.stamp_ns);
    if (isUsable(placed.pose, kOdometry)) takePlace(placed);
    addSignals();
    return end(out);
  }

 private:
  static constexpr std::string_view kOdometry = "odometry";

  void takePlace(const Transform& placed) {
    switch (frames_.place(placed.header.frame, placed.child, placed.pose,
                          FrameTree::Origin::odometry)) {
      case FrameTree::Taken::yes:
        for (const FrameTree::Moved& each : frames_.takeMoved()) addPose(*each.device, each.place);
        break;
      case FrameTree::Taken::overruled:
        note("odometry of a frame that transforms or another odometry place");
        break;
      case FrameTree::Taken::refused:
        noteRefused(placed.header.frame, placed.child, kOdometry);
        break;
    }
  }
};

class PoseTranslation final : public TopicTranslation {
 public:
  PoseTranslation(std::string_view topic, const DeviceFinder& devices, FrameTree& frames)
      : TopicTranslation(topic, devices, frames) {
    if (const auto named = devices.deviceOfTopic(topic)) {
      device_ = *named;
    } else if (!devices.knowsDevices()) {
      const std::string_view path = topic.starts_with('/') ? topic.substr(1) : topic;
      device_ = devices.madeUpDevice(topic, path);
    } else {
      device_ = devices.fallback();
    }
  }

  Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime,
                    Translated& out) override {
    FieldCursor cursor(message, layout);
    const Transform stamped = readPoseStamped(cursor);
    if (!cursor.atEnd()) return Outcome::malformed;
    if (!isName(device_)) {
      note("poses whose topic names no device of the cell");
      return Outcome::nothing;
    }
    if (!isUsable(stamped.pose, "poses")) return Outcome::nothing;
    const std::optional<FrameTree::Place> place =
        frames_.placeIn(stamped.header.frame, stamped.pose, device_);
    if (!place) {
      note("poses in a frame without a place", stamped.header.frame);
      return Outcome::nothing;
    }
    begin(stamped.header.stamp_ns);
    addPose(device_, *place);
    return end(out);
  }

 private:
  std::string device_;
};

class LogTranslation final : public TopicTranslation {
 public:
  LogTranslation(std::string_view topic, const DeviceFinder& devices, FrameTree& frames,
                 bool ros1_fields)
      : TopicTranslation(topic, devices, frames), ros1_fields_(ros1_fields) {}

  Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime,
                    Translated& out) override {
    FieldCursor cursor(message, layout);
    const LogText log = readLog(cursor, ros1_fields_);
    if (!cursor.atEnd()) return Outcome::malformed;
    std::string text(log.level);
    text.append(" ").append(log.node).append(": ").append(log.text);
    // Bytes that are not UTF-8 are written as three.
    const bool is_utf8 = isUtf8(bytesOf(text));
    const std::size_t room = is_utf8 ? limits::kStringBytes : limits::kStringBytes / 3;
    if (text.size() > room) {
      std::size_t end = room;
      while (is_utf8 && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
      text.resize(end);
      note("log texts that were cut at 4096 bytes");
    }
    if (log.has_place) ++places_;
    begin(log.header.stamp_ns);
    Statement event;
    event.kind = StatementKind::event;
    event.text = text;
    add(event);
    return end(out);
  }

  void addLeftOut(Account& account) const override {
    addValues(account, "file, function, line", "events have a text alone", places_);
  }

 private:
  bool ros1_fields_;
  std::uint64_t places_ = 0;
};

}  // namespace

TopicTranslation::TopicTranslation(std::string_view topic, const DeviceFinder& devices,
                                   FrameTree& frames)
    : topic_(topic), devices_(devices), frames_(frames), source_(sourceOf(topic)) {}

void TopicTranslation::begin(std::int64_t stamp_ns) {
  PacketHeader header;
  header.source = source_;
  if (stamp_ns > 0) header.time_ns = stamp_ns;
  packet_text_.begin(header);
}

void TopicTranslation::addPose(std::string_view device, const FrameTree::Place& place) {
  const Pose& pose = place.pose;
  const double numbers[] = {pose.position.x,    pose.position.y,    pose.position.z,
                            pose.orientation.x, pose.orientation.y, pose.orientation.z,
                            pose.orientation.w};
  Statement statement;
  statement.kind = StatementKind::pose;
  statement.name = device;
  statement.numbers = numbers;
  statement.carrier = {place.device, place.link, false};
  add(statement);
}

bool TopicTranslation::isUsable(const Pose& pose, std::string_view what) {
  const Quat& q = pose.orientation;
  const std::string poses(what);
  if (!normalized(q)) {
    note(poses + " whose rotation is zero or not finite",
         fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}", q.x, q.y, q.z, q.w));
    return false;
  }
  if (!isFinite(pose.position)) {
    const Vec3& at = pose.position;
    note(poses + " whose position is not finite",
         fmt::format("{:.6g} {:.6g} {:.6g}", at.x, at.y, at.z));
    return false;
  }
  if (!isUnitLength(q)) {
    note(poses + " whose quaternion is off unit length by more than 0.001, normalised",
         fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}, of length {:.6g}", q.x, q.y, q.z, q.w,
                     lengthOf(q)));
  }
  return true;
}

void TopicTranslation::noteRefused(std::string_view parent, std::string_view child,
                                   std::string_view what) {
  const std::string places(what);
  if (!isName(parent) || !isName(child)) {
    note(places + " with a frame whose name no packet can have", isName(parent) ? child : parent);
  } else if (parent == child) {
    note(places + " of a frame in itself", child);
  } else {
    note(places + " beyond 4096 frames", child);
  }
}

Outcome TopicTranslation::end(Translated& out) {
  if (!packet_text_.hasStatements()) return Outcome::nothing;
  out = {packet_text_.text(), nullptr};
  return Outcome::packet;
}

void TopicTranslation::addValues(Account& account, const char* name, const char* reason,
                                 std::uint64_t count) const {
  if (count == 0) return;
  account.leaveOut(
      {.kind = "value", .name = name, .reason = reason, .first = topic_, .count = count});
}

void TopicTranslation::note(std::string_view sentence, std::string_view first) {
  const auto found = notes_.find(sentence);
  if (found != notes_.end()) {
    ++found->second;
    return;
  }
  notes_.emplace(sentence, 1);
  if (!first.empty()) firsts_.emplace(sentence, plainText(first.substr(0, kMostOfFirst)));
}

TranslationNotes TopicTranslation::notes() const {
  TranslationNotes notes;
  for (const auto& [sentence, count] : notes_) {
    const auto first = firsts_.find(sentence);
    const std::string first_text =
        first == firsts_.end() ? "" : " (the first: " + first->second + ")";
    notes.emplace(sentence + first_text, count);
  }
  return notes;
}

std::unique_ptr<TopicTranslation> makeTranslation(std::string_view type, std::string_view topic,
                                                  const DeviceFinder& devices, FrameTree& frames,
                                                  SignalNames& names) {
  const auto rows = [type] { return signalMessages(shortTypeName(type)); };
  const MessageType known = messageType(type);
  switch (known) {
    case MessageType::joint_state:
      return makeJointTranslation(topic, devices, frames);
    case MessageType::transforms:
      return std::make_unique<TransformTranslation>(topic, devices, frames);
    case MessageType::pose_stamped:
      return std::make_unique<PoseTranslation>(topic, devices, frames);
    case MessageType::odometry:
      return std::make_unique<OdometryTranslation>(topic, devices, frames, rows(), names);
    case MessageType::marker:
    case MessageType::marker_array:
      return makeMarkerTranslation(topic, devices, frames, known == MessageType::marker_array);
    case MessageType::log_ros1:
    case MessageType::log_ros2:
      return std::make_unique<LogTranslation>(topic, devices, frames,
                                              known == MessageType::log_ros1);
    case MessageType::signals:
      return std::make_unique<SignalTranslation>(topic, devices, frames, rows(), names);
    case MessageType::other:
      break;
  }
  return nullptr;
}

}  // namespace rocinante::ros
