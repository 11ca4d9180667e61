#include "core/check/tally.h"

#include <fmt/format.h>

namespace rocinante {
namespace {

constexpr std::size_t kShownBytes = 160;

}  // namespace

std::string lineForReport(ByteView datagram, std::uint32_t number) {
  std::string_view text = textOf(datagram);
  for (std::uint32_t line = 1; line < number; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  std::string shown;
  for (const char c : text.substr(0, kShownBytes)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte == '\t') {
      shown += ' ';
    } else if (byte < 0x20 || byte == 0x7F) {
      shown += fmt::format("\\x{:02x}", byte);
    } else {
      shown += c;
    }
  }
  return text.size() > kShownBytes ? shown + "..." : shown;
}

bool Tally::hit(const Place& place) {
  last = place.time;
  if (++count > 1) return false;
  first = place.time;
  packet = place.packet;
  if (place.line > 0) example = lineForReport(place.datagram, place.line);
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
  // What a recorder restated before the first datagram has no number.
  if (packet > 0) finding.packet = packet;
  finding.subject = std::move(subject);
  finding.text = std::move(text);
  finding.example = example;
  return finding;
}

}  // namespace rocinante
