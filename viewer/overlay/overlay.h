#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "viewer/overlay/label_layout.h"
#include "viewer/overlay/scale_bar.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/view/camera.h"

namespace rocinante {

enum class OverlayKind : std::uint32_t { solid = 0, disc = 1, text = 2 };

/// A corner of a triangle whose size is in pixels, already in clip space.
struct OverlayVertex {
  glm::vec4 clip{};
  glm::vec2 texture{};     ///< disc: from -1 to 1; text: atlas pixels
  std::uint32_t abgr = 0;  ///< bytes R, G, B, A in memory
  OverlayKind kind = OverlayKind::solid;
};
static_assert(sizeof(OverlayVertex) == 32);

/// A corner of a line of varying colour and width.
struct RibbonPoint {
  Vec3 world{};
  std::uint32_t rgba = 0xFFFFFFFF;
  double width_px = 1;
};

/// Builds triangles for lines, points and text whose size is in pixels. Plain values, no GL. Pixels
/// are those of scale 1: with `scale` 2 each is two picture pixels wide, and atlases must be made
/// for that scale.
class Overlay {
 public:
  explicit Overlay(const Camera& camera, double scale = 1)
      : camera_(camera),
        scale_(scale),
        width_(camera.width() / scale),
        height_(camera.height() / scale) {}

  double width() const { return width_; }
  double height() const { return height_; }
  double scale() const { return scale_; }
  /// Size of the text in pixels of scale 1, rounded up.
  TextSize measure(const TextAtlas& atlas, std::string_view text) const;

  /// Joins world points by a depth-tested line of `width_px`, slightly nearer so that a line on a
  /// surface shows.
  void addLine(const std::vector<Vec3>& points, std::uint32_t rgba, double width_px);
  void addPoint(const Vec3& world, std::uint32_t rgba, double size_px);
  /// A depth-tested line with mitred corners that does not overlap itself, for translucent colours.
  /// A point that is not finite makes a gap.
  void addRibbon(const std::vector<RibbonPoint>& points);
  /// Text on a plate beside a world point, upright and facing the camera; nothing when the point is
  /// behind the camera.
  void addLabel(const TextAtlas& atlas, const Vec3& world, std::uint32_t rgba,
                std::string_view text);
  /// Anchor of a world point's label in pixels from the top left; empty when the point is not in
  /// the picture.
  std::optional<Vec2> labelAnchor(const Vec3& world) const;
  /// A label on a plate from layOutLabels(), with a line to its point; without a plate, a dot.
  void addLabelAt(const TextAtlas& atlas, const Vec2& anchor, const std::optional<ScreenBox>& plate,
                  std::uint32_t rgba, std::string_view text);

  // In pixels from the top left, over everything.
  void addScreenLine(Vec2 from, Vec2 to, std::uint32_t rgba, double width_px);
  void addScreenRectangle(Vec2 top_left, Vec2 bottom_right, std::uint32_t rgba);
  void addScreenText(const TextAtlas& atlas, int x, int y, std::uint32_t rgba,
                     std::string_view text);
  /// Arrows of the world axes in the bottom left corner, if there is room.
  void addGnomon(const TextAtlas& atlas);
  /// In the bottom right corner, if there is room.
  void addScaleBar(const TextAtlas& atlas, const ScaleBar& bar);

  /// Sets the owner of the following vertices, a number of the caller's; initially 0.
  void setOwner(std::uint32_t owner);

  /// Three per triangle.
  const std::vector<OverlayVertex>& vertices() const { return vertices_; }
  /// By vertex.
  std::vector<std::uint32_t> owners() const;

 private:
  struct ScreenPoint {
    double x = 0, y = 0;  ///< pixels from the top left
    double z = 0, w = 1;  ///< clip space
  };
  ScreenPoint toScreen(const Vec4& clip) const;
  OverlayVertex vertexAt(const ScreenPoint& at, double x, double y, std::uint32_t rgba,
                         OverlayKind kind) const;
  void addSegment(Vec4 from, Vec4 to, std::uint32_t rgba, double width_px);
  void addRibbonRun(const std::vector<std::pair<Vec4, RibbonPoint>>& run);
  void addDisc(const ScreenPoint& center, std::uint32_t rgba, double size_px);
  void addQuad(const OverlayVertex& a, const OverlayVertex& b, const OverlayVertex& c,
               const OverlayVertex& d);
  Vec4 liftedClip(const Vec3& world) const;

  const Camera& camera_;
  double scale_, width_, height_;
  std::vector<OverlayVertex> vertices_;
  std::vector<std::pair<std::size_t, std::uint32_t>> owned_from_;  // first vertex, owner
};

}  // namespace rocinante
