#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/result.h"
#include "viewer/program/background_writer.h"
#include "viewer/program/contact_sheet.h"
#include "viewer/program/render_files.h"
#include "viewer/program/render_job.h"
#include "viewer/program/video_file.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// Draws the frames of a job one by one, and writes what the job asks of each. Borrows job and
/// maker. Other threads encode and write meanwhile, until finish().
class RenderRun {
 public:
  /// `look` is that of the job with its insets.
  RenderRun(const RenderJob& job, const FrameRequest& look, RenderFiles files, FrameMaker& maker);

  /// Opens sheet and videos, once, before the first frame.
  Status begin(const FrameRate& rate);
  /// Frames of a video come in time order.
  Status draw(std::size_t moment, std::size_t camera);
  /// Waits for all files and completes sheet and videos.
  Status finish();
  /// By moment, then camera; after finish().
  std::vector<RenderedFrame> takeFrames() { return std::move(frames_); }

 private:
  Status syncPictures() const;
  /// Draws a tile of the sheet, anew if its scale differs from the picture's.
  Status drawTile(std::size_t moment, std::size_t camera, std::size_t place,
                  const Picture* picture);
  Status drawPicture(std::size_t moment, std::size_t camera, std::size_t place);
  Status drawMeasured(std::size_t moment, std::size_t camera, RenderedFrame& frame);

  const RenderJob& job_;
  FrameRequest request_;
  const RenderFiles files_;
  FrameMaker& maker_;
  const TextAtlas atlas_;
  std::optional<ContactSheet> sheet_;
  std::vector<VideoFile> videos_;
  std::vector<RenderedFrame> frames_;
  const Sync sync_;
  BackgroundWriter writer_;  // last: its tasks use all of the above
};

}  // namespace rocinante
