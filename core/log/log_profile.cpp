#include "core/log/log_profile.h"

#include <fmt/format.h>

#include <charconv>

namespace rocinante::profile {

std::string_view capturedTopic(std::string_view topic) {
  for (const std::string_view prefix : {kRestatedPrefix, kDecodedPrefix}) {
    if (topic.starts_with(prefix) && topic.substr(prefix.size()).starts_with('/')) {
      topic.remove_prefix(prefix.size());
    }
  }
  return topic;
}

bool isDecodedSource(std::string_view source) { return source.starts_with(kDecodedSource); }

std::optional<LogTime> parseOrigin(std::string_view text) {
  std::int64_t nanoseconds = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, nanoseconds);
  if (fault != std::errc() || stopped != end) return std::nullopt;
  return LogTime(Nanoseconds(nanoseconds));
}

std::string otherFormatText(std::string_view format) {
  return fmt::format(
      "rocinante.session says format \"{}\", and this program reads format {}: the contents "
      "may mean something else; use the program that wrote it or a later one",
      format.substr(0, 40), kFormat);
}

}  // namespace rocinante::profile
