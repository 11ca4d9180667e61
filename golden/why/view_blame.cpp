#include "golden/why/view_blame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace rocinante {
namespace {

constexpr double kRadians = 0.017453292519943295;
constexpr double kLeastShift_px = 0.05;

/// A part of one side as a separate picture.
struct Crop {
  Picture picture;
  IdentityFrame identity;
  BlameSide side() const { return {picture, identity}; }
};

std::size_t placeIn(const Picture& whole, const PixelRectangle& part, int y) {
  return static_cast<std::size_t>(part.y + y) * static_cast<std::size_t>(whole.width) +
         static_cast<std::size_t>(part.x);
}

Picture cropOf(const Picture& whole, const PixelRectangle& part) {
  const auto row = static_cast<std::size_t>(part.width);
  Picture made{part.width, part.height, {}};
  made.rgba.resize(row * static_cast<std::size_t>(part.height) * 4);
  for (int y = 0; y < part.height; ++y) {
    std::memcpy(made.rgba.data() + static_cast<std::size_t>(y) * row * 4,
                whole.rgba.data() + placeIn(whole, part, y) * 4, row * 4);
  }
  return made;
}

Crop cropOf(const BlameSide& whole, const PixelRectangle& part) {
  Crop made{cropOf(whole.picture, part), {part.width, part.height, {}, whole.identity.names}};
  const auto row = static_cast<std::size_t>(part.width);
  made.identity.ids.resize(row * static_cast<std::size_t>(part.height));
  for (int y = 0; y < part.height; ++y) {
    std::memcpy(made.identity.ids.data() + static_cast<std::size_t>(y) * row,
                whole.identity.ids.data() + placeIn(whole.picture, part, y),
                row * sizeof(std::uint32_t));
  }
  return made;
}

/// Makes a part equal on both sides, without identity.
void blankOut(const PixelRectangle& part, const Picture& golden, Crop& frame) {
  for (int y = 0; y < part.height; ++y) {
    const std::size_t at = placeIn(golden, part, y);
    const auto row = static_cast<std::size_t>(part.width);
    std::memcpy(frame.picture.rgba.data() + at * 4, golden.rgba.data() + at * 4, row * 4);
    std::fill_n(frame.identity.ids.begin() + static_cast<std::ptrdiff_t>(at), row, 0U);
  }
}

/// The main view without the parts covered by insets.
Crop mainView(const Picture& golden, const BlameSide& side, bool is_frame,
              const std::vector<PixelRectangle>& covered) {
  Crop made{side.picture, side.identity};
  for (const PixelRectangle& part : covered) {
    blankOut(part, is_frame ? golden : side.picture, made);
  }
  return made;
}

/// The parts of insets of either side, each once.
std::vector<PixelRectangle> insetParts(const std::vector<PicturedView>& golden,
                                       const std::vector<PicturedView>& frame) {
  std::vector<PixelRectangle> parts;
  for (const auto* views : {&frame, &golden}) {
    for (const PicturedView& view : *views) {
      if (view.is_inset && std::ranges::find(parts, view.part) == parts.end()) {
        parts.push_back(view.part);
      }
    }
  }
  return parts;
}

/// All differing pixels of a part as one change.
Blame wholePart(const Picture& golden, const Picture& frame, const PixelRectangle& part,
                std::string what) {
  const Picture before = cropOf(golden, part), now = cropOf(frame, part);
  Blame made;
  made.mask = {part.width, part.height, std::vector<std::uint8_t>(before.rgba.size(), 255)};
  for (std::size_t i = 0; i < before.rgba.size(); i += 4) {
    const bool differs = std::memcmp(before.rgba.data() + i, now.rgba.data() + i, 4) != 0;
    made.differing += differs ? 1 : 0;
    made.mask.rgba[i] = differs ? 1 : 0;
    made.mask.rgba[i + 1] = made.mask.rgba[i + 2] = 1;
  }
  if (made.differing == 0) {
    for (std::size_t i = 0; i < made.mask.rgba.size(); ++i) {
      if (i % 4 != 3) made.mask.rgba[i] = 0;
    }
    return made;
  }
  LinkChange& change = made.changes.emplace_back();
  change.kind = ChangeKind::camera;
  change.pixels = made.differing;
  change.camera = std::move(what);
  return made;
}

/// Appends a view's result to `all`.
void append(Blame view, const std::string& inset, const PixelRectangle& part, Blame& all) {
  const std::size_t before = all.changes.size();
  all.differing += view.differing;
  for (LinkChange& change : view.changes) {
    change.inset = inset;
    all.changes.push_back(std::move(change));
  }
  for (int y = 0; y < part.height; ++y) {
    const std::size_t to = placeIn(all.mask, part, y) * 4;
    const std::size_t from = static_cast<std::size_t>(y) * static_cast<std::size_t>(part.width) * 4;
    for (std::size_t i = 0; i < static_cast<std::size_t>(part.width) * 4; ++i) {
      const std::uint8_t row = view.mask.rgba[from + i];
      all.mask.rgba[to + i] =
          i % 4 == 3 || row == 0
              ? row
              : static_cast<std::uint8_t>(std::min(row + before, Blame::kMaxRows + 1));
    }
  }
}

/// The same inset of the other side: the one with this camera in this place, else with this camera.
const PicturedView* partnerOf(const PicturedView& inset, const std::vector<PicturedView>& others) {
  const PicturedView* found = nullptr;
  for (const PicturedView& other : others) {
    if (!other.is_inset || other.camera != inset.camera) continue;
    if (other.part == inset.part) return &other;
    if (found == nullptr) found = &other;
  }
  return found;
}

/// Whether the cell alone determines this camera's pose.
bool isFixed(const std::string& camera, const Cell& cell) {
  const CellCamera* const its = cell.findCamera(camera);
  return its != nullptr && its->on_device.empty() && its->follow_device.empty() &&
         its->look_device.empty();
}

Vec3 directionOf(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length = glm::length(way);
  return length > 0 ? way / length : Vec3(0, 0, 0);
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

std::string cameraChange(const CameraView& golden, const CameraView& frame, int height_px) {
  if (golden.ortho_height_m.has_value() != frame.ortho_height_m.has_value()) {
    return "its camera's projection changed";
  }
  const double moved = glm::length(frame.eye - golden.eye);
  const Vec3 before = directionOf(golden.eye, golden.target);
  const Vec3 now = directionOf(frame.eye, frame.target);
  const auto sideOf = [](const Vec3& forward, const CameraView& view) {
    return directionOf({0, 0, 0}, glm::cross(forward, view.up));
  };
  const double turned =
      std::max(angleBetween(before, now), angleBetween(sideOf(before, golden), sideOf(now, frame)));
  const double distance = glm::length(golden.target - golden.eye);
  const double seen_m = golden.ortho_height_m
                            ? *golden.ortho_height_m
                            : 2 * distance * std::tan(golden.fov_deg * kRadians / 2);
  const double metres_a_pixel = seen_m / std::max(1, height_px);
  const double turned_m = turned * std::max(distance, seen_m);
  std::vector<std::string> parts;
  if (moved > kLeastShift_px * metres_a_pixel) {
    parts.push_back(moved < 1 ? fmt::format("moved by {:.3g} mm", moved * 1000)
                              : fmt::format("moved by {:.3f} m", moved));
  }
  if (turned_m > kLeastShift_px * metres_a_pixel) {
    parts.push_back(fmt::format("turned by {:.2g} deg", turned / kRadians));
  }
  const bool zoomed = golden.fov_deg != frame.fov_deg ||
                      golden.ortho_height_m != frame.ortho_height_m ||
                      golden.intrinsics != frame.intrinsics;
  if (zoomed) parts.push_back("sees more or less");
  if (parts.empty()) return "";
  return fmt::format("its camera {}", fmt::join(parts, " and "));
}

Blame blameViews(const BlameSide& golden, const std::vector<PicturedView>& golden_views,
                 const BlameSide& frame, const std::vector<PicturedView>& frame_views,
                 const MovedLinks& moved) {
  const std::vector<PixelRectangle> covered = insetParts(golden_views, frame_views);
  if (covered.empty()) return blameLinks(golden, frame, moved);
  Blame all = blameLinks(mainView(golden.picture, golden, false, covered).side(),
                         mainView(golden.picture, frame, true, covered).side(), moved);
  for (const PixelRectangle& part : covered) {
    // The frame's parts come first, so a common part is found there.
    const auto its = [&](const PicturedView& view) { return view.is_inset && view.part == part; };
    const auto in_frame = std::ranges::find_if(frame_views, its);
    if (in_frame == frame_views.end()) {
      const auto in_golden = std::ranges::find_if(golden_views, its);
      const bool elsewhere = partnerOf(*in_golden, frame_views) != nullptr;
      append(wholePart(golden.picture, frame.picture, part,
                       elsewhere ? "it was moved" : "it is no longer drawn"),
             in_golden->camera, part, all);
      continue;
    }
    const PicturedView* const before = partnerOf(*in_frame, golden_views);
    std::string what = before == nullptr ? "it is new"
                       : before->part != part
                           ? "it was moved"
                           : cameraChange(before->from, in_frame->from, part.height);
    append(what.empty() ? blameLinks(cropOf(golden, part).side(), cropOf(frame, part).side(), moved)
                        : wholePart(golden.picture, frame.picture, part, std::move(what)),
           in_frame->camera, part, all);
  }
  return all;
}

Blame guessViews(const Picture& golden, const BlameSide& frame,
                 const std::vector<PicturedView>& views, const Cell& cell) {
  const std::vector<PixelRectangle> covered = insetParts({}, views);
  if (covered.empty()) return guessBlame(golden, frame);
  Blame all = guessBlame(golden, mainView(golden, frame, true, covered).side());
  for (const PicturedView& view : views) {
    if (!view.is_inset) continue;
    append(isFixed(view.camera, cell)
               ? guessBlame(cropOf(golden, view.part), cropOf(frame, view.part).side())
               : wholePart(golden, frame.picture, view.part, "its earlier camera is unknown"),
           view.camera, view.part, all);
  }
  return all;
}

}  // namespace rocinante
