#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/relay/device_values.h"
#include "core/relay/output_header.h"
#include "core/relay/paced_statements.h"
#include "core/relay/pending_items.h"
#include "core/relay/restating.h"

namespace rocinante {

/// What an output passes, and how often.
struct RelayOutputOptions {
  std::vector<RelayFilter> filters;  ///< all must pass an item
  PendingItems::Options pacing;
  std::optional<double> bytes_per_second;  ///< with the heads of IP and UDP, and `link_bytes`
  std::size_t head_bytes = 28;  ///< of each datagram: 28 over IPv4, 48 over IPv6, and a signature
  std::size_t link_bytes = 0;   ///< that the link adds to each datagram
  std::size_t signature_bytes = 0;  ///< kept free in each datagram for who signs it

  /// Whole: source datagrams are sent byte for byte.
  bool isWhole() const;
};

/// Lines of applied packets that a filtered output has no words for.
struct FilteredOutCounts {
  std::uint64_t stopped = 0;     ///< statements that a filter does not pass
  std::uint64_t signals = 0;     ///< values of signals that a filter of signals does not pass
  std::uint64_t held = 0;        ///< numbers of signals that changed too little
  std::uint64_t unreadable = 0;  ///< lines with a fault; a whole output sends these on

  FilteredOutCounts& operator+=(const FilteredOutCounts& others);
};

/// A filtered output of a relay (docs/decisions/014): writes the items that the fold applied and
/// that pass, as often as the limits allow. Holds names of items, never values. One thread; reads
/// no clock.
class FilteredOutput {
 public:
  static constexpr std::size_t kDatagramBytes = 1200;
  /// With bytes_per_second. A device's values are in one datagram, also where it is longer.
  static constexpr std::size_t kSlowDatagramBytes = 180;

  FilteredOutput(OutputHeader header, RelayOutputOptions options, LogTime now);

  /// A packet that the fold has just applied. Appends the datagrams to send now to `out`.
  void applied(const SessionState& state, const ThroughBySource& through, const Packet& packet,
               LogTime now, std::vector<std::string>& out);
  /// What has become due.
  void advance(const SessionState& state, const ThroughBySource& through, LogTime now,
               std::vector<std::string>& out);
  /// When advance() has something to do; LogTime::max(): never.
  LogTime due() const;

  /// Begins a restatement of what passes; one that has not ended is abandoned.
  void restate(const SessionState& state, const ThroughBySource& through, std::string id);
  bool isRestating() const { return restating_.has_value(); }

  /// Values that a newer one of the same item replaced before they were sent.
  std::uint64_t conflated() const { return pending_.conflated(); }
  FilteredOutCounts filteredOut() const;
  /// Statements that wait for the link, since they are never conflated; none without
  /// bytes_per_second.
  PacedCounts paced() const { return paced_.counts(); }

 private:
  /// An `erase` that is said again, since no restatement of this output would forget the drawing.
  struct RepeatedErase {
    LogTime due;
    int left;
    std::string source;
    std::string id;  ///< empty: all of the source's drawings
  };
  /// What is being sent to: one call of applied() or advance().
  struct Step {
    const SessionState& state;
    const ThroughBySource& through;
    LogTime now;
    std::vector<std::string>& out;
  };

  static bool isImmediate(StatementKind kind);
  void countStopped(const Step& step, std::string_view source, const Statement& statement);
  bool isStopped(const Step& step, std::string_view source, const Statement& statement) const;
  bool passesSignal(const PathView& path, std::string_view name) const;
  bool passesImmediate(std::string_view source, const Statement& statement) const;
  void takeImmediate(const Step& step, const Packet& packet, const Statement& statement,
                     RelayDraft& draft);
  /// Of signals what is no number: each state arrives, however short.
  void takeStates(const Step& step, const Packet& packet, const Statement& signals,
                  RelayDraft& draft);
  void send(const Step& step, RelayDraft& draft, bool restating);
  void sendReady(const Step& step, RelayDraft& draft);
  void sendUnit(const Step& step, RelayDraft& draft);
  void forgetOrders(std::string_view device);
  bool statesOrder(const SessionState& state, const SentOrders::key_type& device_and_source) const;
  void sendPaced(const Step& step);
  void sendRestating(const Step& step);
  void repeatErases(const Step& step);
  static bool isDrawn(const SessionState& state, const RepeatedErase& erase);
  std::size_t datagramBytes() const {
    return bucket_ ? kSlowDatagramBytes : kDatagramBytes - options_.signature_bytes;
  }
  std::size_t roomFor(const Step& step, std::string_view source) const;

  OutputHeader header_;
  RelayOutputOptions options_;
  ItemStyle style_;
  PendingItems pending_;
  FilteredOutCounts filtered_out_;
  PacedStatements paced_;      ///< with a bucket only
  bool values_first_ = false;  ///< events and values take turns
  std::optional<TokenBucket> bucket_;
  std::optional<Restating> restating_;
  RestatingPace pace_;
  bool forgets_nothing_ = false;  ///< its restatements are too long to have part=
  int live_datagrams_ = 0;        ///< since the last one of a restatement
  std::vector<RepeatedErase> erases_;
  SentOrders sent_orders_;
};

}  // namespace rocinante
