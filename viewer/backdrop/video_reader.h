#pragma once

#include <filesystem>
#include <optional>

#include "viewer/backdrop/child_pipe.h"
#include "viewer/backdrop/video_facts.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Pictures of a video, decoded by the programs ffprobe and ffmpeg. Reading forwards continues
/// where it was; anything else begins anew at the wanted picture. Not thread-safe.
class VideoReader {
 public:
  /// refused, saying what to install, when the programs are missing.
  static Result<VideoReader> open(const std::filesystem::path& file);

  const VideoFacts& facts() const { return facts_; }
  /// The picture of facts().times[number]. `stopped` may be empty; another thread may be asked.
  Result<Picture> read(std::size_t number, const std::function<bool()>& stopped);

 private:
  VideoReader() = default;
  Status beginAt(std::size_t number);

  std::filesystem::path file_;
  VideoFacts facts_;
  std::optional<ChildPipe> decoder_;
  std::size_t next_ = 0;  ///< picture that the decoder gives next
};

}  // namespace rocinante
