#include "viewer/program/render_run.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "viewer/picture/picture_options.h"
#include "viewer/program/measured_files.h"

namespace rocinante {
namespace {

constexpr int kCaptionPx = 18;
/// More pictures than this are synced to disk together at the end: one by one, syncing small ones
/// took longer than drawing them.
constexpr std::size_t kMaxSyncedAlone = 16;

std::string captionOf(const RenderMoment& moment, const std::string& camera) {
  const bool bare = moment.text.find_first_not_of("0123456789.-") == std::string::npos;
  std::string caption = moment.text;
  // Shorten an event's time to milliseconds.
  if (!moment.event.empty()) caption.resize(std::min(caption.size(), caption.find('.') + 4));
  if (bare) caption += " s";
  if (!moment.event.empty()) caption += "  " + moment.event;
  if (!camera.empty()) caption += "  " + camera;
  return caption;
}

}  // namespace

RenderRun::RenderRun(const RenderJob& job, const FrameRequest& look, RenderFiles files,
                     FrameMaker& maker)
    : job_(job),
      request_(look),
      files_(std::move(files)),
      maker_(maker),
      atlas_(static_cast<int>(kCaptionPx * request_.scale + 0.5)),
      frames_(files_.moments.size() * files_.cameras.size()),
      sync_(frames_.size() > kMaxSyncedAlone ? Sync::later : Sync::now) {}

Status RenderRun::begin(const FrameRate& rate) {
  if (!job_.sheet.empty()) {
    auto sheet = ContactSheet::create(frames_.size(), request_.width, request_.height, atlas_);
    if (!sheet) return sheet.error();
    sheet_ = std::move(*sheet);
  }
  if (job_.video.empty()) return {};
  for (std::size_t camera = 0; camera < files_.cameras.size(); ++camera) {
    auto video = VideoFile::create(files_.ofCamera(job_.video, camera), request_.width,
                                   request_.height, rate, job_.overwrite);
    if (!video) return video.error();
    videos_.push_back(std::move(*video));
  }
  return {};
}

Status RenderRun::draw(std::size_t moment, std::size_t camera) {
  const std::size_t place = moment * files_.cameras.size() + camera;
  RenderedFrame& frame = frames_[place];
  frame.time = files_.moments[moment].text;
  frame.log_time = files_.moments[moment].time;
  frame.event = files_.moments[moment].event;
  frame.camera = files_.cameras[camera];
  request_.time = frame.log_time;
  request_.camera = frame.camera;
  const bool any_picture = job_.hashes || !job_.output.empty() || !job_.frames.empty() ||
                           !job_.sheet.empty() || !job_.video.empty();
  if (any_picture) {
    if (Status drawn = drawPicture(moment, camera, place); !drawn) return drawn;
  }
  return drawMeasured(moment, camera, frame);
}

Status RenderRun::finish() {
  if (Status written = writer_.finish(); !written) return written;
  if (Status synced = syncPictures(); !synced) return synced;
  for (VideoFile& video : videos_) {
    if (Status finished = video.finish(); !finished) return finished;
  }
  if (!sheet_) return {};
  const Result<Bytes> encoded = encodePicture(job_.sheet, sheet_->picture());
  if (!encoded) return encoded.error();
  return writeFileWhole(job_.sheet, *encoded, job_.overwrite);
}

Status RenderRun::syncPictures() const {
  if (sync_ == Sync::now) return {};
  std::set<std::filesystem::path> folders;
  for (const auto& file : {job_.output, job_.identity, job_.depth}) {
    if (!file.empty()) folders.insert(file.has_parent_path() ? file.parent_path() : ".");
  }
  if (!job_.frames.empty()) folders.insert(job_.frames);
  for (const auto& folder : folders) {
    if (Status synced = syncFileSystem(folder); !synced) return synced;
  }
  return {};
}

Status RenderRun::drawTile(std::size_t moment, std::size_t camera, std::size_t place,
                           const Picture* picture) {
  std::optional<Picture> tile;
  if (picture == nullptr) {
    FrameRequest request = request_;
    request.scale = tileScale(request_.width, request_.height, request_.scale);
    auto drawn = maker_.frame(request, &frames_[place].damage);
    if (!drawn) return drawn.error();
    tile = std::move(*drawn);
  }
  const std::string& named = files_.cameras.size() > 1 ? files_.cameras[camera] : std::string();
  sheet_->put(place, tile ? *tile : *picture, captionOf(files_.moments[moment], named));
  return {};
}

Status RenderRun::drawPicture(std::size_t moment, std::size_t camera, std::size_t place) {
  const bool same_scale =
      tileScale(request_.width, request_.height, request_.scale) == request_.scale;
  const bool beside_sheet =
      job_.hashes || !job_.output.empty() || !job_.frames.empty() || !job_.video.empty();
  if (sheet_ && !same_scale) {
    if (Status put = drawTile(moment, camera, place, nullptr); !put) return put;
    if (!beside_sheet) return {};
  }
  auto drawn = maker_.frame(request_, &frames_[place].damage);
  if (!drawn) return drawn.error();
  const auto picture = std::make_shared<const Picture>(std::move(*drawn));
  if (sheet_ && same_scale) {
    if (Status put = drawTile(moment, camera, place, picture.get()); !put) return put;
  }
  if (!videos_.empty()) {
    if (Status added = videos_[camera].add(*picture); !added) return added;
  }
  RenderedFrame& frame = frames_[place];
  if (!job_.frames.empty()) frame.file = files_.frame(moment, camera);
  std::vector<std::filesystem::path> wanted;
  if (!frame.file.empty()) wanted.push_back(frame.file);
  if (!job_.output.empty()) {
    frame.file = files_.ofCamera(job_.output, camera);
    wanted.push_back(frame.file);
  }
  if (wanted.empty() && !job_.hashes) return {};
  return writer_.add([this, picture, wanted, &frame]() -> Status {
    if (job_.hashes) frame.sha256 = pictureSha256(*picture);
    Result<Bytes> encoded = Bytes{};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (i == 0 || wanted[i].extension() != wanted[i - 1].extension()) {
        encoded = encodePicture(wanted[i], *picture);
        if (!encoded) return encoded.error();
      }
      Status written = writeFileWhole(wanted[i], *encoded, job_.overwrite, sync_);
      if (!written) return written;
    }
    return {};
  });
}

Status RenderRun::drawMeasured(std::size_t moment, std::size_t camera, RenderedFrame& frame) {
  const MeasuredFrame of{frame.time, frame.log_time.time_since_epoch().count(), frame.camera};
  if (!job_.identity.empty()) {
    auto identity = maker_.identity(request_, &frame.damage);
    if (!identity) return identity.error();
    frame.identity = files_.ofMoment(job_.identity, moment, camera);
    auto shared = std::make_shared<const IdentityFrame>(std::move(*identity));
    Status added = writer_.add([=, this, file = frame.identity] {
      return writeIdentity(file, *shared, of, job_.overwrite, sync_);
    });
    if (!added) return added;
  }
  if (job_.depth.empty()) return {};
  auto depth = maker_.depth(request_, &frame.damage);
  if (!depth) return depth.error();
  frame.depth = files_.ofMoment(job_.depth, moment, camera);
  auto shared = std::make_shared<const DepthFrame>(std::move(*depth));
  return writer_.add([=, this, file = frame.depth] {
    return writeDepth(file, *shared, of, job_.overwrite, sync_);
  });
}

}  // namespace rocinante
