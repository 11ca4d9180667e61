#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/log/log_types.h"
#include "core/packet/session_state.h"
#include "core/series/series_key.h"
#include "core/series/series_store.h"
#include "core/series/signal_series.h"
#include "core/series/stated_values.h"
#include "core/series/value_bins.h"
#include "core/session/message_folder.h"

namespace rocinante {

/// How many packets of a source came, and how many numbers of its sequence did not.
struct SourceSeries {
  CountBins packets, lost;
};

/// Gathers every value that the packets of a stretch of a log state, as functions of time, in one
/// pass: joints, poses, signals (a boolean is 1 or 0 and a state, a text a state alone), packets
/// and losses by source; of links those that are asked for, from the first packet on. A joint that
/// no packet has stated has no series. Bounded: all series together take at most `max_bytes`; when
/// they would take more, all of them halve their number of bins, down to 64, and further texts of
/// signals are one state. Folds by itself, in log order: a damaged log continues with the next
/// packet. Copies and moves are not possible: it points into itself. One thread.
class SeriesScan {
 public:
  struct Options {
    LogTime from{}, until{};     ///< of the first bin, and about of the last: more may come
    PositionalNames names;       ///< may be empty
    const Cell* cell = nullptr;  ///< of links; borrowed
    std::size_t max_bins = 16384;
    std::uint64_t max_bytes = std::uint64_t{128} << 20U;
    /// Only these values; empty: all that packets state, but no link, of which there are too many.
    /// Sources are counted in any case.
    std::optional<std::set<SeriesKey>> only;
    bool states = true;  ///< false: numbers alone, so that a text has no series
  };
  /// Sources counted one by one; only a hostile session has more, which count in all().
  static constexpr std::size_t kMaxSources = 256;
  /// Values kept; further ones have no series.
  static constexpr std::size_t kMaxSeries = SeriesStore::kMaxSeries;

  explicit SeriesScan(Options options);
  ~SeriesScan();
  SeriesScan(const SeriesScan&) = delete;
  SeriesScan& operator=(const SeriesScan&) = delete;

  /// Begins with what was said until `at`, no later than `from`. Call it first, if at all.
  void beginWith(SessionState state, LogTime at);
  void beginWith(SessionState state) { beginWith(std::move(state), options_.from); }
  /// The next message in log order.
  void add(const LogMessage& message);
  /// What the recorder could not keep; counts in all(), as it ends.
  void addLoss(const LossSpan& span);

  /// What a derived value of `only` was last, in double precision; empty: nothing, or a gap.
  std::optional<double> newest(const SeriesKey& derived) const { return store_.newest(derived); }
  /// Derived values are taken on to `time`, at or after the last message: a mean also changes
  /// between samples.
  void settle(LogTime time) { store_.settle(time, true); }
  /// How often samples have come of which any derived value is made.
  std::uint64_t derivedSamples() const { return store_.derivedSamples(); }

  /// Packets stated it as texts alone.
  bool isText(const SeriesKey& key) const {
    return values(key) == nullptr && states(key) != nullptr;
  }
  /// Null when no packet stated it, or none as a number.
  const ValueBins* values(const SeriesKey& key) const { return store_.values(key); }
  /// Null when no packet stated it as a boolean or a text.
  const StateSeries* states(const SeriesKey& key) const { return store_.states(key); }
  /// The units in which packets stated a signal's numbers, in the order in which they came, each
  /// with these numbers alone; booleans have no unit and count in the only one that there is. Empty
  /// for what has no numbers, and for a value that is no signal.
  std::vector<UnitSeries> unitsOf(const SeriesKey& key) const;
  /// Every value that packets stated, sorted.
  std::vector<SeriesKey> keys() const { return store_.keys(); }
  const std::map<std::string, SourceSeries, std::less<>>& sources() const { return sources_; }
  const SourceSeries& all() const { return all_; }
  /// The time of the last message.
  LogTime reached() const { return reached_; }
  std::uint64_t bytes() const { return store_.bytes(); }

 private:
  using SeriesId = SeriesStore::Id;
  static constexpr SeriesId kUnwanted = SeriesStore::kUnwanted;
  struct Device;
  struct Links;

  void take(const Packet& packet, LogTime time);
  void takeStatement(const Statement& statement, std::string_view source, LogTime time);
  void takeJoints(const Statement& statement, std::string_view source, Device& device,
                  const DeviceState& device_state, LogTime time);
  void takeSignals(const Statement& statement, Device& device, LogTime time);
  void takeEverything(Device& device, LogTime time);
  void takeAllSignals(Device& device, const Signals& device_state, LogTime time);
  void takeLinks(LogTime time);
  void count(const Packet& packet, LogTime time);
  Device& deviceNamed(std::string_view name);
  std::array<SeriesId, 7>& poseIds(Device& device);
  SeriesId idOf(Device& device, std::string_view joint);
  SignalSeries& signalOf(Device& device, const SignalNameView& name);
  void learnNames(Device& device, const DeviceState& device_state);
  void endAll(Device& device, LogTime time);
  CountBins countBins() const;

  Options options_;
  SeriesStore store_;
  MessageFolder folder_;
  SessionState state_;
  LogTime reached_;
  std::map<std::string, std::unique_ptr<Device>, std::less<>> devices_;
  NameCache<Device*> device_cache_;
  std::unique_ptr<Links> links_;  ///< null: none are wanted
  std::map<std::string, std::set<Device*>, std::less<>> written_by_;
  std::map<std::string, SourceSeries, std::less<>> sources_;
  NameCache<SourceSeries*> source_cache_;
  std::map<std::string, std::uint64_t, std::less<>> gaps_;  ///< of the sources, as last seen
  SourceSeries all_;
  bool began_ = false;  ///< with a state, or with a first packet
};

}  // namespace rocinante
