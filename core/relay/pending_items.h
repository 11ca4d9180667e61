#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/min_change.h"
#include "core/base/time.h"
#include "core/packet/session_state.h"
#include "core/relay/item_key.h"

namespace rocinante {

/// The items that a filtered output has yet to send: names alone, since the values are the fold's
/// when they are sent. Joints and pose of one device are due together. Never larger than the state
/// whose items are written. One thread; reads no clock.
class PendingItems {
 public:
  /// A device whose changes stay below MinChange is sent when it has rested for this long.
  static constexpr Nanoseconds kRest = std::chrono::milliseconds(250);

  struct Options {
    std::optional<Nanoseconds> interval;  ///< between two sends of a device
    MinChange min_change;
  };
  explicit PendingItems(const Options& options) : options_(options) {}

  /// The item was written and is in the state.
  void written(const SessionState& state, ItemKey&& key, LogTime now);
  /// The item was said otherwise, by a restatement: MinChange counts from there.
  void markStated(const SessionState& state, const ItemKey& key);
  /// Forgets what the state has no more, since a source's restatement did not repeat it: listeners
  /// lose it with the next restatement of this output, so that it is no small change when it comes
  /// back.
  void sweep(const SessionState& state);
  /// The item is not in the state any more, or is a signal's state, which waits for nothing.
  void cancelled(const ItemKey& key);
  /// The device was removed: nothing of it is to be sent.
  void removed(std::string_view device);

  /// Moves what has become due by `now` behind what is ready.
  void advance(LogTime now);
  bool anyReady() const { return !ready_.empty(); }
  /// The items of the front, as sent at `now`; empty when they have been said since.
  std::vector<ItemKey> takeReady(const SessionState& state, LogTime now);
  /// When something becomes due; LogTime::max(): never.
  LogTime due() const { return waiting_.empty() ? LogTime::max() : waiting_.begin()->first; }

  std::size_t size() const { return units_.size(); }
  /// Values that a newer one of the same item replaced before they were sent.
  std::uint64_t conflated() const { return conflated_; }
  /// Numbers of signals that MinChange kept back.
  std::uint64_t held() const { return held_; }

 private:
  /// What was sent last of a signal that is a number.
  struct SentNumber {
    double value = 0;
    double least = 0;  ///< that a change must be
    std::string unit;
    std::string owner;
  };
  /// The values of a device, or another item alone.
  struct Unit {
    enum class Place { nowhere, ready, waiting } place = Place::nowhere;
    std::set<ItemKey> items;
    bool matters = false;  ///< one of the items changed by more than MinChange
    LogTime due{};
    std::optional<LogTime> sent;
    // What was sent last; kept for MinChange alone.
    std::vector<double> positions;
    std::map<std::string, double> joints;
    std::optional<PoseValue> pose;
    std::optional<SentNumber> number;
  };
  using Units = std::map<ItemKey, Unit>;
  struct ByTime {
    using is_transparent = void;
    using Entry = std::pair<LogTime, Units::iterator>;
    bool operator()(const Entry& a, const Entry& b) const {
      return a.first != b.first ? a.first < b.first : &*a.second < &*b.second;
    }
  };

  static ItemKey unitOf(const ItemKey& key);
  /// True for what goes out as often as the limits allow: values of a device, numbers of signals.
  static bool isPaced(const ItemKey& key);
  bool isLargeChange(const SessionState& state, const ItemKey& key, const Unit& unit) const;
  bool isHeld(const SessionState& state, const ItemKey& key, const Unit& unit) const;
  void remember(const SessionState& state, const ItemKey& key, Unit& unit) const;

  Options options_;
  std::uint64_t conflated_ = 0;
  std::uint64_t held_ = 0;
  std::size_t sweeps_at_ = 1024;  ///< units
  Units units_;
  std::deque<Units::iterator> ready_;
  std::set<ByTime::Entry, ByTime> waiting_;
};

}  // namespace rocinante
