#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// What ffprobe says of a video.
struct VideoFacts {
  int width = 0, height = 0;
  Nanoseconds start{0};            ///< of the file, on its own clock
  std::vector<Nanoseconds> times;  ///< of its pictures, on the same clock, in order
};

/// Most pictures of a video or a folder.
inline constexpr std::size_t kMostBackdropPictures = 1'000'000;

/// Reads the output of `ffprobe -of compact` with packets' pts_time and flags, the stream's width
/// and height, and the file's start_time. The text may be anything. unreadable when no video is in
/// it, or more than a backdrop may have.
Result<VideoFacts> parseVideoFacts(std::string_view text);

}  // namespace rocinante
