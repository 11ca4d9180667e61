#include "viewer/overlay/session_drawings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/transform.h"

namespace rocinante {
namespace {

/// Calls each(world point) for a part's triples.
template <class Each>
void forEachPoint(const std::vector<double>& numbers, const Mat4& to_world, const Each& each) {
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    each(transformPoint(to_world, {numbers[i], numbers[i + 1], numbers[i + 2]}));
  }
}

void addPolyline(Overlay& overlay, const PosedDrawing& posed) {
  const Drawing& drawing = *posed.drawing;
  std::vector<Vec3> points;
  const auto flush = [&] {
    overlay.addLine(points, drawing.rgba, drawing.size_px);
    points.clear();
  };
  for (const auto& part : drawing.parts) {
    if (!part) {
      flush();
      continue;
    }
    forEachPoint(*part, posed.to_world, [&](const Vec3& point) { points.push_back(point); });
  }
  flush();
}

struct PlacedLabel {
  Vec3 world;
  double depth;
  const Drawing* drawing;
  std::uint32_t owner;
};

/// `labels`: the farthest first.
void addLabelsApart(Overlay& overlay, const std::vector<PlacedLabel>& labels,
                    const TextAtlas& atlas) {
  std::vector<const PlacedLabel*> seen;
  std::vector<LabelAnchor> anchors;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
    const auto anchor = overlay.labelAnchor(label->world);
    if (!anchor) continue;
    seen.push_back(&*label);
    anchors.push_back({anchor->x, anchor->y, overlay.measure(atlas, label->drawing->text)});
  }
  // The corners of gnomon and scale bar.
  const int w = static_cast<int>(overlay.width());
  const int h = static_cast<int>(overlay.height());
  const std::vector<ScreenBox> taken{{0, h - 84, 84, h}, {w - 200, h - 50, w, h}};
  const auto plates = layOutLabels(anchors, taken, w, h);
  // Dots before plates, so that no dot covers a text.
  for (const bool placed : {false, true}) {
    for (std::size_t i = seen.size(); i-- > 0;) {
      if (plates[i].has_value() != placed) continue;
      overlay.setOwner(seen[i]->owner);
      overlay.addLabelAt(atlas, {anchors[i].x, anchors[i].y}, plates[i], seen[i]->drawing->rgba,
                         seen[i]->drawing->text);
    }
  }
}

/// Distinct colours, visible on light and dark backgrounds.
constexpr std::array<std::uint32_t, 6> kTrailColors{0xF0641EFF, 0x1C86EEFF, 0x2FA84FFF,
                                                    0xB03AC8FF, 0xE0A800FF, 0x10A5A5FF};
constexpr double kTrailWidthPx = 3.5;

}  // namespace

void addTrails(Overlay& overlay, const std::vector<Trail>& trails) {
  for (std::size_t i = 0; i < trails.size(); ++i) {
    const std::uint32_t color = kTrailColors[i % kTrailColors.size()];
    for (const std::vector<Trail::Point>& run : trails[i].runs) {
      std::vector<RibbonPoint> points;
      for (const Trail::Point& point : run) {
        const auto alpha = static_cast<std::uint32_t>(point.fresh * 235.0F);
        points.push_back(
            {point.at, (color & 0xFFFFFF00U) | alpha, kTrailWidthPx * (0.4 + 0.6 * point.fresh)});
      }
      overlay.addRibbon(points);
    }
  }
}

void addLinesAndPoints(Overlay& overlay, const std::vector<PosedDrawing>& drawings,
                       const ViewChoice& choice) {
  const bool lines = choice.layerVisible("lines");
  const bool points = choice.layerVisible("points");
  for (std::uint32_t i = 0; i < drawings.size(); ++i) {
    const PosedDrawing& posed = drawings[i];
    const Drawing& drawing = *posed.drawing;
    overlay.setOwner(i + 1);
    if (drawing.kind == StatementKind::line && lines) {
      addPolyline(overlay, posed);
    } else if (drawing.kind == StatementKind::points && points) {
      for (const auto& part : drawing.parts) {
        if (!part) continue;
        forEachPoint(*part, posed.to_world, [&](const Vec3& point) {
          overlay.addPoint(point, drawing.rgba, drawing.size_px);
        });
      }
    }
  }
}

void addLabels(Overlay& overlay, const std::vector<PosedDrawing>& drawings,
               const ViewChoice& choice, const Camera& camera, const TextAtlas& atlas,
               LabelStyle style) {
  if (!choice.layerVisible("labels")) return;
  std::vector<PlacedLabel> labels;
  for (std::uint32_t i = 0; i < drawings.size(); ++i) {
    const PosedDrawing& posed = drawings[i];
    if (posed.drawing->kind != StatementKind::label) continue;
    for (const auto& part : posed.drawing->parts) {
      if (!part) continue;
      forEachPoint(*part, posed.to_world, [&](const Vec3& point) {
        // NaN has no order.
        const double depth = camera.depthOf(point);
        if (std::isfinite(depth)) labels.push_back({point, depth, posed.drawing, i + 1});
      });
    }
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const PlacedLabel& a, const PlacedLabel& b) { return a.depth > b.depth; });
  if (style == LabelStyle::apart) {
    addLabelsApart(overlay, labels, atlas);
    return;
  }
  for (const PlacedLabel& label : labels) {
    overlay.setOwner(label.owner);
    overlay.addLabel(atlas, label.world, label.drawing->rgba, label.drawing->text);
  }
}

}  // namespace rocinante
