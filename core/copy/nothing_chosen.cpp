#include "core/copy/nothing_chosen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "core/base/duration_text.h"
#include "core/base/pattern.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxTopics = 5;

bool anyTopicMatches(const LogReader& log, const std::vector<std::string>& patterns) {
  return std::ranges::any_of(log.channels(), [&](const LogChannel& channel) {
    return anyPatternMatches(patterns, channel.topic);
  });
}

/// "there are /udp/19960/arm, /udp/19960/gantry and 12 more".
std::string topicsOf(const LogReader& log) {
  std::vector<std::string> topics;
  for (const LogChannel& channel : log.channels()) {
    if (channel.captured() && std::ranges::find(topics, channel.topic) == topics.end()) {
      topics.push_back(channel.topic);
    }
  }
  const std::size_t shown = std::min(topics.size(), kMaxTopics);
  const std::span names(topics);
  std::string text = fmt::format("there {} {}", topics.size() == 1 ? "is" : "are",
                                 fmt::join(names.first(shown), ", "));
  if (shown < topics.size()) text += fmt::format(" and {} more", topics.size() - shown);
  return plainText(text);
}

std::string reasonOf(const LogReader& log, const SelectionOptions& selection,
                     const TimeRange& range) {
  const LogSummary& summary = log.summary();
  if (!log.damage().empty()) {
    const DamageSpan& damage = log.damage().front();
    return fmt::format("not all could be read; at byte {} {}", damage.from, damage.cause);
  }
  if (summary.messages == 0) return "the log has none";
  if (range.from > summary.end || range.until <= summary.start) {
    const auto shown = [&](LogTime time) { return secondsText(time - summary.origin, 3); };
    return fmt::format("the log goes from {} s to {} s", shown(summary.start), shown(summary.end));
  }
  if (!selection.channels.empty() && !anyTopicMatches(log, selection.channels)) {
    return "no topic matches; " + topicsOf(log);
  }
  return {};
}

}  // namespace

Error nothingChosen(const LogReader& log, const SelectionOptions& selection,
                    const TimeRange& range) {
  const std::string reason = reasonOf(log, selection, range);
  return Error{ErrorKind::not_found,
               reason.empty() ? "no message was chosen" : "no message was chosen: " + reason,
               log.name()};
}

}  // namespace rocinante
