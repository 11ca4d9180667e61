#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/backdrop/backdrop_request.h"
#include "viewer/backdrop/lens_map.h"
#include "viewer/backdrop/picture_folder.h"
#include "viewer/backdrop/video_reader.h"
#include "viewer/view/backdrop_frame.h"

namespace rocinante {

/// The pictures of a real camera, by the time of the session, as the cell's calibrated camera has
/// them. One thread at a time.
class Backdrop {
 public:
  /// bad_argument when the cell has no such camera or the pictures have no times; what the file
  /// itself lacks otherwise. `origin` and `end` are the session's, for times in RFC 3339.
  static Result<Backdrop> open(const BackdropRequest& request, const Cell& cell, LogTime origin,
                               LogTime end);

  const std::string& camera() const { return camera_; }

  /// The picture at a session time: the last one until then, at the end as long as the one before
  /// it; a single picture at all times. Empty: none.
  std::optional<std::size_t> numberAt(Nanoseconds since_origin) const;
  /// That picture, straightened. The last ones are kept. `stopped` may be empty.
  Result<std::shared_ptr<const BackdropPicture>> picture(std::size_t number,
                                                         const std::function<bool()>& stopped);

  /// Of all pictures; a later session time for the same picture when it is larger.
  void setOffset(Nanoseconds offset) { offset_ = offset; }
  Nanoseconds offset() const { return offset_; }

 private:
  Backdrop() = default;
  Result<Picture> read(std::size_t number, const std::function<bool()>& stopped);
  Status checkSize(const Picture& picture, std::size_t number) const;
  std::filesystem::path nameOf(std::size_t number) const;

  std::string camera_;
  CameraIntrinsics lens_;
  LensDistortion distortion_;
  Nanoseconds offset_{0};
  std::filesystem::path file_;
  std::vector<std::filesystem::path> files_;  ///< of a folder
  std::optional<VideoReader> video_;
  std::vector<Nanoseconds> times_;  ///< of folder and video; empty: a single picture
  std::optional<LensMap> map_;      ///< of pictures of the last size
  struct Kept {
    std::size_t number = 0;
    std::shared_ptr<const BackdropPicture> picture;
  };
  std::vector<Kept> kept_;  ///< the latest last
};

}  // namespace rocinante
