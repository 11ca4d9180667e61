#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "core/check/judges/tally.h"
#include "core/packet/packet.h"

namespace rocinante {

/// When a source last said each part of its static state: what a late joiner misses when it is not
/// said again, whether or not a packet is marked `restated`.
class StaticItems {
 public:
  /// False for joint values, poses, numbers of signals and events, which are no state to be
  /// restated.
  static bool isStatic(const Statement& statement);

  /// Of what is not static only that a signal is no state any more counts.
  void take(const Statement& statement, LogTime time);
  /// When the item that was not said for longest was last said; empty without items, and when there
  /// are more than are followed.
  std::optional<LogTime> oldest() const;

 private:
  static constexpr std::size_t kMaxItems = 256;
  struct Item {
    std::size_t device = 0;
    LogTime stated_at{};
  };

  void take(const Statement& statement, std::string_view signal, LogTime time);
  void forget(const Statement& statement);

  std::unordered_map<std::size_t, Item> items_;  ///< by the hash of what the statement sets
  bool is_full_ = false;
};

}  // namespace rocinante
