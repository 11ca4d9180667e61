#include "core/check/tally.h"

#include "core/plain_text.h"

namespace rocinante {
bool Tally::hit(const Place& place) {
  last = place.time;
  when.hit(place.time);
  if (++count > 1) return false;
  first = place.time;
  packet = place.packet;
  if (place.line > 0) example = plainLine(place.datagram, place.line);
  return true;
}

Finding Tally::finding(std::string rule, Severity severity, std::string subject,
                       std::string text) const {
  Finding finding;
  finding.rule = std::move(rule);
  finding.severity = severity;
  finding.count = count;
  finding.first = first;
  finding.last = last;
  finding.when = when;
  // What a recorder restated before the first datagram has no number.
  if (packet > 0) finding.packet = packet;
  finding.subject = std::move(subject);
  finding.text = std::move(text);
  finding.example = example;
  return finding;
}

}  // namespace rocinante
