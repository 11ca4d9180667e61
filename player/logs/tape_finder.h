#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/packet/session_state.h"
#include "core/session/timeline.h"
#include "player/logs/message_folder.h"
#include "player/logs/multi_log_reader.h"

namespace rocinante {

/// Answers what a player asks about places it is not at: the state there, what lies before it, the
/// events. Reads the logs by readers of its own, so that what is being read ahead is not disturbed.
/// One thread.
class TapeFinder {
 public:
  static Result<TapeFinder> open(std::vector<std::filesystem::path> paths, ChannelChoice choice);

  /// The fold of every message before `place`, so that playing from there continues it. Of a single
  /// log that is played whole it begins at a keyframe; else at the last state kept on the way of an
  /// earlier question, or at the start.
  Result<SessionState> stateBefore(TapePosition place);
  /// Every SOURCE that is named by the logs or was met in a state: who must be reset.
  const std::set<std::string>& sources() const { return sources_; }

  /// True when a captured message lies in [from, until).
  Result<bool> anyIn(LogTime from, LogTime until);
  /// MultiLogReader::back.
  Result<MultiLogReader::Earlier> back(TapePosition place, std::uint64_t count, LogTime floor);

  /// When something is marked on the time line: events and marks, oldest first, each moment once.
  /// The first call reads the logs once.
  Result<const std::vector<LogTime>*> eventTimes();

  std::vector<std::string> damage() const { return merge_.damage(); }
  /// What the states that were asked for may lack because a log is damaged; known of a single log.
  const StateDamage& stateDamage() const { return state_damage_; }

 private:
  TapeFinder(std::vector<std::filesystem::path> paths, ChannelChoice choice, MultiLogReader merge)
      : paths_(std::move(paths)), choice_(std::move(choice)), merge_(std::move(merge)) {}

  Result<SessionState> nearestBefore(TapePosition place, TapePosition& from);
  void keep(TapePosition place, const SessionState& state);

  std::vector<std::filesystem::path> paths_;
  ChannelChoice choice_;
  MultiLogReader merge_;
  MessageFolder folder_;
  std::optional<Timeline> timeline_;  ///< of a single log that is played whole
  StateDamage state_damage_;
  std::set<std::string> sources_;
  std::optional<std::vector<LogTime>> event_times_;

  /// States along the way of several logs, whose keyframes know one log alone: two that speak of
  /// one device cannot be put together without what lies between. Where there are too many, every
  /// other one goes and they are kept half as often.
  std::map<TapePosition, SessionState> kept_;
  std::uint64_t kept_bytes_ = 0;
  std::uint64_t keep_each_ = 1024;
};

}  // namespace rocinante
