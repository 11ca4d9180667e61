#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"
#include "player/logs/multi_log_reader.h"

namespace rocinante {

/// Answers queries about other places of the logs: the state there, the messages before it, the
/// events. Uses its own readers, so that reading ahead is not disturbed. One thread.
class TapeFinder {
 public:
  static Result<TapeFinder> open(std::vector<std::filesystem::path> paths, ChannelChoice choice);

  /// The fold of every message before `place`, so that playing from there continues it. For a
  /// single log that is played whole it starts at a keyframe; otherwise at the nearest state kept
  /// by an earlier query, or at the start.
  Result<SessionState> stateBefore(TapePosition place);
  /// Every SOURCE named by the logs or found in a state: the ones to reset.
  const std::set<std::string>& sources() const { return sources_; }

  /// True when there is a captured message in [from, until).
  Result<bool> anyIn(LogTime from, LogTime until);
  /// MultiLogReader::back.
  Result<MultiLogReader::Earlier> back(TapePosition place, std::uint64_t count, LogTime floor);

  /// The times of events and marks, oldest first, each once. The first call reads the logs.
  Result<const std::vector<LogTime>*> eventTimes();

  std::vector<std::string> damage() const { return merge_.damage(); }
  /// Damage that may affect the states returned so far; known for a single log only.
  const StateDamage& stateDamage() const { return state_damage_; }

 private:
  TapeFinder(std::vector<std::filesystem::path> paths, ChannelChoice choice, MultiLogReader merge)
      : paths_(std::move(paths)), choice_(std::move(choice)), merge_(std::move(merge)) {}

  /// stateBefore() of several logs: from the nearest kept state, message by message.
  Result<SessionState> foldUpTo(TapePosition place);
  void keep(TapePosition place, const SessionState& state);

  std::vector<std::filesystem::path> paths_;
  ChannelChoice choice_;
  MultiLogReader merge_;
  MessageFolder folder_;
  std::optional<Timeline> timeline_;  ///< for a single log that is played whole
  StateDamage state_damage_;
  std::set<std::string> sources_;
  std::optional<std::vector<LogTime>> event_times_;

  /// States of several logs at intervals. Keyframes know one log only: those of two logs about one
  /// device cannot be combined without the messages between. When there are too many states, every
  /// other one is dropped and the interval doubles.
  std::map<TapePosition, SessionState> kept_;
  std::uint64_t kept_bytes_ = 0;
  std::uint64_t keep_each_ = 1024;
};

}  // namespace rocinante
