#include "core/foreign/ros_out/ros2_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/foreign/ros_out/cdr_writer.h"
#include "core/packet/channel_names.h"

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
    return out.write("/" + uniqueName(device) + "/joint_states",
                     ros2Schema("sensor_msgs/msg/JointState"), time, message_,
                     metadataOf({device, {}, {}, {}}));
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
    return out.write("/" + uniqueName(source) + "/markers",
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
                 std::span<const SaidSignal> said, bool /*wants_all*/) override {
    constexpr std::array<const char*, 3> kTypes = {"std_msgs/msg/Float64", "std_msgs/msg/Bool",
                                                   "std_msgs/msg/String"};
    for (const SaidSignal& signal : said) {
      if (!signal.is_new || signal.in_joints) continue;
      const SignalValue& value = *signal.value;
      CdrWriter writer(message_);
      if (value.kind == SignalKind::number) writer.put(value.number);
      if (value.kind == SignalKind::boolean) writer.put(value.number != 0);
      if (value.kind == SignalKind::text) writer.text(value.text);
      const ChannelNames is = {owner.first, owner.second, std::string(signal.name), value.unit};
      const MessageSchema& schema = ros2Schema(kTypes[static_cast<std::size_t>(value.kind)]);
      Status written =
          out.write(signalTopic(is, value.kind), schema, time, message_, metadataOf(is));
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
    return out.write("/" + uniqueName(device) + "/robot_description",
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

  /// Two names that ROS would write alike get numbers.
  std::string uniqueName(const std::string& name) {
    const auto known = names_.find(name);
    if (known != names_.end()) return known->second;
    const std::string wanted = rosName(name);
    std::string given = wanted;
    for (int number = 2; !given_.insert(given).second; ++number) {
      given = wanted + "_" + std::to_string(number);
    }
    return names_.emplace(name, given).first->second;
  }

  /// What a topic's name cannot hold.
  const ChannelMetadata& metadataOf(const ChannelNames& is) {
    const auto [place, is_new] = metadata_.try_emplace(is);
    if (is_new) place->second = channelMetadata(is);
    return place->second;
  }

  /// A topic has one type and unit: a signal that changes them gets another one, and so does a
  /// second one whose names ROS would write alike.
  const std::string& signalTopic(const ChannelNames& is, SignalKind kind) {
    auto [place, is_new] = signal_topics_.try_emplace({is, kind});
    std::string& made = place->second;
    if (!is_new) return made;
    std::string wanted = "/signals";
    for (const std::string_view part :
         {std::string_view(is.device), std::string_view(is.link), std::string_view(is.signal)}) {
      if (!part.empty()) wanted += "/" + rosName(part);
    }
    made = wanted;
    for (int number = 2; !given_topics_.insert(made).second; ++number) {
      made = wanted + "_" + std::to_string(number);
    }
    if (made != wanted) {
      left_out_.leaveOut({.kind = "topic",
                          .name = wanted,
                          .reason = "it is another signal's, or of another type: `" +
                                    ownerText({is.device, is.link}) + " " + is.signal + "` is on " +
                                    made});
    }
    return made;
  }

  Bytes message_;
  Account left_out_;
  std::map<std::pair<ChannelNames, SignalKind>, std::string> signal_topics_;
  std::set<std::string> given_topics_;
  std::map<ChannelNames, ChannelMetadata> metadata_;
  std::map<std::string, std::string> names_;  ///< as ROS has them
  std::set<std::string> given_;
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
