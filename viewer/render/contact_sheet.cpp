#include "viewer/render/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace rocinante {
namespace {

constexpr int kGap = 12;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 27;
constexpr std::uint32_t kPaper = 0xF4F5F6FF;
constexpr std::uint32_t kInk = 0x20242AFF;

void fill(Picture& picture, std::uint32_t rgba) {
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    picture.rgba[i] = static_cast<std::uint8_t>(rgba >> (24 - 8 * (i % 4)));
  }
}

void copyInto(Picture& sheet, const Picture& frame, int left, int top) {
  const auto row_bytes = static_cast<std::ptrdiff_t>(frame.width) * 4;
  for (int y = 0; y < frame.height; ++y) {
    const auto source = frame.rgba.begin() + row_bytes * y;
    const auto target = (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left) * 4;
    std::copy(source, source + row_bytes, sheet.rgba.begin() + target);
  }
}

}  // namespace

Result<Picture> contactSheet(const std::vector<SheetFrame>& frames, const TextAtlas& atlas) {
  if (frames.empty()) {
    return Error{ErrorKind::bad_argument, "a contact sheet needs at least one moment", {}};
  }
  const std::int64_t count = static_cast<std::int64_t>(frames.size());
  std::int64_t columns = 1;
  while (columns * columns < count) ++columns;
  const std::int64_t rows = (count + columns - 1) / columns;
  const std::int64_t cell_width = frames.front().picture.width + kGap;
  const std::int64_t cell_height =
      std::int64_t{frames.front().picture.height} + atlas.linePixels() + kGap;
  const std::int64_t width = columns * cell_width + kGap;
  const std::int64_t height = rows * cell_height + kGap;
  if (width * height > kMaxPixels) {
    return Error{
        ErrorKind::bad_argument,
        fmt::format("a contact sheet of {}x{} pixels is too large: ask for fewer moments or "
                    "a smaller --size",
                    width, height),
        {}};
  }

  Picture sheet;
  sheet.width = static_cast<int>(width);
  sheet.height = static_cast<int>(height);
  sheet.rgba.resize(static_cast<std::size_t>(width * height) * 4);
  fill(sheet, kPaper);
  for (std::int64_t i = 0; i < count; ++i) {
    const SheetFrame& frame = frames[static_cast<std::size_t>(i)];
    const int left = static_cast<int>(kGap + i % columns * cell_width);
    const int top = static_cast<int>(kGap + i / columns * cell_height);
    copyInto(sheet, frame.picture, left, top);
    const TextSize size = atlas.measure(frame.caption);
    atlas.drawOn(sheet, left + (frame.picture.width - size.width) / 2,
                 top + frame.picture.height + 2, frame.caption, kInk);
  }
  return sheet;
}

}  // namespace rocinante
