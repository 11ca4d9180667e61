#include "viewer/backdrop/video_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/base/duration_text.h"
#include "core/cell/camera_lens.h"

namespace rocinante {
namespace {

Error badVideo(std::string what) { return {ErrorKind::damaged, std::move(what), {}}; }

std::string_view taken(std::string_view& text, char until) {
  const std::size_t end = std::min(text.find(until), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// The value of `key` in "section|key=value|key=value".
std::string_view valueOf(std::string_view line, std::string_view key) {
  while (!line.empty()) {
    std::string_view value = taken(line, '|');
    if (taken(value, '=') == key) return value;
  }
  return {};
}

std::optional<Nanoseconds> secondsIn(std::string_view text) {
  const auto time = parseDuration(text);
  // Ten years: sums of two stay within bounds.
  constexpr Nanoseconds kLongest = std::chrono::hours(24 * 3653);
  if (!time || *time > kLongest || *time < -kLongest) return std::nullopt;
  return *time;
}

int sideIn(std::string_view text) {
  int side = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), side);
  return fault == std::errc{} && stop == text.data() + text.size() ? side : 0;
}

}  // namespace

Result<VideoFacts> parseVideoFacts(std::string_view text) {
  VideoFacts facts;
  bool any_packet = false;
  while (!text.empty()) {
    const std::string_view line = taken(text, '\n');
    if (line.starts_with("packet|")) {
      any_packet = true;
      // Those with D are decoded for the sake of others, and not shown.
      const auto time = secondsIn(valueOf(line, "pts_time"));
      if (!time || valueOf(line, "flags").find('D') != std::string_view::npos) continue;
      if (facts.times.size() == kMostBackdropPictures) {
        return badVideo(fmt::format("the video has more than {} pictures", kMostBackdropPictures));
      }
      facts.times.push_back(*time);
    } else if (line.starts_with("stream|")) {
      facts.width = sideIn(valueOf(line, "width"));
      facts.height = sideIn(valueOf(line, "height"));
    } else if (line.starts_with("format|")) {
      facts.start = secondsIn(valueOf(line, "start_time")).value_or(Nanoseconds(0));
    }
  }
  if (facts.times.empty()) {
    return badVideo(any_packet ? "the pictures of the video have no times" : "it has no video");
  }
  if (facts.width < 1 || facts.height < 1 || facts.width > kMaxLensSide ||
      facts.height > kMaxLensSide || facts.width > kMaxLensPixels / facts.height) {
    return badVideo(fmt::format("the video is {}x{}; at most 7680x4320 is supported", facts.width,
                                facts.height));
  }
  std::ranges::sort(facts.times);
  // Not std::ranges::unique, whose answer clang 14 does not compile with the library of g++ 12.
  facts.times.erase(std::unique(facts.times.begin(), facts.times.end()), facts.times.end());
  return facts;
}

}  // namespace rocinante
