#include "golden/run/session_track.h"

#include <fmt/format.h>

#include <functional>
#include <set>
#include <string>

#include "core/log/log_profile.h"
#include "core/log/log_reader.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"
#include "golden/run/track_recorder.h"

namespace rocinante {

const TrackColumn* DeviceTrack::find(std::string_view part, bool is_link) const {
  for (const TrackColumn& column : columns) {
    if (column.part == part && (column.kind == TrackColumn::Kind::link_pose) == is_link) {
      return &column;
    }
  }
  return nullptr;
}

Result<SessionTrack> trackSession(const Cell& cell, const std::filesystem::path& log,
                                  const std::vector<std::string>& links) {
  auto timeline = Timeline::open(log);
  if (!timeline.ok()) return timeline.error();
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
  }
  const auto shouldBePacket = [&](const LogChannel& channel) {
    return channel.captured() && !channel.imported() &&
           (channel.encoding == "rk1" || !octets.contains(channel.topic));
  };
  MessageFolder folder;
  for (;;) {
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

}  // namespace rocinante
