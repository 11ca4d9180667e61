#include "recorder/ros_out/ros2_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/foreign/session/exported_mcap.h"
#include "core/foreign/session/given_names.h"
#include "core/packet/channel_names.h"
#include "recorder/ros_out/cdr_writer.h"

namespace rocinante {
namespace {

enum MarkerType : std::int32_t { kLineStrip = 4, kPoints = 8, kText = 9 };
enum MarkerAction : std::int32_t { kAdd = 0, kDeleteAll = 3 };

void putStamp(CdrWriter& out, LogTime time) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  const std::int64_t all = nanosecondsOf(time);
  const std::int64_t nanos = ((all % kNanoseconds) + kNanoseconds) % kNanoseconds;
  out.put(static_cast<std::int32_t>((all - nanos) / kNanoseconds));
  out.put(static_cast<std::uint32_t>(nanos));
}

void putHeader(CdrWriter& out, LogTime time, std::string_view frame) {
  putStamp(out, time);
  out.text(frame);
}

void putTriple(CdrWriter& out, double x, double y, double z) {
  out.put(x);
  out.put(y);
  out.put(z);
}

void putRotation(CdrWriter& out, const Quat& rotation) {
  putTriple(out, rotation.x, rotation.y, rotation.z);
  out.put(rotation.w);
}

/// One marker: what it shows, and its points or its text.
struct MarkerParts {
  std::string_view frame, ns;
  std::int32_t id = 0, type = 0, action = kAdd;
  Vec3 at{};
  double scale_x = 0, scale_y = 0, scale_z = 0;
  std::uint32_t rgba = 0;
  std::span<const double> points;
  std::string_view text;
};

void putMarker(CdrWriter& out, LogTime time, const MarkerParts& marker) {
  putHeader(out, time, marker.frame);
  out.text(marker.ns);
  out.put(marker.id);
  out.put(marker.type);
  out.put(marker.action);
  putTriple(out, marker.at.x, marker.at.y, marker.at.z);
  putRotation(out, Quat(1, 0, 0, 0));
  putTriple(out, marker.scale_x, marker.scale_y, marker.scale_z);
  for (std::uint32_t byte = 0; byte < 4; ++byte) {
    out.put(static_cast<float>(marker.rgba >> (24 - 8 * byte) & 0xFFU) / 255.0F);
  }
  out.put(std::int32_t{0});  // stays until it is deleted
  out.put(std::uint32_t{0});
  out.put(true);  // moves with its space
  out.count(marker.points.size() / 3);
  for (const double coordinate : marker.points) out.put(coordinate);
  out.count(0);  // colours
  out.text("");  // texture, and its image
  putHeader(out, LogTime{}, "");
  out.text("");
  out.count(0);
  out.count(0);  // texture coordinates
  out.text(marker.text);
  out.text("");  // mesh, and its file
  out.text("");
  out.count(0);
  out.put(false);
}

/// As many as joints, with NaN for those that are not known; none when none is.
void putAll(CdrWriter& out, std::span<const NamedValue> values, double NamedValue::*quantity) {
  const bool is_known = std::ranges::any_of(
      values, [&](const NamedValue& value) { return !std::isnan(value.*quantity); });
  out.count(is_known ? values.size() : 0);
  if (!is_known) return;
  for (const NamedValue& value : values) out.put(value.*quantity);
}

class Ros2Format final : public SessionFormat {
 public:
  std::string profile() const override { return "ros2"; }
  // tf buffers keep ten seconds.
  Nanoseconds framesLast() const override { return std::chrono::seconds(1); }

  Status frames(MessageSink& out, LogTime time, const std::string&,
                std::span<const FramePose> frames) override {
    CdrWriter writer(message_);
    writer.count(frames.size());
    for (const FramePose& frame : frames) {
      putHeader(writer, time, frame.parent);
      writer.text(frame.child);
      putTriple(writer, frame.pose.position.x, frame.pose.position.y, frame.pose.position.z);
      putRotation(writer, frame.pose.orientation);
    }
    return out.write("/tf", ros2Schema("tf2_msgs/msg/TFMessage"), time, message_);
  }

  Status joints(MessageSink& out, LogTime time, const std::string& device,
                std::span<const NamedValue> values) override {
    CdrWriter writer(message_);
    putHeader(writer, time, "");
    writer.count(values.size());
    for (const NamedValue& value : values) writer.text(value.name);
    writer.count(values.size());
    for (const NamedValue& value : values) writer.put(value.value);
    putAll(writer, values, &NamedValue::velocity);
    putAll(writer, values, &NamedValue::effort);
    const Place& place = placeOf(device);
    return out.write("/" + place.topic + "/joint_states", ros2Schema("sensor_msgs/msg/JointState"),
                     time, message_, place.metadata);
  }

  Status drawings(MessageSink& out, LogTime time, const std::string& source,
                  const Drawings& drawings) override {
    std::vector<MarkerParts> markers(1);
    markers[0].action = kDeleteAll;
    std::vector<std::string> frames;
    std::vector<std::vector<std::vector<double>>> runs;
    frames.reserve(drawings.size());
    runs.reserve(drawings.size());
    for (const auto& [id, drawing] : drawings) {
      frames.push_back(frameName(drawing->carrier.first, drawing->carrier.second));
      runs.push_back(connectedRuns(*drawing));
      addMarkers(markers, id, *drawing, frames.back(), runs.back());
    }
    CdrWriter writer(message_);
    writer.count(markers.size());
    for (const MarkerParts& marker : markers) putMarker(writer, time, marker);
    return out.write("/" + placeOf(source).topic + "/markers",
                     ros2Schema("visualization_msgs/msg/MarkerArray"), time, message_);
  }

  bool knowSignals(const KnownSignals& known) override {
    for (const auto& [owner, signals] : known.byOwner()) {
      for (const auto& [name, signal] : signals) {
        if (signal.unit.empty()) continue;
        left_out_.leaveOut({.kind = "unit",
                            .name = signal.unit,
                            .reason = "std_msgs and joint states have no units",
                            .first = ownerText(owner) + " " + name});
      }
    }
    if (known.beyond().units > 0) {
      left_out_.leaveOut({.kind = "unit",
                          .reason = "of signals beyond the first 65,536",
                          .count = known.beyond().units});
    }
    return true;
  }

  Status signals(MessageSink& out, LogTime time, const SignalOwner& owner,
                 std::span<const StatedSignal> signals, bool /*all_requested*/) override {
    constexpr std::array<const char*, 3> kTypes = {"std_msgs/msg/Float64", "std_msgs/msg/Bool",
                                                   "std_msgs/msg/String"};
    for (const StatedSignal& signal : signals) {
      if (!signal.is_new || signal.in_joints) continue;
      const SignalValue& value = *signal.value;
      CdrWriter writer(message_);
      if (value.kind == SignalKind::number) writer.put(value.number);
      if (value.kind == SignalKind::boolean) writer.put(value.number != 0);
      if (value.kind == SignalKind::text) writer.text(value.text);
      const Place& place =
          placeOf({{owner.first, owner.second, std::string(signal.name), value.unit}, value.kind});
      const MessageSchema& schema = ros2Schema(kTypes[static_cast<std::size_t>(value.kind)]);
      Status written = out.write(place.topic, schema, time, message_, place.metadata);
      if (!written) return written;
    }
    return {};
  }

  void addLeftOut(Account& account) const override { account.add(left_out_); }

  Status event(MessageSink& out, LogTime time, EventLevel level, std::string_view name,
               std::string_view text) override {
    constexpr std::uint8_t kInfo = 20;
    constexpr std::uint8_t kWarning = 30;
    constexpr std::uint8_t kError = 40;
    CdrWriter writer(message_);
    putStamp(writer, time);
    writer.put(level == EventLevel::error     ? kError
               : level == EventLevel::warning ? kWarning
                                              : kInfo);
    writer.text(name);
    writer.text(text);
    writer.text("");
    writer.text("");
    writer.put(std::uint32_t{0});
    return out.write("/rosout", ros2Schema("rcl_interfaces/msg/Log"), time, message_);
  }

  Status description(MessageSink& out, LogTime time, const std::string& device,
                     std::string_view urdf) override {
    CdrWriter writer(message_);
    writer.text(urdf);
    return out.write("/" + placeOf(device).topic + "/robot_description",
                     ros2Schema("std_msgs/msg/String"), time, message_);
  }

 private:
  static void addMarkers(std::vector<MarkerParts>& markers, std::string_view id,
                         const Drawing& drawing, std::string_view frame,
                         const std::vector<std::vector<double>>& runs) {
    std::int32_t number = 0;
    for (const std::vector<double>& run : runs) {
      MarkerParts marker;
      marker.frame = frame;
      marker.ns = id;
      marker.id = number++;
      marker.rgba = drawing.rgba;
      if (drawing.kind == StatementKind::label) {
        if (run.size() < 3) continue;
        marker.type = kText;
        marker.at = {run[0], run[1], run[2]};
        marker.scale_z = kMarkerTextMetres;
        marker.text = drawing.text;
      } else {
        const bool is_line = drawing.kind == StatementKind::line;
        marker.type = is_line ? kLineStrip : kPoints;
        marker.scale_x = drawing.size_px * kMarkerMetresPerPixel;
        marker.scale_y = is_line ? 0 : marker.scale_x;
        marker.points = run;
      }
      markers.push_back(marker);
    }
  }

  /// A channel of signals: one type and one unit.
  using SignalKey = std::pair<ChannelNames, SignalKind>;
  struct Place {
    std::string topic;         ///< of a device or a source: its part of one
    ChannelMetadata metadata;  ///< what the topic's name cannot hold
  };

  /// Of a device or a source; valid until the next call. Names that ROS would write alike get
  /// numbers.
  const Place& placeOf(const std::string& name) {
    const auto known = places_.find(name);
    if (known != places_.end()) return known->second;
    const std::string wanted = rosName(name);
    // Each has a channel, and the file no more of them: no need to know those beyond.
    if (places_.size() == ExportedMcap::kMostChannels) return beyond_ = {given_.free(wanted), {}};
    return places_.emplace(name, Place{given_.take(wanted), channelMetadata({name, {}, {}, {}})})
        .first->second;
  }

  /// The same of a signal. One that changes its type or its unit gets another topic, and so does a
  /// second one whose names ROS would write alike.
  const Place& placeOf(const SignalKey& key) {
    const auto known = signal_places_.find(key);
    if (known != signal_places_.end()) return known->second;
    const ChannelNames& is = key.first;
    std::string wanted = "/signals";
    for (const std::string_view part :
         {std::string_view(is.device), std::string_view(is.link), std::string_view(is.signal)}) {
      if (!part.empty()) wanted += "/" + rosName(part);
    }
    if (signal_places_.size() == ExportedMcap::kMostChannels) {
      return beyond_ = {given_signals_.free(wanted), {}};
    }
    const auto made =
        signal_places_.emplace(key, Place{given_signals_.take(wanted), channelMetadata(is)}).first;
    const std::string& topic = made->second.topic;
    if (topic != wanted) {
      left_out_.leaveOut({.kind = "topic",
                          .name = wanted,
                          .reason = whyOther(*signal_of_.at(wanted), key) + " is on " + topic});
    }
    signal_of_.emplace(topic, &made->first);
    return made->second;
  }

  /// Why `other` is not on the topic that `has` has.
  static std::string whyOther(const SignalKey& has, const SignalKey& other) {
    const ChannelNames& is = other.first;
    const std::string name = "`" + ownerText({is.device, is.link}) + " " + is.signal + "`";
    ChannelNames same = has.first;
    same.unit = is.unit;
    if (same != is) return "it is another signal's: " + name;
    if (has.second != other.second) return "it is of another type: " + name;
    return "it is in another unit: " + name + (is.unit.empty() ? " without one" : " in " + is.unit);
  }

  Bytes message_;
  Account left_out_;
  std::map<SignalKey, Place> signal_places_;
  std::map<std::string_view, const SignalKey*> signal_of_;  ///< by topic; both of signal_places_
  GivenNames given_signals_;
  std::map<std::string, Place> places_;  ///< by name
  GivenNames given_;
  Place beyond_;
};

}  // namespace

std::string rosName(std::string_view name) {
  std::string made;
  for (const char byte : name) {
    const bool is_plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                          (byte >= '0' && byte <= '9');
    made += is_plain ? byte : '_';
  }
  if (!made.empty() && made[0] >= '0' && made[0] <= '9') made.insert(0, "_");
  return made;
}

std::unique_ptr<SessionFormat> makeRos2Format() { return std::make_unique<Ros2Format>(); }

}  // namespace rocinante
