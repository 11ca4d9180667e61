#include "viewer/backdrop/backdrop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/base/duration_text.h"
#include "core/base/name_hint.h"
#include "viewer/picture/mipmaps.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKept = 8;
constexpr std::size_t kKeptBytes = std::size_t{256} << 20U;

/// Everything else is a video.
bool isPictureName(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array kEndings{".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp",
                                ".exr", ".hdr", ".tga",  ".ppm", ".pgm",  ".pnm"};
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

Result<const CellCamera*> calibratedCamera(const Cell& cell, const std::string& name) {
  std::vector<std::string_view> calibrated;
  for (const CellCamera& camera : cell.cameras) {
    if (camera.intrinsics) calibrated.emplace_back(camera.name);
  }
  const auto bad = [&](std::string what) {
    return Error{ErrorKind::bad_argument, std::move(what), cell.shown(cell.file)};
  };
  if (calibrated.empty()) {
    return bad("no camera of the cell has `intrinsics`, which a backdrop needs");
  }
  if (name.empty() && calibrated.size() > 1) {
    return bad("several cameras have `intrinsics`: add ,camera=NAME to the backdrop; " +
               whatThereIs("", calibrated));
  }
  const CellCamera* const camera = cell.findCamera(name.empty() ? calibrated.front() : name);
  if (camera == nullptr || !camera->intrinsics) {
    return bad((camera == nullptr ? "the backdrop's camera `" + name + "` is unknown: "
                                  : "camera `" + name + "` has no `intrinsics`: ") +
               whatThereIs(name, calibrated));
  }
  return camera;
}

std::size_t bytesOf(const BackdropPicture& picture) {
  std::size_t bytes = 0;
  for (const Picture& level : picture.levels) bytes += level.rgba.size();
  return bytes;
}

}  // namespace

Result<Backdrop> Backdrop::open(const BackdropRequest& request, const Cell& cell, LogTime origin,
                                LogTime end) {
  const auto camera = calibratedCamera(cell, request.camera);
  if (!camera) return camera.error();
  Backdrop backdrop;
  backdrop.camera_ = (*camera)->name;
  backdrop.lens_ = *(*camera)->intrinsics;
  backdrop.distortion_ = (*camera)->distortion;
  backdrop.file_ = request.file;
  if (!request.offset.empty()) {
    const auto offset = parseDuration(request.offset);
    if (!offset) return offset.error();
    backdrop.offset_ = *offset;
  }
  std::error_code fault;
  const fs::file_status status = fs::status(request.file, fault);
  if (!fs::exists(status)) {
    return Error{ErrorKind::not_found, "there is no such file", request.file.string()};
  }
  if (fs::is_directory(status)) {
    auto folder = readPictureFolder(request.file, request.period, origin, end);
    if (!folder) return folder.error();
    backdrop.files_ = std::move(folder->files);
    backdrop.times_ = std::move(folder->times);
  } else if (!isPictureName(request.file)) {
    auto video = VideoReader::open(request.file);
    if (!video) return video.error();
    backdrop.times_ = video->facts().times;
    const Nanoseconds first = backdrop.times_.front();
    for (Nanoseconds& time : backdrop.times_) time -= first;
    backdrop.video_ = std::move(*video);
  }
  // What cannot be read is said before anything is drawn.
  if (const auto first = backdrop.picture(0, {}); !first) return first.error();
  return backdrop;
}

std::optional<std::size_t> Backdrop::numberAt(Nanoseconds since_origin) const {
  if (times_.empty()) return 0;
  const Nanoseconds time = since_origin - offset_;
  const auto after = std::ranges::upper_bound(times_, time);
  if (after == times_.begin()) return std::nullopt;
  const auto number = static_cast<std::size_t>(after - times_.begin()) - 1;
  if (after == times_.end() && number > 0 &&
      time - times_[number] >= times_[number] - times_[number - 1]) {
    return std::nullopt;
  }
  return number;
}

fs::path Backdrop::nameOf(std::size_t number) const {
  return files_.empty() ? file_ : files_[number];
}

Result<Picture> Backdrop::read(std::size_t number, const std::function<bool()>& stopped) {
  if (video_) return video_->read(number, stopped);
  return readPicture(nameOf(number), kMaxLensPixels);
}

Status Backdrop::checkSize(const Picture& picture, std::size_t number) const {
  // The calibration's, or larger or smaller as a whole, to a pixel.
  const double high = static_cast<double>(picture.width) * lens_.height / lens_.width;
  if (picture.width >= 1 && std::abs(high - picture.height) <= 1) return {};
  return Error{ErrorKind::bad_argument,
               fmt::format("the picture has {}x{} pixels, and camera `{}` is calibrated for {}x{}",
                           picture.width, picture.height, camera_, lens_.width, lens_.height),
               nameOf(number).string()};
}

Result<std::shared_ptr<const BackdropPicture>> Backdrop::picture(
    std::size_t number, const std::function<bool()>& stopped) {
  static std::atomic<std::uint64_t> pictures_made{0};
  const auto known = std::ranges::find(kept_, number, &Kept::number);
  if (known != kept_.end()) {
    std::rotate(known, known + 1, kept_.end());
    return kept_.back().picture;
  }
  auto read_picture = read(number, stopped);
  if (!read_picture) return read_picture.error();
  if (Status fits = checkSize(*read_picture, number); !fits) return fits.error();
  auto made = std::make_shared<BackdropPicture>();
  made->number = ++pictures_made;
  if (distortion_ == LensDistortion()) {
    made->levels.push_back(std::move(*read_picture));
  } else {
    if (!map_ || map_->width() != read_picture->width || map_->height() != read_picture->height) {
      map_.emplace(lens_, distortion_, read_picture->width, read_picture->height);
    }
    made->levels.push_back(map_->straightened(*read_picture));
  }
  for (Picture& smaller : mipmapsOf(made->levels.front())) {
    made->levels.push_back(std::move(smaller));
  }
  kept_.push_back({number, made});
  std::size_t bytes = 0;
  for (const Kept& kept : kept_) bytes += bytesOf(*kept.picture);
  while (kept_.size() > 1 && (kept_.size() > kKept || bytes > kKeptBytes)) {
    bytes -= bytesOf(*kept_.front().picture);
    kept_.erase(kept_.begin());
  }
  return std::shared_ptr<const BackdropPicture>(std::move(made));
}

}  // namespace rocinante
