#include "golden/compare/picture_mask.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

namespace rocinante {
Result<MaskRectangle> MaskRectangle::parse(std::string_view text) {
  const auto bad = [&] {
    return Error{ErrorKind::bad_argument, "a mask is X,Y,WIDTHxHEIGHT in pixels",
                 std::string(text)};
  };
  std::array<int, 4> numbers{};
  constexpr std::string_view kBetween = ",,x";
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [after, fault] = std::from_chars(at, end, numbers[i]);
    if (fault != std::errc() || numbers[i] < (i < 2 ? 0 : 1)) return bad();
    at = after;
    if (i == kBetween.size()) break;
    if (at == end || *at != kBetween[i]) return bad();
    ++at;
  }
  if (at != end) return bad();
  return MaskRectangle{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::string MaskRectangle::text() const {
  return std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(width) + "x" +
         std::to_string(height);
}

PixelSet pixelsWithIds(std::span<const std::uint32_t> ids, const std::vector<bool>& wanted,
                       int width, int height, int margin) {
  const auto columns = static_cast<std::size_t>(width);
  assert(ids.size() == columns * static_cast<std::size_t>(height) && margin >= 0);
  PixelSet pixels(ids.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t id =
          ids[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
      if (id >= wanted.size() || !wanted[id]) continue;
      const int right = std::min(width - 1, x + margin);
      for (int row = std::max(0, y - margin); row <= std::min(height - 1, y + margin); ++row) {
        std::uint8_t* first = pixels.data() + static_cast<std::size_t>(row) * columns;
        std::fill(first + std::max(0, x - margin), first + right + 1, std::uint8_t{1});
      }
    }
  }
  return pixels;
}

void unite(PixelSet& set, const PixelSet& more) {
  assert(set.size() == more.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] |= more[i];
}

PictureMask::PictureMask(int width, int height)
    : width_(width),
      height_(height),
      hidden_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  assert(width > 0 && height > 0);
}

void PictureMask::hide(const MaskRectangle& rectangle, std::string name) {
  // In 64 bits: a rectangle's corner and size may be any int.
  const auto inside = [](std::int64_t value, int limit) {
    return static_cast<int>(std::clamp<std::int64_t>(value, 0, limit));
  };
  const int left = inside(rectangle.x, width_);
  const int right = inside(std::int64_t{rectangle.x} + rectangle.width, width_);
  const int top = inside(rectangle.y, height_);
  const int bottom = inside(std::int64_t{rectangle.y} + rectangle.height, height_);
  PixelSet pixels(hidden_.size());
  for (int y = top; y < bottom && left < right; ++y) {
    auto* row = pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    std::fill(row + left, row + right, std::uint8_t{1});
  }
  hide(pixels, std::move(name));
}

void PictureMask::hide(const PixelSet& pixels, std::string name) {
  unite(hidden_, pixels);
  parts_.push_back({std::move(name), std::ranges::count(pixels, std::uint8_t{1})});
}

void PictureMask::hideOthers(PixelSet pixels, std::string name) {
  for (std::uint8_t& pixel : pixels) pixel ^= 1U;
  hide(pixels, std::move(name));
}

bool PictureMask::hides(int x, int y) const {
  assert(x >= 0 && x < width_ && y >= 0 && y < height_);
  return hidden_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)] != 0;
}

std::int64_t PictureMask::hiddenPixels() const {
  return std::ranges::count(hidden_, std::uint8_t{1});
}

bool PictureMask::hidesEverything() const {
  return hiddenPixels() == static_cast<std::int64_t>(hidden_.size());
}

Picture PictureMask::applied(const Picture& frame, const Picture& golden) const {
  assert(frame.rgba.size() == hidden_.size() * 4 && golden.rgba.size() == frame.rgba.size());
  Picture judged = frame;
  for (std::size_t i = 0; i < hidden_.size(); ++i) {
    if (hidden_[i] == 0) continue;
    std::copy_n(golden.rgba.begin() + static_cast<std::ptrdiff_t>(i * 4), 4,
                judged.rgba.begin() + static_cast<std::ptrdiff_t>(i * 4));
  }
  return judged;
}

}  // namespace rocinante
