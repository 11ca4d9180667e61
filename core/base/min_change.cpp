#include "core/base/min_change.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/pattern.h"

namespace rocinante {

double MinChange::ofSignal(std::string_view path_and_name) const {
  double greatest = 0;
  for (const OfSignals& each : signals) {
    if (each.least <= greatest || !patternMatches(each.pattern, path_and_name)) continue;
    greatest = each.least;
  }
  return greatest;
}

Status MinChange::add(std::string_view text) {
  constexpr std::string_view kSignal = "signal";
  // A pattern may hold a `=` in `[...]`; names of packets never do.
  const std::size_t equals = std::min(text.rfind('='), text.size());
  const std::string_view what = text.substr(0, equals);
  const bool of_signals =
      what == kSignal || (what.starts_with("signal ") && what.size() > kSignal.size() + 1);
  double* const value = what == "joint"      ? &joint
                        : what == "position" ? &position
                        : what == "turn"     ? &turn
                                             : nullptr;
  if (equals == text.size() || (value == nullptr && !of_signals)) {
    return Error{ErrorKind::bad_argument,
                 "takes joint=X, position=X, turn=X, signal=X and 'signal PATTERN=X'",
                 std::string(text)};
  }
  const std::string_view digits = text.substr(equals + 1);
  double number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (fault != std::errc() || end != digits.data() + digits.size() || !(number > 0) ||
      !std::isfinite(number)) {
    return Error{ErrorKind::bad_argument, "needs a number greater than zero", std::string(text)};
  }
  if (value != nullptr) {
    *value = number;
  } else {
    const bool all = what == kSignal;
    signals.push_back({all ? "*" : std::string(what.substr(kSignal.size() + 1)), number});
  }
  return {};
}

Status MinChange::addAll(std::string_view text) {
  for (std::size_t end = 0; end != text.npos;) {
    end = text.find(',');
    if (Status added = add(text.substr(0, end)); !added) return added;
    text.remove_prefix(std::min(end, text.size() - 1) + 1);
  }
  return {};
}

void MinChange::join(const MinChange& other) {
  joint = std::max(joint, other.joint);
  position = std::max(position, other.position);
  turn = std::max(turn, other.turn);
  signals.insert(signals.end(), other.signals.begin(), other.signals.end());
}

}  // namespace rocinante
