#include "viewer/ui/panels/time_axis.h"

#include <algorithm>
#include <cmath>

#include "core/base/duration_text.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/plot/plot_scale.h"

namespace rocinante {
namespace {

constexpr float kScaleRoom = 62;    // for the numbers of a plot's vertical axis
constexpr float kLegendRoom = 210;  // for names and values of curves

/// A picture is as wide as pixels are; a hidden one needs no columns.
std::size_t columnsOf(float width) { return static_cast<std::size_t>(std::max(width, 1.0F)); }

}  // namespace

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
  if (!model.plots.shown()) return 0;
  return std::min(px(kLegendRoom), room * 0.35F);
}

TimeAxis timeAxis(const ViewModel& model, float room) {
  const float beside = px(kPanelMargin) + ImGui::GetStyle().WindowPadding.x;
  const bool plots = model.plots.shown();
  TimeAxis axis;
  axis.left = plots ? px(kPanelMargin + kScaleRoom) : beside;
  axis.width = std::max(
      px(40), room - axis.left - (plots ? px(kPanelMargin) + legendWidth(model, room) : beside));
  axis.from = model.time_view.from();
  axis.until = model.time_view.until();
  return axis;
}

void askStudy(ViewModel& model, const TimeAxis& axis) {
  LogStudy* const study = model.study();
  if (study == nullptr) return;
  StudyWish wish;
  wish.from = axis.from;
  wish.until = axis.until;
  wish.columns = wish.strip_columns = columnsOf(axis.width);
  if (model.plots.shown()) {
    for (const PlotBoard::Curve& curve : model.plots.curves()) {
      const PosedDevice* const device =
          curve.key.isOfDevice() ? model.scene().findDevice(curve.key.name) : nullptr;
      wish.keys.push_back(plotValue(curve.key, device == nullptr ? nullptr : device->model).series);
    }
  }
  model.picture = study->show(wish);
  LogStudy* const study_beside = model.beside_shown ? model.studyBeside() : nullptr;
  model.picture_beside.reset();
  if (study_beside == nullptr) return;
  const EventAlignment& alignment = model.beside()->alignment();
  StudyWish wish_beside = wish;
  wish_beside.from = alignment.inB(wish.from);
  wish_beside.until = alignment.inB(wish.until);
  if (const auto picture = study_beside->show(wish_beside)) {
    model.picture_beside = alignedPicture(*picture, wish, alignment);
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
      model.time_view.pan(-static_cast<double>(io.MouseDelta.x / axis.width));
    }
  }
  if (!ImGui::IsItemHovered()) return;
  if (io.MouseWheel != 0) {
    model.time_view.zoom(std::pow(0.8, static_cast<double>(io.MouseWheel)),
                         axis.momentAt(io.MousePos.x));
  }
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right)) model.time_view.showAll();
}

std::string shownSeconds(Nanoseconds since_origin) {
  return secondsText(std::chrono::floor<std::chrono::milliseconds>(since_origin), 3);
}

}  // namespace rocinante
