#include "player/source/log_speaker.h"

#include <algorithm>

#include "core/base/pattern.h"

namespace rocinante {

bool LogChoice::includes(std::string_view source) const {
  return sources.empty() || anyPatternMatches(sources, source);
}

std::string_view LogChoice::nameOf(std::string_view source) const {
  const auto renamed = names.find(source);
  return renamed == names.end() ? source : renamed->second;
}

Result<LogSpeaker*> LogSpeakers::of(std::string_view source, std::string_view name) {
  const auto known = speakers_.find(source);
  if (known != speakers_.end()) return &known->second;
  for (const auto& [other, speaker] : speakers_) {
    if (speaker.name == name) {
      return Error{ErrorKind::bad_argument,
                   "two sources of the log, " + other + " and " + std::string(source) +
                       ", would have one name",
                   std::string(name)};
    }
  }
  return &speakers_.emplace(source, LogSpeaker{std::string(name)}).first->second;
}

const LogSpeakers::Speakers::value_type* LogSpeakers::next() const {
  const auto first = std::min_element(speakers_.begin(), speakers_.end(), [](auto& a, auto& b) {
    return a.second.restates < b.second.restates;
  });
  if (first == speakers_.end() || first->second.restates == LogTime::max()) return nullptr;
  return &*first;
}

void LogSpeakers::spread(LogTime now) {
  for (auto& [source, speaker] : speakers_) {
    if (speaker.sequence > 0) begin(speaker, now);
  }
}

void LogSpeakers::begin(LogSpeaker& speaker, LogTime now) {
  if (period_.count() == 0) return;
  std::int64_t place = 1;
  for (auto each = speakers_.begin(); &each->second != &speaker; ++each) ++place;
  speaker.restates = now + period_ * place / static_cast<std::int64_t>(speakers_.size());
}

void LogSpeakers::restated(LogSpeaker& speaker, LogTime now) const {
  if (period_.count() > 0) speaker.restates = now + period_;
}

}  // namespace rocinante
