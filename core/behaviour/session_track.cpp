#include "core/behaviour/session_track.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "core/behaviour/track_recorder.h"
#include "core/kinematics/joint_values.h"
#include "core/log/log_profile.h"
#include "core/log/log_reader.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

TrackColumn::Kind columnKind(const Joint& joint, std::size_t component) {
  if (kindOf(joint, component) != ValueKind::angle) return TrackColumn::Kind::length;
  return joint.type == JointType::revolute ? TrackColumn::Kind::angle
                                           : TrackColumn::Kind::full_angle;
}

}  // namespace

const TrackColumn* DeviceTrack::find(std::string_view part, bool is_link) const {
  for (const TrackColumn& column : columns) {
    if (column.part == part && (column.kind == TrackColumn::Kind::link_pose) == is_link) {
      return &column;
    }
  }
  return nullptr;
}

Result<SessionTrack> trackSession(const Cell& cell, const std::filesystem::path& log,
                                  const std::vector<std::string>& links,
                                  const std::stop_token& stop) {
  auto timeline = Timeline::open(log);
  if (!timeline.ok()) return timeline.error();
  timeline->useStop(stop);
  const LogSummary summary = timeline->log().summary();
  if (!summary.closed) {
    return Error{ErrorKind::damaged,
                 "the log has no end, so perhaps not the whole session; `rocinante log recover` "
                 "writes a whole log of what it has",
                 log.string()};
  }
  if (summary.messages == 0) {
    return Error{ErrorKind::not_found, "the log has no message to judge", log.string()};
  }
  SessionTrack track;
  track.origin = summary.origin;
  track.start = summary.start;
  track.end = summary.end;
  TrackRecorder recorder(cell, track, links);
  const auto first = timeline->stateAt(track.start - Nanoseconds(1));
  if (!first.ok()) return first.error();
  recorder.begin(**first);
  auto reader = LogReader::open(log);
  if (!reader.ok()) return reader.error();
  if (Status found = reader->seek(track.start); !found) return found.error();
  // Octets that a decoder or an import reads have their packets beside them, or an account of
  // theirs.
  std::set<std::string, std::less<>> octets;
  for (const LogChannel& channel : reader->channels()) {
    if (channel.decoded()) octets.emplace(profile::capturedTopic(channel.topic));
    track.is_imported = track.is_imported || channel.imported();
  }
  const auto shouldBePacket = [&](const LogChannel& channel) {
    return channel.captured() && !channel.imported() &&
           (channel.encoding == "rk1" || !octets.contains(channel.topic));
  };
  MessageFolder folder;
  for (std::uint64_t count = 1;; ++count) {
    constexpr std::uint64_t kAtATime = 1024;
    if (count % kAtATime == 0 && stop.stop_requested()) {
      return Error{ErrorKind::refused, "stopped", log.string()};
    }
    const auto message = reader->next();
    if (!message.ok()) return message.error();
    if (!*message || (*message)->log_time > track.end) break;
    if (!(*message)->channel->folded()) continue;
    if (const Packet* packet = folder.decode(**message)) {
      recorder.add((*message)->log_time, *packet);
    } else if (shouldBePacket(*(*message)->channel)) {
      track.left_out.leaveOut(
          {"datagram", (*message)->channel->topic, "it is no packet",
           fmt::format("{:.3f} s", secondsOf((*message)->log_time - track.origin)), 1,
           Severity::warning});
    }
  }
  if (!reader->unreadable().empty() && !reader->damage().empty()) {
    const DamageSpan& span = reader->damage().front();
    return Error{ErrorKind::damaged, "the log is damaged and was not seen whole: " + span.cause,
                 log.string() + ", byte " + std::to_string(span.from)};
  }
  if (Status kept = recorder.finish(); !kept) return kept.error();
  return track;
}

std::vector<TrackColumn> columnsOf(const Model& model) {
  std::vector<TrackColumn> columns;
  std::size_t offset = 0;
  const auto add = [&](TrackColumn column) {
    column.offset = offset;
    offset += column.width();
    columns.push_back(std::move(column));
  };
  for (const Joint& joint : model.joints) {
    if (joint.type == JointType::floating) {
      add({joint.name, TrackColumn::Kind::pose});
      continue;
    }
    for (std::size_t i = 0; i < valueCount(joint.type); ++i) {
      add({valueName(joint, i), columnKind(joint, i)});
    }
  }
  add({"", TrackColumn::Kind::pose});
  return columns;
}

void interpolate(const TrackColumn& column, const double* a, const double* b, double part,
                 double* out) {
  if (column.kind == TrackColumn::Kind::full_angle) {
    out[0] = a[0] + part * std::remainder(b[0] - a[0], 2 * std::numbers::pi);
    return;
  }
  const std::size_t linear = column.width() == 7 ? 3 : 1;
  for (std::size_t i = 0; i < linear; ++i) out[i] = a[i] + part * (b[i] - a[i]);
  if (linear == 1) return;
  // q and -q are the same orientation.
  double dot = 0;
  for (std::size_t i = 3; i < 7; ++i) dot += a[i] * b[i];
  const double sign = dot < 0 ? -1 : 1;
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) {
    out[i] = a[i] + part * (sign * b[i] - a[i]);
    square += out[i] * out[i];
  }
  if (!(square > 0)) return;
  for (std::size_t i = 3; i < 7; ++i) out[i] /= std::sqrt(square);
}

}  // namespace rocinante
