#include "core/session/state_damage.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxParts = 100;

Nanoseconds sinceOrigin(LogTime time, LogTime origin) {
  if (time == LogTime::min()) return Nanoseconds::min();
  if (time == LogTime::max()) return Nanoseconds::max();
  return time - origin;
}

}  // namespace

void StateDamage::add(Part part) {
  const auto place = std::ranges::lower_bound(parts_, part);
  if (place != parts_.end() && *place == part) return;
  parts_.insert(place, std::move(part));
  if (parts_.size() <= kMaxParts) return;
  parts_.pop_back();
  is_more_ = true;
}

void StateDamage::add(const StateDamage& other) {
  for (const Part& part : other.parts_) add(part);
  is_more_ = is_more_ || other.is_more_;
}

StateDamage StateDamage::within(Nanoseconds from, Nanoseconds until) const {
  StateDamage found;
  for (const Part& part : parts_) {
    if (part.until >= from && part.from <= until) found.parts_.push_back(part);
  }
  // The parts that are not named may be anywhere.
  found.is_more_ = is_more_ && !found.parts_.empty();
  return found;
}

std::string StateDamage::what() const {
  if (parts_.empty()) return {};
  Nanoseconds from = Nanoseconds::max(), until = Nanoseconds::min();
  for (const Part& part : parts_) {
    from = std::min(from, part.from);
    until = std::max(until, part.until);
  }
  std::string text = "the log is damaged";
  if (from != Nanoseconds::min() && until != Nanoseconds::max()) {
    text += fmt::format(" from {:.3f} to {:.3f} s", secondsOf(from), secondsOf(until));
  } else if (from != Nanoseconds::min()) {
    text += fmt::format(" after {:.3f} s", secondsOf(from));
  } else if (until != Nanoseconds::max()) {
    text += fmt::format(" before {:.3f} s", secondsOf(until));
  }
  if (parts_.size() > 1) {
    text += fmt::format(" in {}{}, first", is_more_ ? "more than " : "",
                        countText(parts_.size(), "place"));
  }
  return text + ": " + parts_.front().cause;
}

std::string StateDamage::where() const {
  if (parts_.empty()) return {};
  return fmt::format("{}, byte {}", plainText(parts_.front().log), parts_.front().from_byte);
}

std::string StateDamage::text() const {
  return parts_.empty() ? std::string() : what() + " (" + where() + ")";
}

void addDamageBetween(const LogReader& log, LogPosition base, LogPosition last,
                      StateDamage& damage) {
  const LogTime origin = log.summary().origin;
  for (const UnreadableRange& range : log.unreadable()) {
    if (range.first > last || range.last <= base) continue;
    const DamageSpan& its = log.damage()[range.damage];
    damage.add({log.name(), its.from, its.to, sinceOrigin(range.first.time, origin),
                sinceOrigin(range.last.time, origin), its.cause});
  }
}

}  // namespace rocinante
