#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "viewer/picture/picture.h"
#include "viewer/program/render_moments.h"

namespace rocinante {

/// A video that ffmpeg, a program of its own, encodes from raw pictures while they are drawn. It is
/// written beside its place and renamed: the file appears whole or not at all. Its format is that
/// of its ending. One thread.
class VideoFile {
 public:
  /// refused when ffmpeg is not there. Pictures of odd sizes get a black row or column, because the
  /// usual encoders take even ones only.
  static Result<VideoFile> create(const std::filesystem::path& path, int width, int height,
                                  const FrameRate& rate, bool overwrite);
  /// Leaves no file unless finish() succeeded.
  ~VideoFile();
  VideoFile(VideoFile&&) noexcept;
  VideoFile& operator=(VideoFile&&) noexcept;

  /// The next picture, of the video's size. refused, with ffmpeg's own words, when it has ended.
  Status add(const Picture& picture);
  /// Waits until ffmpeg has written all.
  Status finish();

  /// Whether a name has an ending that a video can have: .mp4, .mkv, .mov, .webm.
  static bool isVideo(const std::filesystem::path& path);

 private:
  struct Impl;
  explicit VideoFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
