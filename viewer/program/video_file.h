#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "viewer/picture/picture.h"
#include "viewer/program/render_moments.h"

namespace rocinante {

/// A video encoded by the ffmpeg program from raw pictures while they are drawn. It is written to a
/// temporary file and renamed: it appears whole or not at all. The extension selects the format.
/// Not thread-safe.
class VideoFile {
 public:
  /// refused when ffmpeg is missing. Pictures of odd sizes get a black row or column, because
  /// common encoders require even sizes.
  static Result<VideoFile> create(const std::filesystem::path& path, int width, int height,
                                  const FrameRate& rate, bool overwrite);
  /// Leaves no file unless finish() succeeded.
  ~VideoFile();
  VideoFile(VideoFile&&) noexcept;
  VideoFile& operator=(VideoFile&&) noexcept;

  /// Adds a picture of the video's size. refused, with ffmpeg's message, when ffmpeg has ended.
  Status add(const Picture& picture);
  /// Waits until ffmpeg has written everything.
  Status finish();

  /// Whether a name has a video's extension: .mp4, .mkv, .mov, .webm.
  static bool isVideo(const std::filesystem::path& path);

 private:
  struct Impl;
  explicit VideoFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
