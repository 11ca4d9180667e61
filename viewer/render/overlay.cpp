#include "viewer/render/overlay.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace rocinante {
namespace {

static_assert(std::endian::native == std::endian::little, "abgr is written as bytes R, G, B, A");

/// Part of its distance by which a line or point is drawn nearer.
constexpr double kLift = 5e-4;
constexpr double kMaxWidthPx = 256;
constexpr std::uint32_t kPlate = 0x14181CC8;

std::uint32_t swapped(std::uint32_t rgba) { return __builtin_bswap32(rgba); }

double boundedWidth(double px) {
  return std::isfinite(px) ? std::clamp(px, 0.5, kMaxWidthPx) : 1.0;
}

}  // namespace

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
  return {(clip.x / clip.w + 1) / 2 * camera_.width(), (1 - clip.y / clip.w) / 2 * camera_.height(),
          clip.z, clip.w};
}

OverlayVertex Overlay::vertexAt(const ScreenPoint& at, double x, double y, std::uint32_t rgba,
                                OverlayKind kind) const {
  OverlayVertex vertex;
  vertex.clip = glm::vec4((x / camera_.width() * 2 - 1) * at.w,
                          (1 - y / camera_.height() * 2) * at.w, at.z, at.w);
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
    // The whole picture's height stands in for the distance, which has no meaning here.
    return camera_.clipOf(world - camera_.forward() *
                                      (kLift * camera_.metersPerPixel(0) * camera_.height()));
  }
  // Towards the eye: the same pixel, a nearer depth.
  return camera_.clipOf(world + (camera_.eye() - world) * kLift);
}

void Overlay::addSegment(Vec4 from, Vec4 to, std::uint32_t rgba, double width_px) {
  // Cut off what is nearer than the near plane, or behind the eye.
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
  // Discs round the corners of wide lines; on translucent ones they would show as darker dots.
  const bool round = width >= 3 && (rgba & 0xFFU) == 0xFFU;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec4 clip = liftedClip(points[i]);
    if (i + 1 < points.size()) addSegment(clip, liftedClip(points[i + 1]), rgba, width);
    if (round && clip.w >= camera_.near()) addDisc(toScreen(clip), rgba, width);
  }
}

void Overlay::addDisc(const ScreenPoint& center, std::uint32_t rgba, double size_px) {
  if (!std::isfinite(center.x) || !std::isfinite(center.y)) return;
  // Half a pixel more on each side, over which the edge fades.
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

void Overlay::addLabel(const TextAtlas& atlas, const Vec3& world, std::uint32_t rgba,
                       std::string_view text) {
  const Vec4 clip = camera_.clipOf(world);
  if (clip.w < camera_.near() && !camera_.orthographic()) return;
  const ScreenPoint anchor = toScreen(clip);
  const double w = camera_.width();
  const double h = camera_.height();
  if (!(anchor.x >= 0 && anchor.y >= 0 && anchor.x < w && anchor.y < h)) return;

  constexpr int kPadding = 4;
  const TextSize size = atlas.measure(text);
  // Up and to the right of its point, but inside of the picture where it fits.
  const int wanted_x = static_cast<int>(std::floor(anchor.x)) + 10;
  const int wanted_y = static_cast<int>(std::floor(anchor.y)) - 10 - size.height;
  const int x = std::max(std::min(wanted_x, camera_.width() - size.width - 2 * kPadding), kPadding);
  const int y =
      std::max(std::min(wanted_y, camera_.height() - size.height - 2 * kPadding), kPadding);
  const ScreenPoint front{0, 0, 0, 1};
  const ScreenPoint dot{anchor.x, anchor.y, front.z, front.w};
  addScreenLine({anchor.x, anchor.y},
                {static_cast<double>(x), static_cast<double>(y + size.height)}, kPlate, 1.5);
  addScreenRectangle({x - kPadding, y - 2}, {x + size.width + kPadding, y + size.height + 2},
                     kPlate);
  addDisc(dot, (rgba & 0xFFFFFF00U) | 0xFFU, 5);
  addScreenText(atlas, x, y, rgba, text);
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
  for (const GlyphQuad& glyph : atlas.layout(text)) {
    const auto corner = [&](int dx, int dy) {
      OverlayVertex vertex =
          vertexAt(front, x + glyph.x + dx, y + glyph.y + dy, rgba, OverlayKind::text);
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
  if (camera_.width() < 200 || camera_.height() < 150) return;
  struct Arrow {
    double x, y, depth;
    std::uint32_t rgba;
    const char* letter;
  };
  const auto arrow = [&](int axis, std::uint32_t rgba, const char* letter) {
    return Arrow{camera_.right()[axis] * kLength, -camera_.up()[axis] * kLength,
                 camera_.forward()[axis], rgba, letter};
  };
  std::array arrows{arrow(0, 0xD8453BFF, "x"), arrow(1, 0x4BA046FF, "y"),
                    arrow(2, 0x3F78D0FF, "z")};
  // The farthest first.
  std::stable_sort(arrows.begin(), arrows.end(),
                   [](const Arrow& a, const Arrow& b) { return a.depth > b.depth; });
  const Vec2 origin(kInset, camera_.height() - kInset);
  for (const Arrow& one : arrows) {
    addScreenLine(origin, origin + Vec2(one.x, one.y), one.rgba, 2.5);
    const TextSize size = atlas.measure(one.letter);
    const Vec2 end = origin + Vec2(one.x, one.y) * 1.32;
    addScreenText(atlas, static_cast<int>(std::floor(end.x - size.width / 2.0 + 0.5)),
                  static_cast<int>(std::floor(end.y - size.height / 2.0 + 0.5)), one.rgba,
                  one.letter);
  }
}

}  // namespace rocinante
