#include "viewer/overlay/overlay.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace rocinante {
namespace {

static_assert(std::endian::native == std::endian::little, "abgr is written as bytes R, G, B, A");

/// Share of the distance by which a line or point is drawn nearer.
constexpr double kLift = 5e-4;
constexpr double kMaxWidthPx = 256;
constexpr std::uint32_t kLabelPlate = 0x14181CC8;
constexpr int kPlatePaddingX = 4;
constexpr int kPlatePaddingY = 2;

std::uint32_t swapped(std::uint32_t rgba) { return __builtin_bswap32(rgba); }

double boundedWidth(double px) {
  return std::isfinite(px) ? std::clamp(px, 0.5, kMaxWidthPx) : 1.0;
}

}  // namespace

TextSize Overlay::measure(const TextAtlas& atlas, std::string_view text) const {
  const TextSize size = atlas.measure(text);
  return {static_cast<int>(std::ceil(size.width / scale_)),
          static_cast<int>(std::ceil(size.height / scale_))};
}

void Overlay::setOwner(std::uint32_t owner) { owned_from_.emplace_back(vertices_.size(), owner); }

std::vector<std::uint32_t> Overlay::owners() const {
  std::vector<std::uint32_t> owners(vertices_.size(), 0);
  for (std::size_t i = 0; i < owned_from_.size(); ++i) {
    const std::size_t until = i + 1 < owned_from_.size() ? owned_from_[i + 1].first : owners.size();
    std::fill(owners.begin() + static_cast<std::ptrdiff_t>(owned_from_[i].first),
              owners.begin() + static_cast<std::ptrdiff_t>(until), owned_from_[i].second);
  }
  return owners;
}

Overlay::ScreenPoint Overlay::toScreen(const Vec4& clip) const {
  return {(clip.x / clip.w + 1) / 2 * width_, (1 - clip.y / clip.w) / 2 * height_, clip.z, clip.w};
}

OverlayVertex Overlay::vertexAt(const ScreenPoint& at, double x, double y, std::uint32_t rgba,
                                OverlayKind kind) const {
  OverlayVertex vertex;
  vertex.clip = glm::vec4((x / width_ * 2 - 1) * at.w, (1 - y / height_ * 2) * at.w, at.z, at.w);
  vertex.abgr = swapped(rgba);
  vertex.kind = kind;
  return vertex;
}

void Overlay::addQuad(const OverlayVertex& a, const OverlayVertex& b, const OverlayVertex& c,
                      const OverlayVertex& d) {
  for (const OverlayVertex* vertex : {&a, &b, &c, &a, &c, &d}) vertices_.push_back(*vertex);
}

Vec4 Overlay::liftedClip(const Vec3& world) const {
  if (camera_.orthographic()) {
    // Use the picture's height, since an orthographic view has no distance.
    return camera_.clipOf(world - camera_.forward() *
                                      (kLift * camera_.metersPerPixel(0) * camera_.height()));
  }
  // Towards the eye: the same pixel, a nearer depth.
  return camera_.clipOf(world + (camera_.eye() - world) * kLift);
}

void Overlay::addSegment(Vec4 from, Vec4 to, std::uint32_t rgba, double width_px) {
  // Clip at the near plane or behind the eye.
  const double near = camera_.orthographic() ? 0.5 : camera_.near();
  if (from.w < near && to.w < near) return;
  if (from.w < near) from += (to - from) * ((near - from.w) / (to.w - from.w));
  if (to.w < near) to += (from - to) * ((near - to.w) / (from.w - to.w));
  const ScreenPoint a = toScreen(from);
  const ScreenPoint b = toScreen(to);
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 1e-6) || !std::isfinite(length)) return;
  const double across_x = -y / length * width_px / 2;
  const double across_y = x / length * width_px / 2;
  addQuad(vertexAt(a, a.x + across_x, a.y + across_y, rgba, OverlayKind::solid),
          vertexAt(b, b.x + across_x, b.y + across_y, rgba, OverlayKind::solid),
          vertexAt(b, b.x - across_x, b.y - across_y, rgba, OverlayKind::solid),
          vertexAt(a, a.x - across_x, a.y - across_y, rgba, OverlayKind::solid));
}

void Overlay::addLine(const std::vector<Vec3>& points, std::uint32_t rgba, double width_px) {
  const double width = boundedWidth(width_px);
  // Discs round off corners of wide lines; on translucent lines they would show as darker dots.
  const bool round = width >= 3 && (rgba & 0xFFU) == 0xFFU;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec4 clip = liftedClip(points[i]);
    if (i + 1 < points.size()) addSegment(clip, liftedClip(points[i + 1]), rgba, width);
    if (round && clip.w >= camera_.near()) addDisc(toScreen(clip), rgba, width);
  }
}

void Overlay::addRibbon(const std::vector<RibbonPoint>& points) {
  const double near = camera_.orthographic() ? 0.5 : camera_.near();
  std::vector<std::pair<Vec4, RibbonPoint>> run;
  const auto flush = [&] {
    addRibbonRun(run);
    run.clear();
  };
  std::optional<std::pair<Vec4, RibbonPoint>> before;
  for (const RibbonPoint& point : points) {
    const Vec4 clip = liftedClip(point.world);
    if (!std::isfinite(clip.x + clip.y + clip.z + clip.w)) {
      flush();
      before.reset();
      continue;
    }
    // Clip at the near plane where it crosses behind the eye.
    if (before && (before->first.w < near) != (clip.w < near)) {
      const double part = (near - before->first.w) / (clip.w - before->first.w);
      run.emplace_back(before->first + (clip - before->first) * part, point);
      if (clip.w < near) flush();
    }
    if (clip.w >= near) run.emplace_back(clip, point);
    before.emplace(clip, point);
  }
  flush();
}

void Overlay::addRibbonRun(const std::vector<std::pair<Vec4, RibbonPoint>>& run) {
  /// Points closer than this give no direction.
  constexpr double kLeastStep = 0.75;
  struct Corner {
    ScreenPoint at;
    const RibbonPoint* point;
  };
  const auto distance = [](const ScreenPoint& a, const ScreenPoint& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  };
  std::vector<Corner> corners;
  for (const auto& [clip, point] : run) {
    const ScreenPoint at = toScreen(clip);
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) continue;
    const bool last = &point == &run.back().second;
    if (!corners.empty() && distance(at, corners.back().at) < (last ? 1e-6 : kLeastStep)) {
      continue;
    }
    corners.push_back({at, &point});
  }
  if (corners.size() < 2) return;

  const auto direction = [&](std::size_t i) {
    const Vec2 step(corners[i + 1].at.x - corners[i].at.x, corners[i + 1].at.y - corners[i].at.y);
    return step / std::sqrt(step.x * step.x + step.y * step.y);
  };
  const auto sideAt = [&](std::size_t i, const Vec2& across) {
    const Corner& corner = corners[i];
    const double half = boundedWidth(corner.point->width_px) / 2;
    return std::pair(
        vertexAt(corner.at, corner.at.x + across.x * half, corner.at.y + across.y * half,
                 corner.point->rgba, OverlayKind::solid),
        vertexAt(corner.at, corner.at.x - across.x * half, corner.at.y - across.y * half,
                 corner.point->rgba, OverlayKind::solid));
  };
  Vec2 along = direction(0);
  auto from = sideAt(0, {-along.y, along.x});
  for (std::size_t i = 1; i < corners.size(); ++i) {
    Vec2 across(-along.y, along.x);
    Vec2 next = along;
    bool sharp = false;
    if (i + 1 < corners.size()) {
      next = direction(i);
      // Sum of both sides' normals: the mitre's length is one over the cosine of half the angle.
      const Vec2 sum = across + Vec2(-next.y, next.x);
      const double squared = sum.x * sum.x + sum.y * sum.y;
      sharp = squared < 1;
      if (!sharp) across = sum * (2 / squared);
    }
    const auto to = sideAt(i, across);
    addQuad(from.first, to.first, to.second, from.second);
    along = next;
    from = sharp ? sideAt(i, {-along.y, along.x}) : to;
  }
}

void Overlay::addDisc(const ScreenPoint& center, std::uint32_t rgba, double size_px) {
  if (!std::isfinite(center.x) || !std::isfinite(center.y)) return;
  // Half a pixel more on each side, where the edge fades.
  const double half = size_px / 2 + 0.5;
  const auto corner = [&](double x, double y) {
    OverlayVertex vertex =
        vertexAt(center, center.x + x * half, center.y + y * half, rgba, OverlayKind::disc);
    // In units of the radius: the edge is at length 1 whatever the size.
    const double reach = half / (size_px / 2);
    vertex.texture = glm::vec2(x * reach, y * reach);
    return vertex;
  };
  addQuad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
}

void Overlay::addPoint(const Vec3& world, std::uint32_t rgba, double size_px) {
  const Vec4 clip = liftedClip(world);
  if (clip.w < camera_.near() && !camera_.orthographic()) return;
  addDisc(toScreen(clip), rgba, boundedWidth(size_px));
}

std::optional<Vec2> Overlay::labelAnchor(const Vec3& world) const {
  const Vec4 clip = camera_.clipOf(world);
  if (clip.w < camera_.near() && !camera_.orthographic()) return std::nullopt;
  const ScreenPoint anchor = toScreen(clip);
  const bool inside = anchor.x >= 0 && anchor.y >= 0 && anchor.x < width_ && anchor.y < height_;
  if (!inside) return std::nullopt;
  return Vec2(anchor.x, anchor.y);
}

void Overlay::addLabel(const TextAtlas& atlas, const Vec3& world, std::uint32_t rgba,
                       std::string_view text) {
  const auto anchor = labelAnchor(world);
  if (!anchor) return;

  constexpr int kPadding = 4;
  const TextSize size = measure(atlas, text);
  // Up and to the right of its point, inside the picture if it fits.
  const int wanted_x = static_cast<int>(std::floor(anchor->x)) + 10;
  const int wanted_y = static_cast<int>(std::floor(anchor->y)) - 10 - size.height;
  const int right = static_cast<int>(width_) - size.width - 2 * kPadding;
  const int bottom = static_cast<int>(height_) - size.height - 2 * kPadding;
  const int x = std::max(std::min(wanted_x, right), kPadding);
  const int y = std::max(std::min(wanted_y, bottom), kPadding);
  const ScreenPoint dot{anchor->x, anchor->y, 0, 1};
  addScreenLine(*anchor, {static_cast<double>(x), static_cast<double>(y + size.height)},
                kLabelPlate, 1.5);
  addScreenRectangle({x - kPadding, y - 2}, {x + size.width + kPadding, y + size.height + 2},
                     kLabelPlate);
  addDisc(dot, (rgba & 0xFFFFFF00U) | 0xFFU, 5);
  addScreenText(atlas, x, y, rgba, text);
}

void Overlay::addLabelAt(const TextAtlas& atlas, const Vec2& anchor,
                         const std::optional<ScreenBox>& plate, std::uint32_t rgba,
                         std::string_view text) {
  const std::uint32_t opaque = (rgba & 0xFFFFFF00U) | 0xFFU;
  if (plate) {
    const double left = plate->left;
    const double top = plate->top;
    const double right = plate->right;
    const double bottom = plate->bottom;
    const Vec2 nearest(std::clamp(anchor.x, left, right), std::clamp(anchor.y, top, bottom));
    addScreenLine(anchor, nearest, kLabelPlate, 1.5);
    addScreenRectangle({left, top}, {right, bottom}, kLabelPlate);
    addScreenText(atlas, plate->left + kPlatePaddingX, plate->top + kPlatePaddingY, rgba, text);
  }
  addDisc({anchor.x, anchor.y, 0, 1}, opaque, 5);
}

void Overlay::addScreenLine(Vec2 from, Vec2 to, std::uint32_t rgba, double width_px) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 1e-6)) return;
  const Vec2 across(-y / length * width_px / 2, x / length * width_px / 2);
  const ScreenPoint front{0, 0, 0, 1};
  const auto corner = [&](const Vec2& at) {
    return vertexAt(front, at.x, at.y, rgba, OverlayKind::solid);
  };
  addQuad(corner(from + across), corner(to + across), corner(to - across), corner(from - across));
}

void Overlay::addScreenRectangle(Vec2 top_left, Vec2 bottom_right, std::uint32_t rgba) {
  const ScreenPoint front{0, 0, 0, 1};
  const auto corner = [&](double x, double y) {
    return vertexAt(front, x, y, rgba, OverlayKind::solid);
  };
  addQuad(corner(top_left.x, top_left.y), corner(bottom_right.x, top_left.y),
          corner(bottom_right.x, bottom_right.y), corner(top_left.x, bottom_right.y));
}

void Overlay::addScreenText(const TextAtlas& atlas, int x, int y, std::uint32_t rgba,
                            std::string_view text) {
  const ScreenPoint front{0, 0, 0, 1};
  // On whole pixels, for sharp text.
  const double left = std::floor(x * scale_ + 0.5);
  const double top = std::floor(y * scale_ + 0.5);
  for (const GlyphQuad& glyph : atlas.layout(text)) {
    const auto corner = [&](int dx, int dy) {
      OverlayVertex vertex = vertexAt(front, (left + glyph.x + dx) / scale_,
                                      (top + glyph.y + dy) / scale_, rgba, OverlayKind::text);
      vertex.texture = {static_cast<float>(glyph.atlas_x + dx),
                        static_cast<float>(glyph.atlas_y + dy)};
      return vertex;
    };
    addQuad(corner(0, 0), corner(glyph.width, 0), corner(glyph.width, glyph.height),
            corner(0, glyph.height));
  }
}

void Overlay::addGnomon(const TextAtlas& atlas) {
  constexpr double kLength = 26;
  constexpr double kInset = 42;
  if (width_ < 200 || height_ < 150) return;
  // Each letter has a plate: in its arrow's colour it would be illegible on wood or sky.
  constexpr double kPlatePx = 17;
  constexpr std::uint32_t kPlate = 0x14181CE6;
  struct Arrow {
    double x, y, depth;
    std::uint32_t rgba, letter_rgba;
    const char* letter;
  };
  const auto arrow = [&](int axis, std::uint32_t rgba, std::uint32_t letter_rgba,
                         const char* letter) {
    return Arrow{camera_.right()[axis] * kLength,
                 -camera_.up()[axis] * kLength,
                 camera_.forward()[axis],
                 rgba,
                 letter_rgba,
                 letter};
  };
  std::array arrows{arrow(0, 0xD8453BFF, 0xFF9C94FF, "x"), arrow(1, 0x4BA046FF, 0x9BE695FF, "y"),
                    arrow(2, 0x3F78D0FF, 0xA9C9FFFF, "z")};
  // The farthest first.
  std::stable_sort(arrows.begin(), arrows.end(),
                   [](const Arrow& a, const Arrow& b) { return a.depth > b.depth; });
  const Vec2 origin(kInset, height_ - kInset);
  for (const Arrow& one : arrows) {
    addScreenLine(origin, origin + Vec2(one.x, one.y), one.rgba, 2.5);
    const TextSize size = measure(atlas, one.letter);
    const Vec2 end = origin + Vec2(one.x, one.y) * 1.32;
    addDisc({end.x, end.y, 0, 1}, kPlate, kPlatePx);
    addScreenText(atlas, static_cast<int>(std::floor(end.x - size.width / 2.0 + 0.5)),
                  static_cast<int>(std::floor(end.y - size.height / 2.0 + 0.5)), one.letter_rgba,
                  one.letter);
  }
}

void Overlay::addScaleBar(const TextAtlas& atlas, const ScaleBar& bar) {
  constexpr double kInset = 12;
  constexpr double kTick = 7;
  constexpr std::uint32_t kBarInk = 0xF2F4F6FF;
  const TextSize size = measure(atlas, bar.text);
  // Whole pixels, for sharp ends.
  const double length = std::floor(bar.pixels + 0.5);
  const double inner = std::max(length, static_cast<double>(size.width));
  const double right = width_ - kInset;
  const double bottom = height_ - kInset;
  const double left = right - inner - 16;
  const double top = bottom - size.height - kTick - 12;
  if (width_ < 200 || height_ < 150) return;
  addScreenRectangle({left, top}, {right, bottom}, kLabelPlate);
  const double bar_left = std::floor(right - 8 - inner / 2 - length / 2);
  const double bar_bottom = bottom - 6;
  addScreenRectangle({bar_left, bar_bottom - 2}, {bar_left + length, bar_bottom}, kBarInk);
  for (const double tick : {bar_left, bar_left + length - 2}) {
    addScreenRectangle({tick, bar_bottom - kTick}, {tick + 2, bar_bottom}, kBarInk);
  }
  addScreenText(atlas, static_cast<int>(std::floor(right - 8 - inner / 2 - size.width / 2.0)),
                static_cast<int>(top) + 3, kBarInk, bar.text);
}

}  // namespace rocinante
