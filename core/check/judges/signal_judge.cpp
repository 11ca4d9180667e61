#include "core/check/judges/signal_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <utility>

#include "core/base/pattern.h"
#include "core/base/plain_text.h"
#include "core/packet/item_text.h"
#include "core/packet/packet_limits.h"

namespace rocinante {
namespace {

/// A rate is measured over windows at least this long, with at least this many statements.
constexpr double kWindow_s = 2;
constexpr double kWindowValues = 20;
/// The error that a window's edges can cause in its rate.
constexpr double kRateSlack = 0.05;
/// A device that does not change for this long rests.
constexpr Nanoseconds kRest = std::chrono::milliseconds(250);
/// Wrong values and changes of one signal that are listed.
constexpr std::size_t kMaxWrong = 16;

std::string nameOf(const std::string& device, const std::string& link, const std::string& name) {
  return signalNameText(device, {link, name});
}

std::string withUnit(double number, const std::string& unit) {
  return fmt::format("{:.6g}{}{}", number, unit.empty() ? "" : " ", unit);
}

std::string rangeText(const std::pair<double, double>& range, const std::string& unit) {
  return fmt::format("{:.6g} to {}", range.first, withUnit(range.second, unit));
}

bool isOfNumbers(const CellSignal& expected) {
  return expected.range || expected.jump || expected.stuck_s || !expected.unit.empty();
}

std::string quoted(const std::string& value) { return "`" + plainText(value) + "`"; }

std::size_t hashOf(std::span<const double> numbers) {
  std::size_t hash = numbers.size();
  for (const double number : numbers) {
    hash = hash * 0x9E3779B97F4A7C15U + std::hash<double>{}(number);
  }
  return hash;
}

std::size_t hashOf(std::string_view text) { return std::hash<std::string_view>{}(text); }

}  // namespace

void SignalJudge::Worst::hit(const PacketPlace& place, double how_bad, double of_value) {
  if (tally.hit(place) || how_bad > figure) {
    figure = how_bad;
    value = of_value;
  }
}

bool SignalJudge::Signal::isClean() const {
  // Of its numbers, that they were in the cell's unit.
  if (was_in_unit && expected != nullptr && !expected->unit.empty()) return false;
  return kinds.count + units.count + not_numbers.count + two_writers.tally.count == 0 &&
         range.tally.count + jump.tally.count + rate.tally.count + stuck.tally.count == 0 &&
         values.empty() && transitions.empty();
}

void SignalJudge::Signal::drop() {
  kinds = units = not_numbers = {};
  two_writers = {};
  range = jump = rate = stuck = {};
  is_stuck = was_in_unit = false;
  values.clear();
  transitions.clear();
}

const CellSignal* SignalJudge::expectedOf(const PathView& path, std::string_view name) {
  const auto expected = std::ranges::find_if(cell_.signals, [&](const CellSignal& each) {
    return each.device == path.first && each.link == path.second && patternMatches(each.name, name);
  });
  if (expected == cell_.signals.end()) return nullptr;
  came_.insert(&*expected);
  return &*expected;
}

SignalJudge::Signal* SignalJudge::signalNamed(const PathView& path, std::string_view name) {
  const auto found = signals_.find(KeyView(path.first, path.second, name));
  if (found != signals_.end()) return &found->second;
  Signal signal;
  signal.expected = expectedOf(path, name);
  if (signals_.size() >= limits::kSignals) return nullptr;
  if (signal.expected != nullptr && signal.expected->stuck_s) {
    motions_.try_emplace(std::string(path.first));
  }
  Key key{std::string(path.first), std::string(path.second), std::string(name)};
  return &signals_.emplace(std::move(key), std::move(signal)).first->second;
}

void SignalJudge::take(const Statement& statement, const PacketPlace& place) {
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    Signal* const signal = signalNamed(statement.path, statement.names[i]);
    if (signal == nullptr) {
      too_many_.hit(place);
      continue;
    }
    if (statement.is_default) {
      signal->has_value = signal->is_counted = signal->is_other_unit = false;
      signal->writer = TwoSources::kNobody;
      if (signal->isClean()) {
        signals_.erase(signals_.find(
            KeyView(statement.path.first, statement.path.second, statement.names[i])));
      }
    } else {
      judge(*signal, statement, i, place);
    }
  }
}

void SignalJudge::judge(Signal& signal, const Statement& statement, std::size_t index,
                        const PacketPlace& place) const {
  const SignalKind kind = statement.signal_kinds[index];
  const double number = statement.numbers[index];
  // A source that began anew may go on anywhere; so may another source.
  const bool follows = signal.has_value && signal.kind == kind && signal.source == place.source &&
                       signal.stretch == place.stretch;
  if (signal.has_value && signal.kind != kind && signal.kinds.hit(place)) {
    signal.first_kind = rocinante::nameOf(signal.kind);
    signal.other_kind = rocinante::nameOf(kind);
  }
  signal.two_writers.note(signal.writer, place);
  if (kind == SignalKind::number) {
    const std::string& known = signal.expected != nullptr && !signal.expected->unit.empty()
                                   ? signal.expected->unit
                                   : signal.unit;
    const bool is_other = !statement.unit.empty() && !known.empty() && statement.unit != known;
    if (is_other && signal.units.hit(place)) {
      signal.first_unit = known;
      signal.other_unit = statement.unit;
    }
    // `signals` goes on in the unit that was stated last.
    if (statement.kind == StatementKind::signal) signal.is_other_unit = is_other;
    if (!statement.unit.empty() && signal.unit != statement.unit) signal.unit = statement.unit;
    signal.was_in_unit = signal.was_in_unit || !signal.is_other_unit;
    judgeNumber(signal, number, follows && !is_other, place);
    if (!follows || signal.number != number) {
      signal.changed = place.time;
      signal.is_stuck = false;
    }
    signal.number = number;
  } else {
    signal.is_other_unit = false;
    const std::string_view text = kind == SignalKind::text ? statement.text
                                  : number != 0            ? std::string_view("true")
                                                           : std::string_view("false");
    judgeState(signal, text, follows, place);
    if (signal.text != text) signal.text = text;
    if (signal.expected != nullptr && isOfNumbers(*signal.expected) &&
        std::ranges::find(signal.expected->values, text) == signal.expected->values.end() &&
        signal.not_numbers.hit(place)) {
      signal.not_number = text;
    }
  }
  if (signal.expected != nullptr && signal.expected->rate_hz && !place.is_restated) {
    judgeRate(signal, place);
  }
  signal.has_value = true;
  signal.kind = kind;
  signal.source = place.source;
  signal.stretch = place.stretch;
}

void SignalJudge::judgeNumber(Signal& signal, double number, bool follows,
                              const PacketPlace& place) const {
  if (signal.expected == nullptr) return;
  const CellSignal& expected = *signal.expected;
  // With a range, `values` are what may stand in place of a number.
  if (!expected.range && (!expected.values.empty() || !expected.transitions.empty())) {
    fmt::memory_buffer text;
    fmt::format_to(std::back_inserter(text), "{}", number);
    const std::string_view written(text.data(), text.size());
    judgeState(signal, written, follows, place);
    if (signal.text != written) signal.text = written;
  }
  if (signal.is_other_unit && !expected.unit.empty()) return;
  if (expected.range) {
    const double beyond = std::max(expected.range->first - number, number - expected.range->second);
    if (beyond > 0) signal.range.hit(place, beyond, number);
  }
  if (expected.jump && follows) {
    const double change = std::abs(number - signal.number);
    if (change > *expected.jump) signal.jump.hit(place, change, change);
  }
}

void SignalJudge::judgeState(Signal& signal, std::string_view text, bool follows,
                             const PacketPlace& place) const {
  if (signal.expected == nullptr) return;
  const CellSignal& expected = *signal.expected;
  const auto hit = [&](Wrong& wrong, std::string_view from, std::string_view to) {
    const std::pair<std::string, std::string> key(from, to);
    if (wrong.contains(key) || wrong.size() < kMaxWrong) wrong[key].hit(place);
  };
  const bool is_listed = std::ranges::find(expected.values, text) != expected.values.end();
  if (!expected.values.empty() && !is_listed) hit(signal.values, {}, text);
  if (!follows || expected.transitions.empty() || signal.text == text) return;
  const bool is_allowed = std::ranges::any_of(expected.transitions, [&](const auto& each) {
    return each.first == signal.text && each.second == text;
  });
  if (!is_allowed) hit(signal.transitions, signal.text, text);
}

void SignalJudge::judgeRate(Signal& signal, const PacketPlace& place) const {
  const auto [low, high] = *signal.expected->rate_hz;
  const bool goes_on =
      signal.is_counted && signal.source == place.source && signal.stretch == place.stretch;
  signal.is_counted = true;
  if (!goes_on) {
    signal.window_began = place.time;
    signal.window_count = 0;
    return;
  }
  ++signal.window_count;
  const double window_s = secondsOf(place.time - signal.window_began);
  if (window_s < kWindow_s || static_cast<double>(signal.window_count) < kWindowValues) return;
  const double rate_hz = static_cast<double>(signal.window_count) / window_s;
  const double off = std::max(low * (1 - kRateSlack) - rate_hz, rate_hz - high * (1 + kRateSlack));
  if (off > 0) signal.rate.hit(place, off, rate_hz);
  signal.window_began = place.time;
  signal.window_count = 0;
}

bool SignalJudge::Motion::changes(std::size_t what, std::size_t value) {
  const auto [known, is_new] = values.try_emplace(what, value);
  return is_new || std::exchange(known->second, value) != value;
}

void SignalJudge::takeMotion(const Statement& statement, const PacketPlace& place) {
  if (motions_.empty() || !isDeviceValue(statement.kind)) return;
  const auto found = motions_.find(statement.name);
  if (found == motions_.end()) return;
  Motion& motion = found->second;
  bool moves = false;
  if (statement.kind == StatementKind::joint) {
    for (std::size_t i = 0; i < statement.names.size(); ++i) {
      moves = motion.changes(hashOf(statement.names[i]), hashOf(statement.numbers.subspan(i, 1))) ||
              moves;
    }
  } else {
    const std::size_t carrier =
        hashOf(statement.carrier.first) ^ (hashOf(statement.carrier.second) << 1U);
    moves = motion.changes(static_cast<std::size_t>(statement.kind),
                           hashOf(statement.numbers) ^ carrier);
  }
  if (!moves) return;
  if (place.time - motion.last > kRest) motion.began = place.time;
  motion.last = place.time;
  auto at = signals_.lower_bound(KeyView(found->first, {}, {}));
  for (; at != signals_.end() && at->first.device == found->first; ++at) {
    Signal& signal = at->second;
    const bool may_be_stuck = signal.expected != nullptr && signal.expected->stuck_s &&
                              signal.has_value && signal.kind == SignalKind::number;
    if (!may_be_stuck) continue;
    const double still_s = secondsOf(place.time - std::max(signal.changed, motion.began));
    if (still_s <= *signal.expected->stuck_s) continue;
    if (!std::exchange(signal.is_stuck, true)) {
      signal.stuck.hit(place, still_s, still_s);
    } else {
      signal.stuck.figure = signal.stuck.value = std::max(signal.stuck.value, still_s);
    }
  }
}

void SignalJudge::forget(std::string_view device) {
  auto at = signals_.lower_bound(KeyView(device, {}, {}));
  while (at != signals_.end() && at->first.device == device) {
    at->second.has_value = at->second.is_counted = at->second.is_other_unit = false;
    at->second.writer = TwoSources::kNobody;
    at = at->second.isClean() ? signals_.erase(at) : std::next(at);
  }
}

void SignalJudge::reportOne(const Key& key, const Signal& signal,
                            const std::vector<std::string>& sources, Findings& findings) const {
  const std::string name = nameOf(key.device, key.link, key.name);
  const std::string title = signal.expected != nullptr && !signal.expected->label.empty()
                                ? name + " (" + signal.expected->label + ")"
                                : name;
  const auto add = [&](const Tally& tally, const char* rule, std::string text) {
    if (tally.count > 0) findings.push_back(tally.finding(rule, name, std::move(text)));
  };
  const auto addWorst = [&](const Worst& worst, const char* rule, auto text) {
    if (worst.tally.count == 0) return;
    add(worst.tally, rule, text());
    findings.back().worst = statedValue(worst.figure);
  };
  add(signal.kinds, "signal.kind",
      fmt::format("{} is first a {} and then a {}", title, signal.first_kind, signal.other_kind));
  const bool is_unjudged = signal.expected != nullptr && !signal.expected->unit.empty() &&
                           (signal.expected->range || signal.expected->jump);
  const bool is_never_in_unit =
      signal.expected != nullptr && !signal.expected->unit.empty() && !signal.was_in_unit;
  add(signal.units, "signal.unit",
      is_never_in_unit
          ? fmt::format("{} is stated in {}, never in {}, which the cell expects{}", title,
                        signal.other_unit, signal.first_unit,
                        is_unjudged ? "; none of its numbers is judged" : "")
          : fmt::format("{} is in {}, and in {}{}", title, signal.first_unit, signal.other_unit,
                        is_unjudged ? "; the numbers in another unit are not judged" : ""));
  signal.two_writers.report(name, title + " is", sources, findings);
  if (signal.expected == nullptr) return;
  const CellSignal& expected = *signal.expected;
  add(signal.not_numbers, "signal.kind",
      fmt::format("{} is {}, where the cell expects a number; range, jump and stuck_s do not judge "
                  "it",
                  title, quoted(signal.not_number)));
  const std::string& unit = expected.unit.empty() ? signal.unit : expected.unit;
  addWorst(signal.range, "signal.range", [&] {
    return fmt::format("{} is {}, where the cell expects {}", title,
                       withUnit(signal.range.value, unit), rangeText(*expected.range, unit));
  });
  addWorst(signal.jump, "signal.jump", [&] {
    return fmt::format("{} changes by {} from one value to the next; {} are expected at most",
                       title, withUnit(signal.jump.value, unit), withUnit(*expected.jump, unit));
  });
  addWorst(signal.stuck, "signal.stuck", [&] {
    return fmt::format(
        "{} repeats one value for {:.3g} s while {} moves; {:.3g} s are expected at "
        "most",
        title, signal.stuck.value, plainText(key.device), *expected.stuck_s);
  });
  addWorst(signal.rate, "signal.rate", [&] {
    return fmt::format("{} is stated {:.3g} times a second, where the cell expects {}", title,
                       signal.rate.value, rangeText(*expected.rate_hz, ""));
  });
  for (const auto& [value, tally] : signal.values) {
    add(tally, "signal.unknown-value",
        fmt::format("{} is {}, which the cell does not expect", title, quoted(value.second)));
  }
  for (const auto& [change, tally] : signal.transitions) {
    add(tally, "signal.transition",
        fmt::format("{} goes from {} to {}, which the cell does not expect", title,
                    quoted(change.first), quoted(change.second)));
  }
}

std::string SignalJudge::missingText(const CellSignal& expected, const std::string& name) const {
  const bool is_taken = std::ranges::any_of(signals_, [&](const auto& each) {
    return each.first.device == expected.device && each.first.link == expected.link &&
           patternMatches(expected.name, each.first.name);
  });
  return is_taken ? fmt::format(
                        "an earlier [[signal]] of the cell fits every {}: this one judges nothing",
                        plainText(name))
                  : fmt::format("the cell expects {}, which no packet states", plainText(name));
}

void SignalJudge::report(const std::vector<std::string>& sources, Findings& findings) const {
  if (too_many_.count > 0) {
    findings.push_back(too_many_.finding(
        "packet.too-many", "signals",
        fmt::format("the state holds {} signals, and further ones are stated: they are in no state "
                    "and are not judged",
                    limits::kSignals)));
  }
  for (const auto& [key, signal] : signals_) reportOne(key, signal, sources, findings);
  for (const CellSignal& expected : cell_.signals) {
    if (expected.optional) continue;
    if (came_.contains(&expected)) continue;
    // The name is a pattern, as the cell has it.
    std::string name = nameOf(expected.device, expected.link, "x");
    name.pop_back();
    name += expected.name;
    findings.push_back(makeFinding("signal.missing", name, missingText(expected, name)));
  }
}

void SignalJudge::dropFindings() {
  std::erase_if(signals_, [](const auto& each) { return !each.second.has_value; });
  // What came still holds while it has a value.
  came_.clear();
  for (auto& [key, signal] : signals_) {
    signal.drop();
    if (signal.expected != nullptr) came_.insert(signal.expected);
  }
  too_many_ = {};
}

}  // namespace rocinante
