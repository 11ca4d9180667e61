#include "viewer/render/session_drawings.h"

#include <algorithm>

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

}  // namespace

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
               const ViewChoice& choice, const Camera& camera, const TextAtlas& atlas) {
  if (!choice.layerVisible("labels")) return;
  struct Placed {
    Vec3 world;
    double depth;
    const Drawing* drawing;
    std::uint32_t owner;
  };
  std::vector<Placed> labels;
  for (std::uint32_t i = 0; i < drawings.size(); ++i) {
    const PosedDrawing& posed = drawings[i];
    if (posed.drawing->kind != StatementKind::label) continue;
    for (const auto& part : posed.drawing->parts) {
      if (!part) continue;
      forEachPoint(*part, posed.to_world, [&](const Vec3& point) {
        labels.push_back({point, camera.depthOf(point), posed.drawing, i + 1});
      });
    }
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Placed& a, const Placed& b) { return a.depth > b.depth; });
  for (const Placed& label : labels) {
    overlay.setOwner(label.owner);
    overlay.addLabel(atlas, label.world, label.drawing->rgba, label.drawing->text);
  }
}

}  // namespace rocinante
