#include "core/relay/through.h"

#include <algorithm>

#include "core/packet/text_lines.h"

namespace rocinante {
namespace {

constexpr std::string_view kWord = "through=";

std::string_view headerLineOf(std::string_view packet) {
  TextLines lines(packet);
  std::string_view line;
  return lines.next(line) ? line : std::string_view();
}

}  // namespace

std::string_view throughOf(std::string_view packet) {
  const std::string_view line = headerLineOf(packet);
  if (line.find(kWord) == std::string_view::npos) return {};
  TextFields fields(line);
  while (!fields.atEnd()) {
    const std::string_view field = fields.take();
    if (field.starts_with(kWord)) return field.substr(kWord.size());
  }
  return {};
}

bool hasPassed(std::string_view through, std::string_view name) {
  while (!through.empty()) {
    const std::size_t comma = std::min(through.find(','), through.size());
    if (through.substr(0, comma) == name) return true;
    through.remove_prefix(std::min(comma + 1, through.size()));
  }
  return false;
}

bool isTooLong(std::string_view through) {
  const auto commas = static_cast<std::size_t>(std::count(through.begin(), through.end(), ','));
  return !through.empty() && commas + 1 > kMaxRelays;
}

std::string throughWith(std::string_view through, std::string_view name) {
  std::string names(through);
  if (!names.empty()) names += ',';
  return names.append(name);
}

std::string withThrough(std::string_view packet, std::string_view name) {
  const std::string_view line = headerLineOf(packet);
  const std::string_view through = throughOf(packet);
  // An empty word counts as none.
  const char* const end =
      through.empty() ? line.data() + line.size() : through.data() + through.size();
  const auto place = static_cast<std::size_t>(end - packet.data());
  std::string text(packet.substr(0, place));
  text += through.empty() ? " through=" : ",";
  text += name;
  text += packet.substr(place);
  return text;
}

}  // namespace rocinante
