#include "viewer/ui/panels/plot_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/plain_text.h"
#include "viewer/shown/plot_shape.h"
#include "viewer/shown/state_shape.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

void drawGround(const PlotLane& lane, const TimeAxis& axis, LogTime origin) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled(ImVec2(axis.left, lane.top),
                      ImVec2(axis.left + axis.width, lane.top + lane.height),
                      panelColor(PanelColor::plot_ground));
  const Nanoseconds span = axis.until - axis.from;
  const Nanoseconds step = rulerStep(span, static_cast<double>(axis.width), px(64));
  Nanoseconds at = (axis.from - origin) / step * step;
  if (at < axis.from - origin) at += step;
  for (; origin + at <= axis.until; at += step) {
    const float x = axis.xOf(origin + at);
    list->AddLine(ImVec2(x, lane.top), ImVec2(x, lane.top + lane.height), fadedInk(0.08F));
  }
  if (lane.is_states) return;
  // Ticks of the scale, labelled where there is room.
  const float text_px = px(kPlotTextPx);
  float free_below = lane.top + lane.height + text_px;
  const double times = lane.scale.millimetres ? 1000 : 1;
  for (int i = 0; i < 64; ++i) {
    const double value = lane.scale.first + i * lane.scale.step;
    if (value > lane.scale.high) break;
    const float y = lane.yOf(value);
    list->AddLine(ImVec2(axis.left, y), ImVec2(axis.left + axis.width, y), fadedInk(0.1F));
    if (y + text_px / 2 > free_below) continue;
    const double number = value * times;
    const double zeroed = std::abs(number) < lane.scale.step * times * 1e-6 ? 0.0 : number;
    const std::string label = fmt::format("{:.{}f}", zeroed, lane.scale.decimals);
    const float wide = ImGui::GetFont()->CalcTextSizeA(text_px, 1e6F, 0, label.c_str()).x;
    const float at_y = std::clamp(y - text_px / 2, lane.top, lane.top + lane.height - text_px);
    list->AddText(ImGui::GetFont(), text_px, ImVec2(axis.left - wide - px(6), at_y),
                  panelColor(PanelColor::dim_text), label.c_str());
    free_below = at_y - px(2);
  }
  const std::string unit = lane.signal_unit.empty() ? unitText(lane.unit, lane.scale)
                                                    : lane.signal_unit + perText(lane.per_seconds);
  if (!unit.empty()) {
    list->AddText(ImGui::GetFont(), text_px, ImVec2(axis.left - px(54), lane.top),
                  panelColor(PanelColor::dim_text), unit.c_str());
  }
}

/// Where the joint must not be; faint unless it is the one that is looked at.
void drawLimits(const PlotLane& lane, const PlottedCurve& plotted, const TimeAxis& axis,
                bool looked_at) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float left = axis.left, right = axis.left + axis.width;
  const ImU32 line = curveColor(plotted.curve->color, looked_at ? 0.78F : 0.35F);
  const ImU32 band = panelColor(PanelColor::limit_band, looked_at ? 0.2F : 0.055F);
  const PlotValue& value = plotted.value;
  if (value.upper && *value.upper < lane.scale.high) {
    const float y = lane.yOf(*value.upper);
    list->AddRectFilled(ImVec2(left, lane.top), ImVec2(right, y), band);
    list->AddLine(ImVec2(left, y), ImVec2(right, y), line);
  }
  if (value.lower && *value.lower > lane.scale.low) {
    const float y = lane.yOf(*value.lower);
    list->AddRectFilled(ImVec2(left, y), ImVec2(right, lane.top + lane.height), band);
    list->AddLine(ImVec2(left, y), ImVec2(right, y), line);
  }
}

/// How a curve is drawn.
struct CurveLook {
  ImU32 color = 0;
  float width = 1;
};

void drawCurve(const PlotLane& lane, const PlotValue& value,
               const std::vector<ValueColumn>* columns, const StudyPicture& picture,
               const TimeAxis& axis, const CurveLook& look) {
  if (columns == nullptr || columns->empty()) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const PlotShape shape = plotShape(*columns, value, lane.scale, lane.height);
  // The picture may be of another part of the time: it is moved there until there is a newer one.
  const float first = axis.xOf(picture.wish.from);
  const float wide = (axis.xOf(picture.wish.until) - first) / static_cast<float>(columns->size());
  const float bottom = lane.top + lane.height;
  const auto [color, width] = look;
  for (const PlotShape::Bar& bar : shape.bars) {
    const float x = first + bar.x * wide;
    list->AddRectFilled(ImVec2(x, bottom - bar.high - width / 2),
                        ImVec2(x + std::max(wide, 1.0F), bottom - bar.low + width / 2), color);
  }
  std::vector<ImVec2> points;
  for (const auto& line : shape.lines) {
    points.clear();
    for (const PlotShape::Point& point : line) {
      points.emplace_back(first + point.x * wide, bottom - point.y);
    }
    list->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, width);
  }
}

/// The lower and the upper edge of a row of states.
struct RowPlace {
  float top = 0, bottom = 0;
  bool has_texts = false;
};

void drawStateRow(const StateCurve& states, const StudyPicture& picture, const TimeAxis& axis,
                  const RowPlace& row) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const StateShape shape = stateShape(states.columns);
  const float first = axis.xOf(picture.wish.from);
  const float wide =
      (axis.xOf(picture.wish.until) - first) / static_cast<float>(states.columns.size());
  const float text_px = px(kPlotTextPx);
  for (const StateShape::Band& band : shape.bands) {
    const std::string& text = states.texts[band.state];
    const ImU32 color = stateColor(text);
    // What was scrolled out of sight has its text at the left edge still.
    const float left = std::max(first + band.from * wide, axis.left);
    const float right = std::min(first + band.until * wide, axis.left + axis.width);
    if (right <= left) continue;
    // A seam between two bands, where there is room for one.
    const float seam = right - left > px(3) ? px(1) : 0;
    list->AddRectFilled(ImVec2(left, row.top), ImVec2(right - seam, row.bottom), color);
    if (!row.has_texts || right - left < px(22)) continue;
    list->PushClipRect(ImVec2(left, row.top), ImVec2(right - px(3), row.bottom), true);
    list->AddText(ImGui::GetFont(), text_px,
                  ImVec2(left + px(4), (row.top + row.bottom - text_px) / 2), inkOn(color),
                  plainText(text).c_str());
    list->PopClipRect();
  }
  for (const StateShape::Mixed& mixed : shape.mixed) {
    const float left = first + mixed.x * wide;
    const auto count = static_cast<float>(std::popcount(mixed.seen));
    float top = row.top;
    for (std::size_t state = 0; state < states.texts.size(); ++state) {
      if ((mixed.seen >> state & 1U) == 0) continue;
      const float bottom = top + (row.bottom - row.top) / count;
      list->AddRectFilled(ImVec2(left, top), ImVec2(left + std::max(wide, 1.0F), bottom),
                          stateColor(states.texts[state]));
      top = bottom;
    }
  }
}

/// The states of a lane, one row each; those of the session beside at the foot of its row.
void drawStates(const PlotLane& lane, const ViewModel& model, const TimeAxis& axis) {
  float top = lane.top;
  for (const PlottedCurve& plotted : lane.curves) {
    const float bottom = top + plotRowHeight() - px(2);
    if (model.viewer.picture != nullptr) {
      drawStateRow(*plotted.states, *model.viewer.picture, axis, {top, bottom, true});
    }
    if (plotted.states_beside != nullptr && model.viewer.picture_beside != nullptr) {
      drawStateRow(*plotted.states_beside, *model.viewer.picture_beside, axis,
                   {bottom - px(4), bottom, false});
    }
    top += plotRowHeight();
  }
}

}  // namespace

void drawLane(const ViewModel& model, const PlotLane& lane, const TimeAxis& axis,
              const PlotBoard::Curve* looked_at) {
  drawGround(lane, axis, model.origin());
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->PushClipRect(ImVec2(axis.left, lane.top),
                     ImVec2(axis.left + axis.width, lane.top + lane.height), true);
  if (lane.is_states) {
    drawStates(lane, model, axis);
    list->PopClipRect();
    return;
  }
  for (const PlottedCurve& plotted : lane.curves) {
    drawLimits(lane, plotted, axis, lane.curves.size() == 1 || plotted.curve == looked_at);
  }
  // The session beside lies under the shown one, fainter and wider, so that both can be followed.
  for (const PlottedCurve& plotted : lane.curves) {
    if (model.viewer.picture_beside == nullptr) break;
    drawCurve(lane, plotted.value, plotted.beside, *model.viewer.picture_beside, axis,
              {curveColor(plotted.curve->color, 0.43F), px(3.5F)});
  }
  for (const PlottedCurve& plotted : lane.curves) {
    if (model.viewer.picture == nullptr) break;
    drawCurve(lane, plotted.value, plotted.columns, *model.viewer.picture, axis,
              {curveColor(plotted.curve->color), px(plotted.curve == looked_at ? 2.4F : 1.5F)});
  }
  list->PopClipRect();
}

}  // namespace rocinante
