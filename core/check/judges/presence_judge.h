#pragma once

#include "core/check/judges/tally.h"

namespace rocinante {

/// Whether statements about a device come while it is there. Sources may start at any moment and
/// a session in the middle of them: only what one source said in the wrong order counts.
class PresenceJudge {
 public:
  /// It stands in the cell from the start.
  void beThere() { state_ = State::there; }

  void add(const PacketPlace& place);
  void remove(const PacketPlace& place);
  /// Any other statement about it.
  void mention(const PacketPlace& place) {
    if (state_ != State::there) mentionAbsent(place);
  }

  bool everThere() const { return state_ != State::unknown; }
  /// Said by the source that then added it.
  const Tally& beforeAdd() const { return before_add_; }
  const Tally& afterRemove() const { return after_remove_; }

 private:
  enum class State : std::uint8_t { unknown, there, removed };

  void mentionAbsent(const PacketPlace& place);

  State state_ = State::unknown;
  Tally waiting_;  ///< said while it was not there, by the first source that did
  std::uint32_t waiting_source_ = 0, waiting_stretch_ = 0;
  std::uint32_t remover_ = 0;
  LogTime removed_at_{};
  Tally before_add_, after_remove_;
};

}  // namespace rocinante
