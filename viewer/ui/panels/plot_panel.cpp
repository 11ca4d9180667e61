#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "viewer/ui/commands/study_actions.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/plot_drawing.h"
#include "viewer/ui/panels/plot_lane.h"
#include "viewer/ui/panels/plot_parts.h"
#include "viewer/ui/panels/plot_paths.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {
namespace {

constexpr float kSplitter = 7;
constexpr float kValueRoom = 72;   // for a number of the legend
constexpr float kLegendGaps = 20;  // the mark before a name, and what is behind it

/// What is drawn at the mouse and at the playhead.
struct Cursors {
  float shown_x = 0;             ///< of the shown moment
  std::optional<float> mouse_x;  ///< over the plots
};

/// What a curve has at the mouse, or at the shown moment.
std::string legendValue(const ViewModel& model, const PlotLane& lane, const PlottedCurve& plotted,
                        const TimeAxis& axis, const Cursors& cursors) {
  const StudyPicture* const picture = model.viewer.picture.get();
  if (lane.is_states) {
    if (cursors.mouse_x && picture != nullptr) {
      const std::string* const there = stateAt(plotted, *picture, axis, *cursors.mouse_x);
      return there == nullptr ? "-" : plainText(*there);
    }
    return plainText(stateStated(model.state(), plotted.value.series).value_or("-"));
  }
  const auto there = cursors.mouse_x && picture != nullptr
                         ? valueAt(plotted, *picture, axis, *cursors.mouse_x)
                         : shownValue(model, plotted);
  if (there) return plotText(*there, lane.unit, lane.scale);
  const SeriesKey& series = plotted.value.series;
  if (picture != nullptr && (!series.isValue() || series.kind == SeriesKey::Kind::derived)) {
    const auto seen = valueAt(plotted, *picture, axis, cursors.shown_x);
    if (seen) return plotText(*seen, lane.unit, lane.scale);
  }
  return "-";
}

/// Gives all curves the names that the legend has room for.
void nameCurves(ViewModel& model, std::vector<PlotLane>& lanes, float room) {
  const float inner = room - 2 * px(8);
  for (const bool states : {false, true}) {
    std::vector<PlottedCurve*> curves;
    std::vector<std::string> names;
    for (PlotLane& lane : lanes) {
      if (lane.is_states != states) continue;
      for (PlottedCurve& plotted : lane.curves) {
        curves.push_back(&plotted);
        names.push_back(plotted.curve->key.text());
      }
    }
    // Numbers are whole, so that a name has no more room while its value is short for a moment.
    const float values = states ? inner / 2 : px(kValueRoom);
    const std::vector<std::string>& shown =
        model.viewer.panels.short_names.of(states ? "plotted states" : "curves", std::move(names),
                                           inner - values - px(kLegendGaps), drawnWidth);
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i]->name = shown[i];
  }
}

/// Names and values of a lane; returns the curve below the mouse.
const PlotBoard::Curve* drawLegend(const ViewModel& model, const PlotLane& lane,
                                   const TimeAxis& axis, const Cursors& cursors, float room,
                                   std::optional<SeriesKey>& removed) {
  const PlotBoard::Curve* hovered = nullptr;
  const float left = axis.left + axis.width + px(8);
  const float right = axis.left + axis.width + room - px(8);
  const float pitch = plotRowHeight();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  float y = lane.top;
  for (std::size_t i = 0; i < lane.curves.size(); ++i) {
    const PlottedCurve& plotted = lane.curves[i];
    const std::size_t left_over = lane.curves.size() - i;
    if (y + 2 * pitch > lane.top + lane.height && left_over > 1) {
      list->AddText(ImVec2(left, y), panelColor(PanelColor::dim_text),
                    fmt::format("and {} more", left_over).c_str());
      break;
    }
    ImGui::SetCursorScreenPos(ImVec2(left, y));
    // A signal in several units is in several lanes.
    const std::string id = plotted.curve->key.text() + "##" + plotted.only_unit.value_or("");
    if (ImGui::InvisibleButton(id.c_str(), ImVec2(right - left, pitch))) {
      removed = plotted.curve->key;
    }
    const bool over = ImGui::IsItemHovered();
    if (over) hovered = plotted.curve;
    const std::string whole = legendValue(model, lane, plotted, axis, cursors);
    const std::string value =
        lane.is_states ? cutInMiddle(whole, (right - left) / 2, drawnWidth) : whole;
    const ImU32 color = lane.is_states ? stateColor(whole) : curveColor(plotted.curve->color);
    list->AddRectFilled(ImVec2(left, y + px(4)), ImVec2(left + px(9), y + px(12)), color);
    const float value_left = right - drawnWidth(value);
    const ImU32 ink = panelColor(over ? PanelColor::text : PanelColor::dim_text);
    list->AddText(ImVec2(value_left, y), ink, value.c_str());
    const float name_room = value_left - left - px(kLegendGaps);
    list->AddText(ImVec2(left + px(14), y), ink,
                  cutInMiddle(plotted.name, name_room, drawnWidth).c_str());
    if (over) {
      std::string tip = plotted.curve->key.text();
      if (lane.is_states) tip += "\n" + whole;
      if (plotted.columns != nullptr && plotted.columns->empty() && !lane.is_states) {
        tip += "\nno packet of this log states it";
      }
      if (plotted.value.lower && plotted.value.upper) {
        tip +=
            fmt::format("\nlimits {} to {}", plotText(*plotted.value.lower, lane.unit, lane.scale),
                        plotText(*plotted.value.upper, lane.unit, lane.scale));
      }
      ImGui::SetTooltip("%s\nclick: no longer plot it", tip.c_str());
    }
    y += pitch;
  }
  return hovered;
}

void drawUnknown(const StudyPicture& picture, const TimeAxis& axis, float top, float bottom) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  for (const auto& [from, until] : picture.damaged) {
    if (until < axis.from || from > axis.until) continue;
    list->AddRectFilled(ImVec2(axis.xOf(std::max(from, axis.from)), top),
                        ImVec2(axis.xOf(std::min(until, axis.until)) + 1, bottom),
                        panelColor(PanelColor::damage, 0.24F));
  }
}

void drawCursorLines(const TimeAxis& axis, const Cursors& cursors, LogTime origin, float top,
                     float bottom) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  if (cursors.shown_x >= axis.left && cursors.shown_x <= axis.left + axis.width) {
    list->AddLine(ImVec2(cursors.shown_x, top), ImVec2(cursors.shown_x, bottom), fadedInk(0.75F));
  }
  if (!cursors.mouse_x) return;
  list->AddLine(ImVec2(*cursors.mouse_x, top), ImVec2(*cursors.mouse_x, bottom), fadedInk(0.35F));
  const Nanoseconds at = axis.momentAt(*cursors.mouse_x) - origin;
  const std::string label =
      secondsText(std::chrono::floor<std::chrono::milliseconds>(at), 3) + " s";
  const float text_px = px(kPlotTextPx);
  const float wide = ImGui::GetFont()->CalcTextSizeA(text_px, 1e6F, 0, label.c_str()).x;
  const float left = std::min(*cursors.mouse_x + px(5), axis.left + axis.width - wide - px(2));
  list->AddRectFilled(ImVec2(left - px(3), top), ImVec2(left + wide + px(3), top + text_px + px(2)),
                      ImGui::GetColorU32(ImGuiCol_PopupBg));
  list->AddText(ImGui::GetFont(), text_px, ImVec2(left, top), panelColor(PanelColor::text),
                label.c_str());
}

/// The upper edge, by which the plots are made higher.
void drawSplitter(ViewModel& model, float width, float window_height) {
  const ImVec2 corner = ImGui::GetWindowPos();
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("height", ImVec2(width, px(kSplitter)));
  const bool used = ImGui::IsItemActive() || ImGui::IsItemHovered();
  if (used) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  const float middle = corner.x + width / 2;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(middle - px(18), corner.y + px(3)),
                                            ImVec2(middle + px(18), corner.y + px(5)),
                                            fadedInk(used ? 0.7F : 0.25F), px(1));
  if (!ImGui::IsItemActive()) return;
  const float wanted = model.viewer.plots.height - ImGui::GetIO().MouseDelta.y / px(1);
  model.viewer.plots.height =
      std::clamp(wanted, PlotBoard::kLeastHeight, window_height * 0.6F / px(1));
}

/// Beside the splitter, above the names of the curves.
void drawTools(ViewModel& model, const TimeAxis& axis, float room) {
  const ImVec2 corner = ImGui::GetWindowPos();
  const float y = corner.y + px(4);
  const auto word = [&](const char* text, float right, const char* tip) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 at(right - size.x, y);
    ImGui::SetCursorScreenPos(at);
    const bool pressed = ImGui::InvisibleButton(text, size);
    ImGui::GetWindowDrawList()->AddText(
        at, panelColor(ImGui::IsItemHovered() ? PanelColor::text : PanelColor::dim_text), text);
    explain(tip);
    return pressed;
  };
  const float right = axis.left + axis.width + room - px(8);
  if (word("clear", right, "no longer plot anything")) model.viewer.plots.clear();
  if (word("hide", right - px(42), "hide the plots, and keep them (P)"))
    model.viewer.plots.hidden = true;
  if (word("table", right - px(80), "what is seen, as a table (CSV) in the working folder")) {
    const auto stem = std::filesystem::path(model.session()->log().name()).stem().string();
    const auto seconds = [&](LogTime moment) {
      return secondsText(std::chrono::floor<std::chrono::milliseconds>(moment - model.origin()), 3);
    };
    const std::string name =
        fmt::format("curves-{}-{}s-{}s.csv", stem, seconds(axis.from), seconds(axis.until));
    if (Status asked = writePlotted(model, name); !asked)
      model.viewer.panels.complaint = asked.error().text();
  }
}

}  // namespace

void drawPlotDrag(ViewModel& model, float top) {
  PlotBoard& plots = model.viewer.plots;
  if (plots.dragged.empty()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const float above = plots.shown() ? 0 : px(PlotBoard::kLeastHeight);
  const ImVec2 low(0, std::max(0.0F, top - above));
  const ImVec2 end = io.DisplaySize;
  const bool inside = io.MousePos.x >= low.x && io.MousePos.x < end.x && io.MousePos.y >= low.y &&
                      io.MousePos.y < end.y;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    for (const SeriesKey& key : plots.dragged) {
      if (inside) plots.add(key);
    }
    plots.dragged.clear();
    return;
  }
  ImDrawList* const list = ImGui::GetForegroundDrawList();
  list->AddRectFilled(low, end, panelColor(PanelColor::drop_place, inside ? 0.2F : 0.086F), px(4));
  list->AddRect(low, end, panelColor(PanelColor::drop_place, inside ? 1 : 0.55F), px(4), 0,
                px(1.5F));
  std::string text;
  for (const SeriesKey& key : plots.dragged) text += (text.empty() ? "" : "\n") + key.text();
  if (plots.curves().size() >= PlotBoard::kMaxCurves)
    text = "20 curves are plotted: remove one first";
  ImGui::SetTooltip("%s", text.c_str());
}

void drawPlots(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis,
               const PanelRectangle& place, SteadyTime now) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin("plots", nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const float room = legendWidth(model, display.x);
  drawSplitter(model, place.width, display.y);
  drawTools(model, axis, room);
  const float top = place.y + px(22);
  const float whole_height = std::max(px(20), place.height - px(22 + 10));
  const float paths_height = pathsHeight(model, whole_height);
  const float paths_top = top + whole_height - paths_height;
  if (model.viewer.plots.curves().empty()) {  // or everything was cleared just now
    drawPaths(model, axis, {paths_top, paths_height}, cursor.position(now), std::nullopt, room);
    ImGui::End();
    return;
  }
  const float lanes_height = std::max(px(20), whole_height - paths_height - px(6));
  std::vector<PlotLane> lanes = plotLanes(model);
  placeLanes(lanes, top, lanes_height);
  nameCurves(model, lanes, room);

  ImGui::SetCursorScreenPos(ImVec2(axis.left, top));
  ImGui::InvisibleButton("curves", ImVec2(axis.width, lanes_height),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  Cursors cursors;
  cursors.shown_x = axis.xOf(cursor.position(now));
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) cursors.mouse_x = ImGui::GetIO().MousePos.x;
  applyTimeMouse(model, cursor, axis, now);

  ImDrawList* const list = ImGui::GetWindowDrawList();
  std::optional<SeriesKey> removed;
  const PlotBoard::Curve* looked_at = nullptr;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    // One that was a state and a number stands in two lanes.
    ImGui::PushID(static_cast<int>(i));
    const auto* over = drawLegend(model, lanes[i], axis, cursors, room, removed);
    ImGui::PopID();
    if (over != nullptr) looked_at = over;
  }
  for (const PlotLane& lane : lanes) drawLane(model, lane, axis, looked_at);
  if (model.viewer.picture != nullptr)
    drawUnknown(*model.viewer.picture, axis, top, top + lanes_height);
  drawCursorLines(axis, cursors, model.origin(), top, top + lanes_height);
  if (model.viewer.picture != nullptr && !model.viewer.picture->fault.empty()) {
    list->AddText(ImVec2(axis.left + px(6), top + px(4)), panelColor(PanelColor::fault),
                  model.viewer.picture->fault.c_str());
  }
  const auto moment =
      cursors.mouse_x ? std::optional(axis.momentAt(*cursors.mouse_x)) : std::nullopt;
  drawPaths(model, axis, {paths_top, paths_height}, cursor.position(now), moment, room);
  if (removed) model.viewer.plots.remove(*removed);
  ImGui::End();
}

}  // namespace rocinante
