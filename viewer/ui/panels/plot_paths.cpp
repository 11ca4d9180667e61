#include "viewer/ui/panels/plot_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/shown/xy_shape.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

constexpr float kPathGap = 8;
constexpr float kBelow = 16;   // for the numbers of the horizontal axis
constexpr float kBeside = 62;  // for those of the vertical one

/// One of the two, as it is shown.
struct PathValue {
  PlotValue value;
  std::string signal_unit;
  PlotScale scale;

  std::string unit() const {
    return signal_unit.empty() ? unitText(value.unit, scale)
                               : signal_unit + perText(value.per_seconds);
  }
};

/// One path of the frame that is being drawn. Borrowed from the model.
struct DrawnPath {
  const PlotBoard::Path* path = nullptr;
  PathValue x, y;
  const XyColumns* columns = nullptr;  ///< null: not known yet
  const XyColumns* beside = nullptr;   ///< of the session beside; null: none
  float left = 0, top = 0, width = 1, height = 1;

  XyAxis across() const { return {x.value, x.scale, width}; }
  XyAxis upwards() const { return {y.value, y.scale, height}; }
  ImVec2 at(double stated_x, double stated_y) const {
    return ImVec2(left + across().place(stated_x), top + height - upwards().place(stated_y));
  }
};

const XyColumns* pathColumnsOf(const StudyPicture* picture, const DrawnPath& path) {
  if (picture == nullptr) return nullptr;
  const auto& wished = picture->wish.paths;
  const auto found = std::ranges::find(wished, std::pair(path.x.value.series, path.y.value.series));
  const auto place = static_cast<std::size_t>(found - wished.begin());
  return place < picture->paths.size() ? &picture->paths[place] : nullptr;
}

std::optional<ValueRange> rangeOfBoth(const PathValue& of, const std::vector<ValueColumn>* own,
                                      const std::vector<ValueColumn>* beside) {
  std::optional<ValueRange> range;
  for (const std::vector<ValueColumn>* columns : {own, beside}) {
    const auto its = columns == nullptr ? std::nullopt : rangeOf(*columns, of.value);
    if (!its) continue;
    if (!range) range = its;
    range = {std::min(range->first, its->first), std::max(range->second, its->second)};
  }
  return range;
}

void scalePath(DrawnPath& path) {
  const XyColumns* const own = path.columns;
  const XyColumns* const beside = path.beside;
  ValueRange nothing{1, -1};
  ValueRange x =
      rangeOfBoth(path.x, own ? &own->x : nullptr, beside ? &beside->x : nullptr).value_or(nothing);
  ValueRange y =
      rangeOfBoth(path.y, own ? &own->y : nullptr, beside ? &beside->y : nullptr).value_or(nothing);
  const bool are_lengths = path.x.value.unit == PlotUnit::metres &&
                           path.y.value.unit == PlotUnit::metres &&
                           path.x.value.per_seconds == path.y.value.per_seconds;
  if (are_lengths && x.first <= x.second && y.first <= y.second) {
    makeEqual(x, y, path.width, path.height);
  }
  const auto scale = [](PathValue& of, const ValueRange& range, int ticks) {
    of.scale = plotScale(range.first, range.second, of.value.unit, std::max(1, ticks));
    of.scale.per_seconds = of.signal_unit.empty() ? of.value.per_seconds : 0;
  };
  scale(path.x, x, static_cast<int>(path.width / px(64)));
  scale(path.y, y, static_cast<int>(path.height / px(20)));
}

PathValue pathValue(const ViewModel& model, const SeriesKey& key) {
  PathValue made;
  made.value = plotValue(key, model.scene());
  const std::vector<std::string> units = signalUnits(model, key);
  made.signal_unit = units.size() == 1 ? units[0] : "several units";
  return made;
}

std::vector<DrawnPath> placedPaths(const ViewModel& model, const TimeAxis& axis,
                                   const PathRoom& room) {
  std::vector<DrawnPath> paths;
  const auto& wanted = model.viewer.plots.paths();
  const float each = axis.width / static_cast<float>(wanted.size());
  for (const PlotBoard::Path& path : wanted) {
    DrawnPath& made = paths.emplace_back();
    made.path = &path;
    made.x = pathValue(model, path.x);
    made.y = pathValue(model, path.y);
    made.columns = pathColumnsOf(model.viewer.picture.get(), made);
    made.beside = pathColumnsOf(model.viewer.picture_beside.get(), made);
    // The scale of the first stands where those of the lanes do.
    const float beside = paths.size() == 1 ? 0 : px(kBeside);
    made.left = axis.left + each * static_cast<float>(paths.size() - 1) + beside;
    made.width = std::max(px(20), each - beside - px(kPathGap));
    made.top = room.top;
    made.height = std::max(px(12), room.height - px(kBelow));
    scalePath(made);
  }
  return paths;
}

std::string tickText(const PlotScale& scale, double value) {
  const double number = value * (scale.millimetres ? 1000 : 1);
  const double step = scale.step * (scale.millimetres ? 1000 : 1);
  return fmt::format("{:.{}f}", std::abs(number) < step * 1e-6 ? 0.0 : number, scale.decimals);
}

void drawPathGround(const DrawnPath& path) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float right = path.left + path.width, bottom = path.top + path.height;
  list->AddRectFilled(ImVec2(path.left, path.top), ImVec2(right, bottom), fadedInk(0.05F));
  ImFont* const font = ImGui::GetFont();
  const float text_px = px(kPlotTextPx);
  const auto widthOf = [&](const std::string& text) {
    return font->CalcTextSizeA(text_px, 1e6F, 0, text.c_str()).x;
  };
  constexpr int kMostTicks = 64;
  const std::string x_unit = path.x.unit(), y_unit = path.y.unit();
  const float unit_left = right - widthOf(x_unit);
  list->AddText(font, text_px, ImVec2(unit_left, bottom + px(2)), fadedInk(0.5F), x_unit.c_str());
  list->AddText(font, text_px, ImVec2(path.left - px(54), path.top), fadedInk(0.5F),
                y_unit.c_str());
  float free_from = path.left - px(20);
  for (int i = 0; i < kMostTicks; ++i) {
    const double value = path.x.scale.first + i * path.x.scale.step;
    if (value > path.x.scale.high) break;
    const float x = path.left + static_cast<float>(path.x.scale.part(value)) * path.width;
    list->AddLine(ImVec2(x, path.top), ImVec2(x, bottom), fadedInk(0.1F));
    const std::string label = tickText(path.x.scale, value);
    const float wide = widthOf(label);
    if (x - wide / 2 < free_from || x + wide / 2 > unit_left - px(4)) continue;
    list->AddText(font, text_px, ImVec2(x - wide / 2, bottom + px(2)), fadedInk(0.7F),
                  label.c_str());
    free_from = x + wide / 2 + px(6);
  }
  float free_below = bottom + text_px;
  for (int i = 0; i < kMostTicks; ++i) {
    const double value = path.y.scale.first + i * path.y.scale.step;
    if (value > path.y.scale.high) break;
    const float y = bottom - static_cast<float>(path.y.scale.part(value)) * path.height;
    list->AddLine(ImVec2(path.left, y), ImVec2(right, y), fadedInk(0.1F));
    if (y + text_px / 2 > free_below) continue;
    const std::string label = tickText(path.y.scale, value);
    const float at = std::clamp(y - text_px / 2, path.top, bottom - text_px);
    list->AddText(font, text_px, ImVec2(path.left - widthOf(label) - px(6), at), fadedInk(0.7F),
                  label.c_str());
    free_below = at - px(2);
  }
}

void drawShape(const DrawnPath& path, const XyColumns& columns, ImU32 color, ImU32 box,
               float width) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const XyShape shape = xyShape(columns, path.across(), path.upwards());
  const float bottom = path.top + path.height;
  for (const XyShape::Box& each : shape.boxes) {
    list->AddRectFilled(ImVec2(path.left + each.left - 0.5F, bottom - each.high - 0.5F),
                        ImVec2(path.left + each.right + 0.5F, bottom - each.low + 0.5F), box);
  }
  std::vector<ImVec2> points;
  for (const auto& line : shape.lines) {
    points.clear();
    for (const PlotShape::Point& point : line) {
      points.emplace_back(path.left + point.x, bottom - point.y);
    }
    if (points.size() == 1) {
      list->AddCircleFilled(points[0], width, color);
    } else {
      list->AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, width);
    }
  }
}

/// As stated: exactly where the state of the shown moment has it, else as the picture does.
std::optional<std::pair<double, double>> pairOf(const ViewModel& model, const DrawnPath& path,
                                                LogTime moment, bool is_shown) {
  const StudyPicture* const picture = model.viewer.picture.get();
  std::optional<std::pair<double, double>> seen;
  if (picture != nullptr && path.columns != nullptr && picture->wish.until > picture->wish.from) {
    const double part = static_cast<double>((moment - picture->wish.from).count()) /
                        static_cast<double>((picture->wish.until - picture->wish.from).count());
    seen = pairAt(*path.columns, part);
  }
  if (!is_shown) return seen;
  const auto stated = [&](const PathValue& of, std::optional<double> drawn) {
    PlottedCurve plotted;
    plotted.value = of.value;
    plotted.value.factor = 1;
    plotted.value.offset = 0;
    const auto exact = shownValue(model, plotted);
    return exact ? exact : drawn;
  };
  const auto x = stated(path.x, seen ? std::optional(seen->first) : std::nullopt);
  const auto y = stated(path.y, seen ? std::optional(seen->second) : std::nullopt);
  return x && y ? std::optional(std::pair(*x, *y)) : std::nullopt;
}

void drawDot(const DrawnPath& path, const std::optional<std::pair<double, double>>& pair,
             float radius, float opacity) {
  if (!pair) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImVec2 at = path.at(pair->first, pair->second);
  list->AddCircleFilled(at, radius, curveColor(path.path->color, opacity));
  list->AddCircle(at, radius, fadedInk(opacity), 0, px(1.2F));
}

}  // namespace

float pathsHeight(const ViewModel& model, float height) {
  const PlotBoard& plots = model.viewer.plots;
  if (plots.paths().empty()) return 0;
  return plots.curves().empty() ? height : height * 0.55F;
}

void drawPaths(ViewModel& model, const TimeAxis& axis, const PathRoom& room, LogTime shown,
               std::optional<LogTime> mouse, float legend_width) {
  if (model.viewer.plots.paths().empty()) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  std::optional<std::pair<SeriesKey, SeriesKey>> removed;
  const float left = axis.left + axis.width + px(8);
  const float right = axis.left + axis.width + legend_width - px(8);
  float y = room.top;
  for (const DrawnPath& path : placedPaths(model, axis, room)) {
    drawPathGround(path);
    list->PushClipRect(ImVec2(path.left, path.top),
                       ImVec2(path.left + path.width, path.top + path.height), true);
    const std::size_t color = path.path->color;
    if (path.beside != nullptr) {
      drawShape(path, *path.beside, curveColor(color, 0.43F), curveColor(color, 0.055F), px(3.5F));
    }
    if (path.columns != nullptr) {
      drawShape(path, *path.columns, curveColor(color), curveColor(color, 0.11F), px(1.5F));
    }
    const auto now = pairOf(model, path, shown, true);
    const auto at_mouse = mouse ? pairOf(model, path, *mouse, false) : std::nullopt;
    drawDot(path, at_mouse, px(3), 0.59F);
    drawDot(path, now, px(4.5F), 1);
    list->PopClipRect();
    // Its name, and both values.
    const std::string name = path.path->text();
    ImGui::SetCursorScreenPos(ImVec2(left, y));
    if (ImGui::InvisibleButton(("path " + name).c_str(),
                               ImVec2(right - left, 2 * plotRowHeight()))) {
      removed.emplace(path.path->y, path.path->x);
    }
    const bool is_over = ImGui::IsItemHovered();
    list->AddRectFilled(ImVec2(left, y + px(4)), ImVec2(left + px(9), y + px(12)),
                        curveColor(color));
    list->AddText(ImVec2(left + px(14), y),
                  panelColor(is_over ? PanelColor::text : PanelColor::dim_text),
                  cutInMiddle(name, right - left - px(14), drawnWidth).c_str());
    const auto& shown_values = mouse ? at_mouse : now;
    const auto text = [](const PathValue& of, double stated) {
      const std::string number = plotText(of.value.shown(stated), of.value.unit, of.scale);
      return of.signal_unit.empty() ? number : number + " " + of.unit();
    };
    const std::string values = shown_values ? text(path.y, shown_values->second) + " over " +
                                                  text(path.x, shown_values->first)
                                            : "-";
    list->AddText(ImVec2(left + px(14), y + plotRowHeight()),
                  panelColor(is_over ? PanelColor::text : PanelColor::dim_text),
                  cutInMiddle(values, right - left - px(14), drawnWidth).c_str());
    if (is_over)
      ImGui::SetTooltip("%s\n%s\nclick: no longer plot it", name.c_str(), values.c_str());
    y += 2 * plotRowHeight() + px(2);
  }
  if (removed) model.viewer.plots.removePath(removed->first, removed->second);
}

}  // namespace rocinante
