#include "viewer/ui/live/keep_limits.h"

#include <string>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kLeastTime = std::chrono::seconds(1);
constexpr std::uint64_t kLeastBytes = 10'000'000;

Error badLimit(const std::string& why, std::string_view text) {
  return {ErrorKind::bad_argument, why, "--keep " + std::string(text)};
}

}  // namespace

Result<KeepLimits> parseKeepLimits(std::string_view text) {
  KeepLimits limits;
  if (text == "0") {
    limits.time = Nanoseconds(0);
    return limits;
  }
  bool has_time = false;
  bool has_size = false;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    const auto time = parseDuration(word);
    const auto size = parseSize(word);
    // A bare number could be either.
    const bool is_size = size.ok() && (word.ends_with('B') || word.ends_with('b'));
    if (is_size && !has_size) {
      if (*size < kLeastBytes) return badLimit("the size to keep must be at least 10 MB", text);
      limits.bytes = *size;
      has_size = true;
    } else if (!is_size && time.ok() && !has_time) {
      if (*time < kLeastTime) return badLimit("the time to keep must be at least 1 s", text);
      limits.time = *time;
      has_time = true;
    } else {
      return badLimit("must be a time, a size or both, such as 10m,2GB, or 0 for nothing", text);
    }
    if (comma == std::string_view::npos) return limits;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace rocinante
