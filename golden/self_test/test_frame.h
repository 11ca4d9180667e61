#pragma once

#include <span>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/cell/cell.h"
#include "viewer/picture/picture.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// A small built-in cell: every shape, one of them translucent, rotated and placed on the ground.
Result<Cell> testCell();
/// Its request: with shadows and all samples.
FrameRequest testFrameRequest();

/// SHA-256 of that frame's rows for renderers whose frame was looked at.
struct KnownFrame {
  std::string_view key;     ///< RendererKey::text()
  std::string_view sha256;  ///< pictureSha256()
  std::string_view where;   ///< "Debian 12, OSMesa"
};
std::span<const KnownFrame> knownFrames();

/// The frame as the first of the known renderers draws it: frame.png beside this file.
Result<Picture> referenceFrame();

/// A small JPEG file.
ByteView testPictureFile();

}  // namespace rocinante
