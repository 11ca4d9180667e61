#pragma once

#include "core/check/judges/tally.h"

namespace rocinante {

/// Judges whether statements about a device come while it exists. Sources may start at any moment,
/// and a session may begin in the middle: only the order within one source counts.
class PresenceJudge {
 public:
  /// The device is in the cell from the start.
  void markPresent() { state_ = State::there; }

  void add(const PacketPlace& place);
  void remove(const PacketPlace& place);
  /// Any other statement about it.
  void mention(const PacketPlace& place) {
    if (state_ != State::there) mentionAbsent(place);
  }

  bool everThere() const { return state_ != State::unknown; }
  bool isThere() const { return state_ == State::there; }
  void report(const std::string& device, Findings& findings) const;
  /// Forgets what was found, not whether the device is there.
  void dropFindings() { before_add_ = after_remove_ = {}; }

 private:
  enum class State : std::uint8_t { unknown, there, removed };

  void mentionAbsent(const PacketPlace& place);

  State state_ = State::unknown;
  Tally waiting_;  ///< statements while it was absent, by the first source that made one
  std::uint32_t waiting_source_ = 0, waiting_stretch_ = 0;
  std::uint32_t remover_ = 0;
  LogTime removed_at_{};
  Tally before_add_;  ///< statements by the source that then added it
  Tally after_remove_;
};

}  // namespace rocinante
