#include "core/check/judges/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "core/base/plain_text.h"
#include "core/check/rules/rule_list.h"

namespace rocinante {

Finding makeFinding(std::string_view rule, std::string subject, std::string text) {
  const Rule* const known = findRule(rule);
  assert(known != nullptr);
  Finding finding;
  finding.rule = rule;
  finding.severity = known->severity;
  finding.subject = std::move(subject);
  finding.text = std::move(text);
  return finding;
}

std::optional<double> statedValue(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  const std::string text = fmt::format("{:.6g}", value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool Tally::hit(const PacketPlace& place) {
  last = place.time;
  when.hit(place.time);
  if (++count > 1) return false;
  first = place.time;
  packet = place.packet;
  if (place.line > 0) example = plainLine(place.datagram, place.line);
  return true;
}

void Tally::merge(const Tally& other) {
  if (other.count == 0) return;
  if (count == 0) {
    *this = other;
    return;
  }
  if (other.first < first) {
    Tally merged = other;
    merged.merge(*this);
    *this = std::move(merged);
    return;
  }
  count += other.count;
  last = std::max(last, other.last);
  when.merge(other.when);
}

Finding Tally::finding(std::string_view rule, std::string subject, std::string text) const {
  Finding finding = makeFinding(rule, std::move(subject), std::move(text));
  finding.count = count;
  finding.first = first;
  finding.last = last;
  finding.when = when;
  // Restatements of a recorder before the first datagram have no number.
  if (packet > 0) finding.packet = packet;
  finding.example = example;
  return finding;
}

}  // namespace rocinante
