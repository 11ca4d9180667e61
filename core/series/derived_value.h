#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/series/series_key.h"

namespace rocinante {

/// What a derived value is made of, as docs/programs/view.md, "Derived curves", writes it:
///   `d/dt VALUE`            the change from one sample to the next, by the seconds between them
///   `mean SECONDS VALUE`    the mean over the last SECONDS
///   `VALUE - VALUE`         the difference of two stated values
/// where VALUE, but for the two of a difference, may be derived in turn, up to four times.
struct Derivation {
  enum class How { rate, mean, difference };
  How how = How::rate;
  Nanoseconds over{};           ///< of a mean: above 0, at most kMostMean
  std::vector<SeriesKey> of{};  ///< one, or the two of a difference
};

inline constexpr Nanoseconds kMostMean = std::chrono::hours(1);

/// Reads one that is derived; empty for anything else. The key has the text for its name.
std::optional<SeriesKey> parseDerivedKey(std::string_view text);

/// Why a text that begins as a derived one does (`d/dt`, `mean`) is none; one sentence. Empty when
/// it is one, and for a text that begins otherwise.
std::string derivationFault(std::string_view text);

/// Why nothing is derived of a stated value that is a text; one sentence. The key is made of it.
std::string noNumberOf(const SeriesKey& derived, const SeriesKey& text);

/// Empty for a key that is not derived.
std::optional<Derivation> derivationOf(const SeriesKey& key);

/// The stated values that a key is made of: itself, when it is not derived.
std::vector<SeriesKey> statedOf(const SeriesKey& key);

/// How far back the samples may lie that values need beside the last.
Nanoseconds reachOf(const std::set<SeriesKey>& keys);

/// Where to begin in a log, so that what is derived is known at `from`: with the state there, and
/// the messages behind it. Empty: at `start` of the log, or nothing is derived.
std::optional<LogTime> leadOf(const std::set<SeriesKey>& keys, LogTime from, LogTime start);

/// A derived value as samples come. A gap in one of its values is a gap of it, and its samples come
/// with theirs, those of a mean also between them. Bounded memory.
class DerivedValue {
 public:
  /// The key is derived.
  explicit DerivedValue(const SeriesKey& key);
  ~DerivedValue();
  DerivedValue(DerivedValue&&) noexcept;
  DerivedValue& operator=(DerivedValue&&) noexcept;

  /// In the order of take().
  const std::vector<SeriesKey>& stated() const { return stated_; }
  /// A sample of one of them, or its end. Of one moment the last counts.
  void take(std::size_t stated, std::optional<double> value);
  /// What the samples since the last call make of it at their time, which must not go back (min():
  /// it is not known): nothing for none of them, an empty one for a gap.
  std::optional<std::optional<double>> at(LogTime time);
  /// What it is between samples, where it changes: the next one before `time`, if any, of which
  /// there are few behind each sample. Ask until there is none, then at(time).
  struct Between {
    LogTime time;
    std::optional<double> value;  ///< empty: a gap
  };
  std::optional<Between> nextBefore(LogTime time);
  /// What it is at a moment between samples, where it has changed since: behind at(), and behind
  /// what nextBefore() told until then.
  std::optional<std::optional<double>> asOf(LogTime time);

 private:
  struct Node;
  std::unique_ptr<Node> root_;
  std::vector<Node*> leaves_;  ///< the stated values in it, in order
  std::vector<SeriesKey> stated_;
};

}  // namespace rocinante
