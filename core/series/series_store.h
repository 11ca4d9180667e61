#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/series/derived_value.h"
#include "core/series/series_key.h"
#include "core/series/value_bins.h"

namespace rocinante {

/// The states of a signal that is a boolean or a text.
struct StateSeries {
  StateBins bins;
  /// What the states of `bins` are, the first 256 bytes of each. All beyond the first 63, or for
  /// which there was no room, are one, the last.
  std::vector<std::string> texts;
  bool has_numbers = false;  ///< it was a number too
  bool has_others = false;   ///< the last of `texts` stands for all others
};

/// Functions of time by key, within bounds: when all together would take more than they may, all
/// halve their number of bins, down to 64; texts of states take a quarter at most. One thread.
class SeriesStore {
 public:
  struct Options {
    LogTime from{}, until{};  ///< of the first bin, and about of the last
    std::size_t max_bins = 0;
    std::uint64_t max_bytes = 0;
    std::optional<std::set<SeriesKey>> only;  ///< empty: all
  };
  using Id = std::size_t;
  static constexpr Id kUnwanted = static_cast<Id>(-1);
  /// Further ones are kUnwanted.
  static constexpr std::size_t kMaxSeries = 65536;

  explicit SeriesStore(Options options) : options_(std::move(options)) {}

  Id idOf(const SeriesKey& key);
  /// A series of its own that begins as `id` is now, for a part of what that one goes on to take;
  /// kUnwanted where there is no room.
  Id branch(Id id);
  /// One without a sample.
  Id branch();
  /// A derived value, which follows those that it is made of from now on.
  void derive(const SeriesKey& key);
  /// Derived values take what was recorded since the last call, at this time (min(): not known),
  /// and what they were until then. `exactly`: they are what they are at this time, also those
  /// that change between samples.
  void settle(LogTime time, bool exactly = false);
  /// Made when it is not there; null: it is unwanted. Valid as long as the store.
  StateSeries* statesOf(const SeriesKey& key);
  /// A state of one that statesOf() returned.
  void record(StateSeries& states, LogTime time, std::string_view text);

  void record(Id id, LogTime time, double value) {
    if (id == kUnwanted) return;
    series_[id].add(time, value);
    if (id < followers_.size()) tell(id, value);
  }
  /// Nothing for one without a value.
  void end(Id id, LogTime time) {
    if (id == kUnwanted || series_[id].bins().empty()) return;
    series_[id].end(time);
    if (id < followers_.size()) tell(id, std::nullopt);
  }

  /// What a derived value was last, in double precision; empty: nothing, or a gap.
  std::optional<double> newest(const SeriesKey& derived) const;
  /// How often samples have come of which any derived value is made.
  std::uint64_t derivedSamples() const { return derived_samples_; }

  /// Null without a value. Valid until the next series is made.
  const ValueBins* values(const SeriesKey& key) const;
  const ValueBins* values(Id id) const {
    return id == kUnwanted || series_[id].bins().empty() ? nullptr : &series_[id];
  }
  const StateSeries* states(const SeriesKey& key) const;
  /// Those with a value, sorted.
  std::vector<SeriesKey> keys() const;
  std::uint64_t bytes() const;

 private:
  struct Derived {
    Id id = kUnwanted;
    DerivedValue value;
    std::optional<double> newest{};
  };
  /// Which derived value a stated one is part of, and as which of its values.
  struct Follower {
    std::size_t derived = 0, stated = 0;
  };

  bool makeRoom();
  bool makeTextRoom(std::size_t bytes);
  void fit(std::size_t count);
  void tell(Id id, std::optional<double> value);

  Options options_;
  std::vector<ValueBins> series_;
  std::map<SeriesKey, Id> ids_;
  std::map<SeriesKey, StateSeries> states_;
  std::uint64_t text_bytes_ = 0;  ///< of their texts
  std::vector<Derived> derived_;
  std::vector<std::vector<Follower>> followers_;  ///< by the stated value
  bool has_news_ = false;                         ///< since they were settled
  std::uint64_t derived_samples_ = 0;
};

/// So that `bins` of them cover the time.
Nanoseconds binWidth(LogTime from, LogTime until, std::size_t bins);

}  // namespace rocinante
