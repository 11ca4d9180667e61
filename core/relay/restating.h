#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/packet/packet.h"
#include "core/relay/device_values.h"

namespace rocinante {

/// Restatements and greetings are sent with at most 64 datagrams in 10 ms (docs/subscriptions.md).
class RestatingPace {
 public:
  static constexpr std::size_t kDatagrams = 64;
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(10);
  /// What takes longer has no part=.
  static constexpr Nanoseconds kLongest = std::chrono::milliseconds(500);
  static constexpr std::size_t kMaxWithParts =
      kDatagrams * static_cast<std::size_t>(kLongest / kPeriod);

  bool allows(LogTime now) {
    if (now - began_ >= kPeriod) {
      began_ = now;
      sent_ = 0;
    }
    return sent_ < kDatagrams;
  }
  void sent(std::size_t datagrams) { sent_ += datagrams; }
  LogTime allowsAt() const { return sent_ < kDatagrams ? began_ : began_ + kPeriod; }

 private:
  LogTime began_{};
  std::size_t sent_ = 0;
};

/// Statements of one SOURCE that go into one datagram: everything but its header.
struct RelayDraft {
  std::string source;
  std::string text;  ///< statement lines, each with its LF
  /// part=ID:index/count of a restatement; `id` is the Restating's.
  std::optional<RestatementPart> part;
  /// It has events, which listeners take from the source's own datagrams only.
  bool has_events = false;
};

/// One restatement of all sources of a state, written part by part while the state moves on
/// (docs/packet-format.md, "Restatements"): what is in which part is fixed at the start, the values
/// are those of the moment when the part is taken.
class Restating {
 public:
  struct Options {
    std::vector<RelayFilter> filters;
    ItemStyle style;
    std::string id;  ///< of the restatement; a name
    std::size_t text_bytes =
        0;  ///< statements of one datagram, unless what goes together is larger
    bool with_parts = true;
  };
  Restating(const SessionState& state, Options options);

  bool ended() const { return next_ == parts_.size(); }
  /// The datagrams to come, if no text grows.
  std::size_t left() const { return parts_.size() - next_; }
  void leaveOutParts() { options_.with_parts = false; }
  const std::string& id() const { return options_.id; }

  /// The next part: one datagram, or several when its text has grown beyond text_bytes. Adds the
  /// restated items to `restated`, if it is not null, and their orders to `sent_orders`. Must not
  /// have ended.
  std::vector<RelayDraft> next(const SessionState& state, std::vector<ItemKey>* restated,
                               SentOrders& sent_orders);

 private:
  struct Part {
    std::string source;
    std::vector<ItemKey> items;
    std::uint32_t index = 1, count = 1;
    bool removals = false;
  };

  Options options_;
  std::vector<Part> parts_;
  std::size_t next_ = 0;
};

}  // namespace rocinante
