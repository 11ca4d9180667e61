#pragma once

#include <cstdint>
#include <deque>

namespace rocinante {

/// For a source that passes on only some of another's datagrams: how many of the other's are
/// confirmed when a number of its own are. One thread.
class PassedCount {
 public:
  /// `is_needed` false: nobody will ask, and nothing is remembered.
  explicit PassedCount(bool is_needed) : is_needed_(is_needed) {}

  /// The other's next datagram was passed on, or removed.
  void note(bool passed) {
    if (passed) {
      ++passed_;
    } else if (is_needed_) {
      ++removed_;
      if (removals_.empty() || removals_.back().behind != passed_)
        removals_.push_back({passed_, 0});
      removals_.back().removed = removed_;
    }
  }
  /// The other's datagrams before the one that was passed on after `count`. Never asked for less
  /// than before.
  std::uint64_t receivedFor(std::uint64_t count) {
    for (; !removals_.empty() && removals_.front().behind <= count; removals_.pop_front()) {
      confirmed_removed_ = removals_.front().removed;
    }
    return count + confirmed_removed_;
  }

 private:
  struct Removal {
    std::uint64_t behind;   ///< passed on before
    std::uint64_t removed;  ///< in total, with these
  };

  bool is_needed_;
  std::uint64_t passed_ = 0;
  std::uint64_t removed_ = 0;
  std::uint64_t confirmed_removed_ = 0;
  std::deque<Removal> removals_;  ///< not confirmed yet
};

}  // namespace rocinante
