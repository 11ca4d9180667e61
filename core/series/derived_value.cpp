#include "core/series/derived_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/packet/text_number.h"

namespace rocinante {
namespace {

/// Entries that a mean keeps; beyond them every other one goes.
constexpr std::size_t kMostEntries = 65536;
/// In which a mean follows its value behind a sample.
constexpr int kMeanSteps = 16;
/// Of one another: `d/dt d/dt VALUE` is two.
constexpr int kMostDerivations = 4;
/// Of what was stated before samples begin.
constexpr LogTime kUnknownTime = LogTime::min();
/// Samples that come this often have a rate wherever one begins to read.
constexpr Nanoseconds kSlowest = std::chrono::seconds(5);

double secondsBetween(LogTime from, LogTime until) {
  return static_cast<double>((until - from).count()) * 1e-9;
}

}  // namespace

/// A part of a derived value. What it says of a moment: nothing, a gap, or a number.
struct DerivedValue::Node {
  using Stated = std::optional<std::optional<double>>;
  /// A quantity by time, straight between entries: a mean is its change over the time that passed.
  struct Entry {
    LogTime time;
    double amount = 0;
    double held = 0;  ///< of a value that holds: from here to the next
  };

  explicit Node(const SeriesKey& key) {
    const auto derivation = derivationOf(key);
    if (!derivation) return;
    how = derivation->how;
    over = derivation->over;
    for (const SeriesKey& each : derivation->of) of.emplace_back(each);
  }
  /// In the order of statedOf().
  void addLeaves(std::vector<Node*>& leaves) {
    if (!how) leaves.push_back(this);
    for (Node& each : of) each.addLeaves(leaves);
  }

  std::optional<Derivation::How> how;  ///< empty: a stated value
  std::vector<Node> of;
  Nanoseconds over{};

  Stated pending;               ///< of a stated value
  std::optional<double> now;    ///< the newest number of it, or of what it is made of
  std::optional<Entry> before;  ///< of a rate: the sample before
  std::deque<Entry> entries;    ///< of a mean
  std::size_t gone = 0;         ///< entries that left it since amounts began at 0
  std::optional<double> other;  ///< of a difference: the newest of the second
  std::optional<LogTime> due;   ///< of a mean: when it changes next without a sample

  /// The first `due` of all parts.
  std::optional<LogTime> firstDue() const {
    std::optional<LogTime> first = due;
    for (const Node& each : of) {
      const std::optional<LogTime> its = each.firstDue();
      if (its && (!first || *its < *first)) first = its;
    }
    return first;
  }

  /// What changes without samples does so at `time`, too.
  void fallDue(LogTime time) {
    if (due && *due > time) due = time;
    for (Node& each : of) each.fallDue(time);
  }

  /// `sampled`: with what was stated; else of a moment between samples.
  Stated at(LogTime time, bool sampled) {
    if (!how) return sampled ? std::exchange(pending, std::nullopt) : std::nullopt;
    switch (*how) {
      case Derivation::How::rate:
        return rateAt(time, of[0].at(time, sampled));
      case Derivation::How::mean:
        // The mean of a rate is the change over that time: means of quotients would weigh bursts.
        if (of[0].how == Derivation::How::rate) {
          return meanAt(time, of[0].of[0].at(time, sampled), false);
        }
        return meanAt(time, of[0].at(time, sampled), true);
      case Derivation::How::difference:
        return differenceAt(of[0].at(time, sampled), of[1].at(time, sampled));
    }
    return std::nullopt;
  }

  Stated rateAt(LogTime time, const Stated& stated) {
    if (!stated) return std::nullopt;
    if (!*stated) {
      before.reset();
      return stated;
    }
    if (time == kUnknownTime) return std::nullopt;
    const Entry sample{time, **stated};
    if (before && before->time < time) {
      const double rate = (sample.amount - before->amount) / secondsBetween(before->time, time);
      before = sample;
      return std::optional(rate);
    }
    // The first one, or another of the same moment.
    before = sample;
    return std::nullopt;
  }

  /// `held`: of a value that holds from sample to sample; else of one whose rate is asked for.
  Stated meanAt(LogTime time, const Stated& stated, bool held) {
    if (!stated) return held && due && *due <= time ? betweenAt(time) : std::nullopt;
    due.reset();
    if (!*stated) {
      entries.clear();
      return stated;
    }
    if (time == kUnknownTime) return held ? stated : std::nullopt;
    const double value = **stated;
    if (entries.empty()) {
      entries.push_back({time, held ? 0 : value});
    } else if (entries.back().time < time) {
      const double passed = secondsBetween(entries.back().time, time);
      entries.push_back({time, held ? entries.back().amount + *now * passed : value});
    } else if (!held) {
      entries.back().amount = value;
    }
    entries.back().held = value;
    now = value;
    dropBefore(time - over, held);
    const Stated mean = meanUntil(entries.back());
    if (entries.size() > kMostEntries) thinOut();
    if (!mean) return held ? stated : std::nullopt;
    const bool ends = time > LogTime::max() - 2 * over;
    if (held && !ends && isApart(**mean)) due = time + stepOver();
    return mean;
  }

  /// Behind the last sample, whose value holds: what it was before leaves the mean.
  Stated betweenAt(LogTime time) {
    const Entry& last = entries.back();
    const LogTime settled = last.time + over;
    const double held = *now * secondsBetween(last.time, time);
    dropBefore(time - over, true);
    const Stated mean = meanUntil({time, last.amount + held});
    due = time < settled ? std::optional(std::min(time + stepOver(), settled)) : std::nullopt;
    return mean;
  }

  /// `end`: the last entry, or one behind it. Empty where no time has passed.
  Stated meanUntil(const Entry& end) {
    const LogTime from = end.time - over;
    const Entry& first = entries.front();
    double begin = first.amount;
    double span = secondsBetween(first.time, end.time);
    if (span <= 0) return std::nullopt;
    if (first.time < from) {
      const Entry& next = entries.size() > 1 ? entries[1] : end;
      const double part = secondsBetween(first.time, from) / secondsBetween(first.time, next.time);
      begin += (next.amount - begin) * part;
      span = secondsBetween(from, end.time);
    }
    return std::optional((end.amount - begin) / span);
  }

  void dropBefore(LogTime from, bool held) {
    constexpr double kExact = 1e9;
    bool was_large = false;
    for (; entries.size() > 1 && entries[1].time <= from; entries.pop_front(), ++gone) {
      const double part = std::abs(entries[1].amount - entries[0].amount);
      was_large =
          was_large || !(part <= kExact * std::abs(entries.back().amount - entries[1].amount));
    }
    // Beside a large amount small ones are lost: what stays is summed anew, and now and then
    // anyway.
    if (!held || !(was_large || gone > entries.size())) return;
    gone = 0;
    entries.front().amount = 0;
    for (std::size_t i = 1; i < entries.size(); ++i) {
      const Entry& last = entries[i - 1];
      entries[i].amount = last.amount + last.held * secondsBetween(last.time, entries[i].time);
    }
  }

  Nanoseconds stepOver() const { return std::max(Nanoseconds(1), over / kMeanSteps); }
  /// By more than sums are rounded.
  bool isApart(double mean) const { return std::abs(mean - *now) > 1e-9 * std::abs(*now); }

  void thinOut() {
    std::deque<Entry> kept;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i % 2 == 0 || i + 1 == entries.size()) kept.push_back(entries[i]);
    }
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      const double seconds = secondsBetween(kept[i].time, kept[i + 1].time);
      kept[i].held = (kept[i + 1].amount - kept[i].amount) / seconds;
    }
    entries = std::move(kept);
  }

  Stated differenceAt(const Stated& first, const Stated& second) {
    if (!first && !second) return std::nullopt;
    if (first) now = *first;
    if (second) other = *second;
    if (!now || !other) return std::optional<double>();
    return std::optional(*now - *other);
  }
};

namespace {

std::optional<std::string_view> after(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  return text.substr(word.size());
}

/// "0.5" of "0.5 VALUE"; leaves VALUE in the text.
std::optional<Nanoseconds> takeSeconds(std::string_view& text) {
  const std::size_t blank = std::min(text.find(' '), text.size());
  double seconds = 0;
  const char* at = text.data();
  const char* const end = at + blank;
  if (blank == text.size() || !readNumber(at, end, seconds) || at != end) return std::nullopt;
  if (!(seconds >= 1e-9 && seconds * 1e9 <= static_cast<double>(kMostMean.count()))) {
    return std::nullopt;
  }
  text.remove_prefix(blank + 1);
  return Nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

std::optional<Derivation> read(std::string_view text, int depth);

/// What a rate or a mean is of.
std::optional<SeriesKey> readOperand(std::string_view text, int depth) {
  if (depth < kMostDerivations && read(text, depth)) {
    return SeriesKey{SeriesKey::Kind::derived, std::string(text)};
  }
  // One too many is no name of a device.
  if (after(text, "d/dt ") || after(text, "mean ")) return std::nullopt;
  auto stated = parseStatedKey(text);
  return stated && stated->isValue() ? stated : std::nullopt;
}

std::optional<Derivation> read(std::string_view text, int depth) {
  Derivation made;
  if (const auto rest = after(text, "d/dt ")) {
    auto of = readOperand(*rest, depth + 1);
    if (of) made.of.push_back(*std::move(of));
    return of ? std::optional(std::move(made)) : std::nullopt;
  }
  if (auto rest = after(text, "mean ")) {
    const auto over = takeSeconds(*rest);
    auto of = over ? readOperand(*rest, depth + 1) : std::nullopt;
    if (!of) return std::nullopt;
    made.how = Derivation::How::mean;
    made.over = *over;
    made.of.push_back(*std::move(of));
    return made;
  }
  constexpr std::string_view kMinus = " - ";
  for (std::size_t at = text.find(kMinus); at != text.npos; at = text.find(kMinus, at + 1)) {
    auto first = parseStatedKey(text.substr(0, at));
    auto second = parseStatedKey(text.substr(at + kMinus.size()));
    if (!first || !second || !first->isValue() || !second->isValue()) continue;
    made.how = Derivation::How::difference;
    made.of.push_back(*std::move(first));
    made.of.push_back(*std::move(second));
    return made;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SeriesKey> parseDerivedKey(std::string_view text) {
  if (!read(text, 0)) return std::nullopt;
  return SeriesKey{SeriesKey::Kind::derived, std::string(text)};
}

namespace {

std::string_view firstWord(std::string_view text) { return text.substr(0, text.find(' ')); }

std::string faultOf(std::string_view text, int depth) {
  const std::string_view word = firstWord(text);
  if (word != "d/dt" && word != "mean") return {};
  if (depth == kMostDerivations) {
    return fmt::format("a value is derived at most {} times", kMostDerivations);
  }
  if (read(text, depth)) return {};
  const bool is_mean = word == "mean";
  auto of = after(text, is_mean ? "mean " : "d/dt ");
  if (!of || of->empty()) return is_mean ? "`mean` needs SECONDS VALUE" : "`d/dt` needs a VALUE";
  if (is_mean) {
    const std::string_view number = firstWord(*of);
    if (number.size() == of->size()) return "`mean` needs SECONDS VALUE";
    if (!takeSeconds(*of)) {
      return fmt::format("SECONDS is a number from 1e-9 to {}, not `{}`: mean SECONDS VALUE",
                         std::chrono::duration_cast<std::chrono::seconds>(kMostMean).count(),
                         number);
    }
  }
  if (std::string deeper = faultOf(*of, depth + 1); !deeper.empty()) return deeper;
  return fmt::format(
      "`{}` has no {}: use DEVICE.JOINT, DEVICE:x, DEVICE/LINK:x, signal PATH NAME or what is "
      "derived of them",
      *of, is_mean ? "mean" : "derivative");
}

}  // namespace

std::string derivationFault(std::string_view text) { return faultOf(text, 0); }

std::string noNumberOf(const SeriesKey& derived, const SeriesKey& text) {
  const auto derivation = derivationOf(derived);
  if (!derivation) return {};
  for (const SeriesKey& of : derivation->of) {
    if (of != text && std::ranges::count(statedOf(of), text) > 0) return noNumberOf(of, text);
  }
  const char* const lacks = derivation->how == Derivation::How::rate   ? "derivative"
                            : derivation->how == Derivation::How::mean ? "mean"
                                                                       : "difference";
  return fmt::format("`{}` is a text, and a text has no {}", text.text(), lacks);
}

std::optional<Derivation> derivationOf(const SeriesKey& key) {
  if (key.kind != SeriesKey::Kind::derived) return std::nullopt;
  return read(key.name, 0);
}

std::vector<SeriesKey> statedOf(const SeriesKey& key) {
  const auto derivation = derivationOf(key);
  if (!derivation) return {key};
  std::vector<SeriesKey> stated;
  for (const SeriesKey& of : derivation->of) {
    for (SeriesKey& each : statedOf(of)) stated.push_back(std::move(each));
  }
  return stated;
}

Nanoseconds reachOf(const std::set<SeriesKey>& keys) {
  Nanoseconds most{};
  for (const SeriesKey& key : keys) {
    const auto derivation = derivationOf(key);
    if (!derivation) continue;
    const Nanoseconds of = reachOf({derivation->of.begin(), derivation->of.end()});
    most = std::max(most, kSlowest + 2 * derivation->over + of);
  }
  return most;
}

std::optional<LogTime> leadOf(const std::set<SeriesKey>& keys, LogTime from, LogTime start) {
  const Nanoseconds reach = reachOf(keys);
  if (reach.count() == 0 || from <= start || from - start <= reach) return std::nullopt;
  return from - reach;
}

DerivedValue::DerivedValue(const SeriesKey& key)
    : root_(std::make_unique<Node>(key)), stated_(statedOf(key)) {
  root_->addLeaves(leaves_);
}

DerivedValue::~DerivedValue() = default;
DerivedValue::DerivedValue(DerivedValue&&) noexcept = default;
DerivedValue& DerivedValue::operator=(DerivedValue&&) noexcept = default;

void DerivedValue::take(std::size_t stated, std::optional<double> value) {
  leaves_[stated]->pending = value;
}

std::optional<std::optional<double>> DerivedValue::at(LogTime time) {
  return root_->at(time, true);
}

std::optional<std::optional<double>> DerivedValue::asOf(LogTime time) {
  root_->fallDue(time);
  return root_->at(time, false);
}

std::optional<DerivedValue::Between> DerivedValue::nextBefore(LogTime time) {
  for (auto due = root_->firstDue(); due && *due < time; due = root_->firstDue()) {
    if (const auto stated = root_->at(*due, false)) return Between{*due, *stated};
  }
  return std::nullopt;
}

}  // namespace rocinante
