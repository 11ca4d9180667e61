#include "viewer/program/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "viewer/render/frame_maker.h"

namespace rocinante {
namespace {

constexpr int kSheetGap = 12;
constexpr std::int64_t kSheetMaxPixels = std::int64_t{1} << 27;
constexpr std::uint32_t kSheetPaper = 0xF4F5F6FF;
constexpr std::uint32_t kSheetInk = 0x20242AFF;

void fillSheet(Picture& picture, std::uint32_t rgba) {
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    picture.rgba[i] = static_cast<std::uint8_t>(rgba >> (24 - 8 * (i % 4)));
  }
}

void copyOnto(Picture& sheet, const Picture& frame, int left, int top) {
  const auto row_bytes = static_cast<std::ptrdiff_t>(frame.width) * 4;
  for (int y = 0; y < frame.height; ++y) {
    const auto source = frame.rgba.begin() + row_bytes * y;
    const auto target = (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left) * 4;
    std::copy(source, source + row_bytes, sheet.rgba.begin() + target);
  }
}

/// As much of the text as fits, with an ellipsis if cut.
std::string cutToFit(std::string text, int width, const TextAtlas& atlas) {
  const std::string ellipsis = "\u2026";
  if (atlas.measure(text).width <= width) return text;
  while (!text.empty() && atlas.measure(text + ellipsis).width > width) {
    // Whole characters of UTF-8.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) {
      text.pop_back();
    }
    if (!text.empty()) text.pop_back();
  }
  return text + ellipsis;
}

}  // namespace

double tileScale(int width, int height, double scale) {
  const double part = std::min({width / 640.0, height / 480.0, 1.0});
  return std::max(scale * part, std::min(scale, kLeastScale));
}

Result<ContactSheet> ContactSheet::create(std::size_t frames, int width, int height,
                                          const TextAtlas& atlas) {
  const auto tooLarge = [](const std::string& size) {
    return Error{
        ErrorKind::bad_argument,
        "a contact sheet of " + size + " is too large: ask for fewer moments or a smaller --size",
        {}};
  };
  if (frames == 0) {
    return Error{ErrorKind::bad_argument, "a contact sheet needs at least one moment", {}};
  }
  const auto count = static_cast<std::int64_t>(frames);
  if (count > kSheetMaxPixels) return tooLarge(fmt::format("{} frames", frames));
  std::int64_t columns = 1;
  while (columns * columns < count) ++columns;
  const std::int64_t rows = (count + columns - 1) / columns;
  const std::int64_t sheet_width = columns * (std::int64_t{width} + kSheetGap) + kSheetGap;
  const std::int64_t sheet_height =
      rows * (std::int64_t{height} + atlas.linePixels() + kSheetGap) + kSheetGap;
  if (sheet_width * sheet_height > kSheetMaxPixels) {
    return tooLarge(fmt::format("{}x{} pixels", sheet_width, sheet_height));
  }

  ContactSheet sheet(atlas);
  sheet.frame_width_ = width;
  sheet.frame_height_ = height;
  sheet.columns_ = static_cast<int>(columns);
  sheet.sheet_.width = static_cast<int>(sheet_width);
  sheet.sheet_.height = static_cast<int>(sheet_height);
  sheet.sheet_.rgba.resize(static_cast<std::size_t>(sheet_width * sheet_height) * 4);
  fillSheet(sheet.sheet_, kSheetPaper);
  return sheet;
}

void ContactSheet::put(std::size_t place, const Picture& frame, const std::string& caption) {
  assert(frame.width == frame_width_ && frame.height == frame_height_);
  const int column = static_cast<int>(place) % columns_;
  const int row = static_cast<int>(place) / columns_;
  const int left = kSheetGap + column * (frame_width_ + kSheetGap);
  const int top = kSheetGap + row * (frame_height_ + atlas_->linePixels() + kSheetGap);
  copyOnto(sheet_, frame, left, top);
  const std::string shown = cutToFit(caption, frame.width, *atlas_);
  const TextSize size = atlas_->measure(shown);
  atlas_->drawOn(sheet_, left + (frame.width - size.width) / 2, top + frame.height + 2, shown,
                 kSheetInk);
}

}  // namespace rocinante
