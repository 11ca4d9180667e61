#include "golden/compare/compare_files.h"

#include <fmt/format.h>

#include <new>
#include <thread>

#include "viewer/picture/exif_orientation.h"

namespace rocinante {
namespace {

/// No exception may leave a thread.
Result<FinePicture> readOrSayWhy(const std::filesystem::path& path) {
  try {
    return readFinePicture(path);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::refused, "no memory to read the picture", path.string()};
  }
}

/// Judges the two pictures, both already read.
void judge(const Tolerance& tolerance, const std::vector<MaskRectangle>& rectangles,
           FilesComparison& result) {
  const FinePicture& frame = *result.frame;
  const FinePicture& golden = *result.golden;
  if (frame.encoding.components != golden.encoding.components) {
    result.notes.push_back(fmt::format("the frame is {}, the golden {}",
                                       frame.encoding.componentsText(),
                                       golden.encoding.componentsText()));
  }
  if (frame.orientation != golden.orientation) {
    result.notes.push_back(fmt::format(
        "EXIF orientation: viewers show the frame {}, the golden {}; pixels are compared as stored",
        orientationText(frame.orientation), orientationText(golden.orientation)));
  }
  std::optional<PictureMask> mask;
  if (!rectangles.empty()) {
    mask.emplace(golden.picture.width, golden.picture.height);
    for (const MaskRectangle& rectangle : rectangles) mask->hide(rectangle, rectangle.text());
    result.masks = mask->parts();
    for (const PictureMask::Part& part : result.masks) {
      if (part.pixels == 0) result.notes.push_back(fmt::format("mask {} hides nothing", part.name));
    }
  }
  result.comparison = compareFine(frame, golden, tolerance, mask ? &*mask : nullptr);
  if (mask && result.comparable()) {
    result.masked_frame = mask->applied(frame.picture, golden.picture);
  }
}

}  // namespace

FilesComparison compareFiles(const std::filesystem::path& frame,
                             const std::filesystem::path& golden, const Tolerance& tolerance,
                             const std::vector<MaskRectangle>& masks) {
  FilesComparison result;
  // Decoding takes nearly all of the time.
  Result<FinePicture> second = FinePicture{};
  std::thread reader([&] { second = readOrSayWhy(golden); });
  Result<FinePicture> first = readOrSayWhy(frame);
  reader.join();
  if (!second.ok()) result.unreadable = second.error();
  if (!first.ok()) result.unreadable = first.error();
  if (first.ok()) result.frame = std::move(*first);
  if (second.ok()) result.golden = std::move(*second);
  if (result.unreadable) {
    result.comparison.rule = result.unreadable->text();
  } else {
    judge(tolerance, masks, result);
  }
  return result;
}

}  // namespace rocinante
