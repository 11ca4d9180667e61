#include "core/check/judges/signal_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/pattern.h"
#include "core/base/plain_text.h"
#include "core/packet/item_text.h"

namespace rocinante {
namespace {

/// A rate is measured over windows at least this long, with at least this many statements.
constexpr double kWindow_s = 2;
constexpr double kWindowValues = 20;
/// The error that a window's edges can cause in its rate.
constexpr double kRateSlack = 0.05;
/// A device that does not change for this long rests.
constexpr Nanoseconds kRest = std::chrono::milliseconds(250);
/// Wrong values and changes of one signal that are told apart.
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

std::string quoted(const std::string& value) { return "`" + plainText(value) + "`"; }

std::size_t hashOf(const Statement& statement) {
  std::size_t hash = static_cast<std::size_t>(statement.kind);
  for (const double number : statement.numbers) {
    hash = hash * 0x9E3779B97F4A7C15U + std::hash<double>{}(number);
  }
  return hash;
}

}  // namespace

void SignalJudge::Worst::hit(const PacketPlace& place, double how_bad, double of_value) {
  if (tally.hit(place) || how_bad > figure) {
    figure = how_bad;
    value = of_value;
  }
}

SignalJudge::Signal* SignalJudge::signalNamed(const PathView& path, std::string_view name) {
  const auto found = signals_.find(KeyView(path.first, path.second, name));
  if (found != signals_.end()) return &found->second;
  if (signals_.size() >= kMaxSignals) return nullptr;
  Signal signal;
  const auto expected = std::ranges::find_if(cell_.signals, [&](const CellSignal& each) {
    return each.device == path.first && each.link == path.second &&
           patternMatches(each.name, name);
  });
  if (expected != cell_.signals.end()) {
    signal.expected = &*expected;
    if (expected->stuck_s) motions_.try_emplace(std::string(path.first));
  }
  Key key{std::string(path.first), std::string(path.second), std::string(name)};
  return &signals_.emplace(std::move(key), std::move(signal)).first->second;
}

void SignalJudge::take(const Statement& statement, const PacketPlace& place) {
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    Signal* const signal = signalNamed(statement.path, statement.names[i]);
    if (signal == nullptr) continue;
    if (statement.is_default) {
      signal->has_value = false;
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
  if (kind == SignalKind::number) {
    judgeNumber(signal, number, follows, place);
    const std::string& known =
        signal.expected != nullptr && !signal.expected->unit.empty() ? signal.expected->unit
                                                                     : signal.unit;
    if (!statement.unit.empty() && !known.empty() && statement.unit != known &&
        signal.units.hit(place)) {
      signal.first_unit = known;
      signal.other_unit = statement.unit;
    }
    if (!statement.unit.empty() && signal.unit != statement.unit) signal.unit = statement.unit;
    if (!follows || signal.number != number) {
      signal.changed = place.time;
      signal.is_stuck = false;
    }
    signal.number = number;
  } else {
    const std::string_view text = kind == SignalKind::text ? statement.text
                                  : number != 0            ? std::string_view("true")
                                                           : std::string_view("false");
    judgeState(signal, text, follows, place);
    if (signal.text != text) signal.text = text;
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
  if (expected.range) {
    const double beyond =
        std::max(expected.range->first - number, number - expected.range->second);
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
  if (!expected.values.empty() && std::ranges::find(expected.values, text) == expected.values.end()) {
    hit(signal.values, {}, text);
  }
  if (!follows || expected.transitions.empty() || signal.text == text) return;
  const bool is_allowed = std::ranges::any_of(expected.transitions, [&](const auto& each) {
    return each.first == signal.text && each.second == text;
  });
  if (!is_allowed) hit(signal.transitions, signal.text, text);
}

void SignalJudge::judgeRate(Signal& signal, const PacketPlace& place) const {
  const auto [low, high] = *signal.expected->rate_hz;
  if (!std::exchange(signal.is_counted, true) || signal.stretch != place.stretch) {
    signal.window_began = place.time;
    signal.window_count = 0;
    return;
  }
  ++signal.window_count;
  const double window_s = secondsOf(place.time - signal.window_began);
  if (window_s < (low > 0 ? std::max(kWindow_s, kWindowValues / low) : kWindow_s)) return;
  const double rate_hz = static_cast<double>(signal.window_count) / window_s;
  const double off = std::max(low * (1 - kRateSlack) - rate_hz, rate_hz - high * (1 + kRateSlack));
  if (off > 0) signal.rate.hit(place, off, rate_hz);
  signal.window_began = place.time;
  signal.window_count = 0;
}

void SignalJudge::takeMotion(const Statement& statement, const PacketPlace& place) {
  if (motions_.empty()) return;
  const auto found = motions_.find(statement.name);
  if (found == motions_.end()) return;
  Motion& motion = found->second;
  const std::size_t hash = hashOf(statement);
  if (std::exchange(motion.hash, hash) == hash) return;
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
  for (; at != signals_.end() && at->first.device == device; ++at) at->second.has_value = false;
}

void SignalJudge::reportOne(const Key& key, const Signal& signal, Findings& findings) const {
  const std::string name = nameOf(key.device, key.link, key.name);
  const std::string said = signal.expected != nullptr && !signal.expected->label.empty()
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
      fmt::format("{} is first a {} and then a {}", said, signal.first_kind, signal.other_kind));
  add(signal.units, "signal.unit",
      fmt::format("{} is in {}, and in {}", said, signal.first_unit, signal.other_unit));
  if (signal.expected == nullptr) return;
  const CellSignal& expected = *signal.expected;
  const std::string& unit = expected.unit.empty() ? signal.unit : expected.unit;
  addWorst(signal.range, "signal.range", [&] {
    return fmt::format("{} is {}, where the cell expects {}", said,
                       withUnit(signal.range.value, unit), rangeText(*expected.range, unit));
  });
  addWorst(signal.jump, "signal.jump", [&] {
    return fmt::format("{} changes by {} from one value to the next; {} are expected at most", said,
                       withUnit(signal.jump.value, unit), withUnit(*expected.jump, unit));
  });
  addWorst(signal.stuck, "signal.stuck", [&] {
    return fmt::format("{} repeats one value for {:.3g} s while {} moves; {:.3g} s are expected at "
                       "most",
                       said, signal.stuck.value, plainText(key.device), *expected.stuck_s);
  });
  addWorst(signal.rate, "signal.rate", [&] {
    return fmt::format("{} is stated {:.3g} times a second, where the cell expects {}", said,
                       signal.rate.value, rangeText(*expected.rate_hz, ""));
  });
  for (const auto& [value, tally] : signal.values) {
    add(tally, "signal.unknown-value",
        fmt::format("{} is {}, which the cell does not expect", said,
                    quoted(value.second)));
  }
  for (const auto& [change, tally] : signal.transitions) {
    add(tally, "signal.transition",
        fmt::format("{} goes from {} to {}, which the cell does not expect", said,
                    quoted(change.first), quoted(change.second)));
  }
}

void SignalJudge::report(Findings& findings) const {
  for (const auto& [key, signal] : signals_) reportOne(key, signal, findings);
  for (const CellSignal& expected : cell_.signals) {
    if (expected.optional) continue;
    const bool came = std::ranges::any_of(
        signals_, [&](const auto& each) { return each.second.expected == &expected; });
    if (came) continue;
    const std::string name = nameOf(expected.device, expected.link, expected.name);
    findings.push_back(makeFinding(
        "signal.missing", name, fmt::format("the cell expects {}, which no packet states", name)));
  }
}

void SignalJudge::dropFindings() {
  for (auto& [key, signal] : signals_) {
    signal.kinds = signal.units = {};
    signal.range = signal.jump = signal.rate = signal.stuck = {};
    signal.is_stuck = false;
    signal.values.clear();
    signal.transitions.clear();
  }
}

}  // namespace rocinante
