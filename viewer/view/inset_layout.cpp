#include "viewer/view/inset_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "viewer/view/camera_choice.h"

namespace rocinante {
namespace {

/// A side in pixels. A small epsilon is added before truncation: 0.3 of 640 is 192, not 191.
int sideOf(double given, bool in_pixels, int picture, double scale) {
  const double side = in_pixels ? given * scale : given * picture + 1e-6;
  return static_cast<int>(std::floor(std::clamp(side, 0.0, 65536.0)));
}

int marginOf(const CellInset& inset, double scale) {
  return static_cast<int>(std::floor(inset.margin_px * scale + 0.5));
}

}  // namespace

bool isLeft(InsetCorner corner) {
  return corner == InsetCorner::top_left || corner == InsetCorner::bottom_left;
}

bool isTop(InsetCorner corner) {
  return corner == InsetCorner::top_left || corner == InsetCorner::top_right;
}

InsetSize insetSize(const CellInset& inset, int width, int height, double scale) {
  return {sideOf(inset.width, inset.in_pixels, width, scale),
          sideOf(inset.height, inset.in_pixels, height, scale), marginOf(inset, scale)};
}

std::vector<PixelRectangle> placeInsets(const std::vector<CellInset>& insets, int width, int height,
                                        double scale) {
  std::array<int, 4> used{};  // by corner: pixels used from the upper or lower edge
  std::vector<PixelRectangle> placed;
  for (const CellInset& inset : insets) {
    int& taken = used[static_cast<std::size_t>(inset.corner)];
    const auto [wide, high, margin] = insetSize(inset, width, height, scale);
    PixelRectangle part;
    part.width = std::min(wide, width - 2 * margin);
    part.height = std::min(high, height - taken - 2 * margin);
    if (part.width < kLeastInsetSidePx || part.height < kLeastInsetSidePx) {
      placed.emplace_back();
      continue;
    }
    const int from_edge = taken + margin;
    part.x = isLeft(inset.corner) ? margin : width - margin - part.width;
    part.y = isTop(inset.corner) ? from_edge : height - from_edge - part.height;
    taken = from_edge + part.height;
    placed.push_back(part);
  }
  return placed;
}

bool repeatsMainView(const CellInset& inset, std::string_view main_name, const CameraView& main,
                     const PosedScene& scene) {
  if (inset.camera == main_name) return true;
  const auto view = chooseCamera(inset.camera, scene);
  return view.ok() && *view == main;
}

namespace {

constexpr std::array<std::pair<std::string_view, InsetCorner>, 4> kCorners{
    {{":top-right", InsetCorner::top_right},
     {":top-left", InsetCorner::top_left},
     {":bottom-right", InsetCorner::bottom_right},
     {":bottom-left", InsetCorner::bottom_left}}};

std::optional<double> sideNumber(std::string_view text) {
  double value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Takes "WxH" or "WxHpx" with sides that an inset can have.
bool takeSize(std::string_view text, CellInset& inset) {
  const bool in_pixels = text.ends_with("px");
  if (in_pixels) text.remove_suffix(2);
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return false;
  const auto width = sideNumber(text.substr(0, cross));
  const auto height = sideNumber(text.substr(cross + 1));
  const double least = in_pixels ? kLeastInsetSidePx : 0.01;
  const double most = in_pixels ? 16384 : 1;
  for (const auto& side : {width, height}) {
    if (!side || !(*side >= least && *side <= most)) return false;
  }
  inset.width = *width;
  inset.height = *height;
  inset.in_pixels = in_pixels;
  return true;
}

}  // namespace

Result<CellInset> parseInset(std::string_view text) {
  CellInset inset;
  std::string_view name = text;
  const std::size_t last = name.rfind(':');
  if (last != std::string_view::npos && takeSize(name.substr(last + 1), inset)) {
    name = name.substr(0, last);
  }
  for (const auto& [ending, corner] : kCorners) {
    if (!name.ends_with(ending)) continue;
    name.remove_suffix(ending.size());
    inset.corner = corner;
    break;
  }
  if (name.empty()) {
    return Error{
        ErrorKind::bad_argument,
        "`" + std::string(text) + "` is not an inset: use CAMERA or CAMERA:CORNER, as map:top-left",
        {}};
  }
  inset.camera = name;
  return inset;
}

std::string insetTitle(const CellInset& inset) {
  return inset.title.value_or(inset.camera.starts_with('@') ? "free view" : inset.camera);
}

std::string insetText(const CellInset& inset) {
  std::string text = inset.camera;
  for (const auto& [ending, corner] : kCorners) {
    if (corner == inset.corner) text += ending;
  }
  const CellInset usual;
  const bool sized = inset.width != usual.width || inset.height != usual.height || inset.in_pixels;
  if (!sized) return text;
  return text + fmt::format(":{}x{}{}", inset.width, inset.height, inset.in_pixels ? "px" : "");
}

}  // namespace rocinante
