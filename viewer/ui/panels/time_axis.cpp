#include "viewer/ui/panels/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/duration_text.h"
#include "viewer/shown/plot_scale.h"
#include "viewer/ui/model/wall_clock.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kMinute = 60 * kSecond;
constexpr std::int64_t kHour = 60 * kMinute;
constexpr std::int64_t kDay = 24 * kHour;

constexpr float kScaleRoom = 62;  // for the numbers of a plot's vertical axis
// For names and values of curves: what names need, within these and a part of the window.
constexpr float kLegendRoom = 210, kWidestLegend = 360;
constexpr float kLegendBeside = 108;  // a name: its mark, its value, margins

/// A picture is as wide as pixels are; a hidden one needs no columns.
std::size_t columnsOf(float width) { return static_cast<std::size_t>(std::max(width, 1.0F)); }

}  // namespace

Nanoseconds rulerStep(Nanoseconds span, double width_px, double label_px) {
  const double least = static_cast<double>(std::max<std::int64_t>(span.count(), 1)) * label_px /
                       std::max(width_px, 1.0);
  const auto enough = [least](std::int64_t step) { return static_cast<double>(step) >= least; };
  for (std::int64_t power = 1; power < kSecond; power *= 10) {
    for (const std::int64_t factor : {1, 2, 5}) {
      if (enough(factor * power)) return Nanoseconds(factor * power);
    }
  }
  for (const std::int64_t unit : {kSecond, kMinute, kHour}) {
    for (const std::int64_t factor : {1, 2, 5, 10, 15, 30}) {
      if (factor * unit < kDay && enough(factor * unit)) return Nanoseconds(factor * unit);
    }
  }
  std::int64_t days = kDay;
  while (!enough(days) && days < std::numeric_limits<std::int64_t>::max() / 2) days *= 2;
  return Nanoseconds(days);
}

std::string rulerLabel(Nanoseconds since_origin, Nanoseconds step) {
  const std::int64_t count = since_origin.count();
  const std::uint64_t size = count < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(count)
                                       : static_cast<std::uint64_t>(count);
  const char* const sign = count < 0 ? "-" : "";
  const std::uint64_t seconds = size / kSecond;
  int decimals = 0;
  for (std::int64_t unit = kSecond; unit > 1 && step.count() % unit != 0; unit /= 10) ++decimals;
  std::string rest;
  if (decimals > 0)
    rest = fmt::format(".{:09}", size % kSecond).substr(0, 1 + static_cast<std::size_t>(decimals));
  if (seconds < 60) return fmt::format("{}{}{}", sign, seconds, rest);
  if (seconds < 3600) return fmt::format("{}{}:{:02}{}", sign, seconds / 60, seconds % 60, rest);
  return fmt::format("{}{}:{:02}:{:02}{}", sign, seconds / 3600, seconds / 60 % 60, seconds % 60,
                     rest);
}

float TimeAxis::xOf(LogTime moment) const {
  const double part = static_cast<double>((moment - from).count()) /
                      static_cast<double>(std::max<std::int64_t>((until - from).count(), 1));
  return left + static_cast<float>(std::clamp(part, -4.0, 5.0)) * width;
}

LogTime TimeAxis::momentAt(float x) const {
  const double part = std::clamp(static_cast<double>((x - left) / width), 0.0, 1.0);
  return from +
         Nanoseconds(static_cast<std::int64_t>(part * static_cast<double>((until - from).count())));
}

float legendWidth(const ViewModel& model, float room) {
  if (!model.viewer.plots.shown()) return 0;
  float names = 0;
  for (const PlotBoard::Curve& curve : model.viewer.plots.curves()) {
    names = std::max(names, drawnWidth(curve.key.text()));
  }
  const float wanted = std::clamp(names + px(kLegendBeside), px(kLegendRoom), px(kWidestLegend));
  const float most = std::min(std::max(px(kLegendRoom), room * 0.25F), room * 0.35F);
  return std::min(wanted, most);
}

TimeAxis timeAxis(const ViewModel& model, float room) {
  const float beside = ImGui::GetStyle().WindowPadding.x;
  const bool plots = model.viewer.plots.shown();
  TimeAxis axis;
  axis.left = plots ? px(kScaleRoom) : beside;
  axis.width = std::max(px(40), room - axis.left - (plots ? legendWidth(model, room) : beside));
  axis.from = model.viewer.time_view.from();
  axis.until = model.viewer.time_view.until();
  return axis;
}

void askStudy(ViewModel& model, const TimeAxis& axis) {
  LogStudy* const study = model.study();
  if (study == nullptr) return;
  StudyQuery wish;
  wish.from = axis.from;
  wish.until = axis.until;
  wish.columns = wish.strip_columns = columnsOf(axis.width);
  if (model.viewer.plots.shown()) {
    for (const PlotBoard::Curve& curve : model.viewer.plots.curves()) {
      const PosedDevice* const device =
          curve.key.isOfDevice() ? model.scene().findDevice(curve.key.name) : nullptr;
      wish.keys.push_back(plotValue(curve.key, device == nullptr ? nullptr : device->model).series);
    }
    for (const PlotBoard::Path& path : model.viewer.plots.paths()) {
      wish.paths.emplace_back(plotValue(path.x, model.scene()).series,
                              plotValue(path.y, model.scene()).series);
    }
  }
  model.viewer.picture = study->show(wish);
  LogStudy* const study_beside = model.beside_shown ? model.studyBeside() : nullptr;
  model.viewer.picture_beside.reset();
  if (study_beside == nullptr) return;
  const EventAlignment& alignment = model.beside()->alignment();
  StudyQuery wish_beside = wish;
  wish_beside.from = alignment.inB(wish.from);
  wish_beside.until = alignment.inB(wish.until);
  if (const auto picture = study_beside->show(wish_beside)) {
    model.viewer.picture_beside = alignedPicture(*picture, wish, alignment);
  }
}

void applyTimeMouse(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis,
                    SteadyTime now) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    const bool pans = io.KeyShift || ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                      ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    if (!pans && io.KeyCtrl) {
      cursor.setPart(axis.momentAt(io.MouseClickedPos[ImGuiMouseButton_Left].x),
                     axis.momentAt(io.MousePos.x), now);
    } else if (!pans) {
      cursor.seek(axis.momentAt(io.MousePos.x), now);
    } else if (io.MouseDelta.x != 0) {
      model.viewer.time_view.pan(-static_cast<double>(io.MouseDelta.x / axis.width));
    }
  }
  if (!ImGui::IsItemHovered()) return;
  if (io.MouseWheel != 0) {
    model.viewer.time_view.zoom(std::pow(0.8, static_cast<double>(io.MouseWheel)),
                                axis.momentAt(io.MousePos.x));
  }
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right)) model.viewer.time_view.showAll();
}

bool showsClock(const ViewModel& model) {
  return model.viewer.panels.wall_clock && hasWallClock(model.origin());
}

std::string shownSeconds(Nanoseconds since_origin) {
  return secondsText(std::chrono::floor<std::chrono::milliseconds>(since_origin), 3);
}

}  // namespace rocinante
