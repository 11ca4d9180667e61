#pragma once

#include <string>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Distance of the ticks of a time line that shows `span` on `width_px`, so that labels of that
/// width do not touch: 1, 2 or 5 times a power of ten below a second, then 1, 2, 5, 10, 15 or 30
/// seconds, minutes or hours below a day, then days by powers of two. Pure.
Nanoseconds rulerStep(Nanoseconds span, double width_px, double label_px);

/// "12.5", "1:05", "-0.5", "2:00:00": the label of a tick, with the decimals that the step needs.
std::string rulerLabel(Nanoseconds since_origin, Nanoseconds step);

/// Where the shown part of a log's time lies in the window: the time line and the plots above it
/// share it. In pixels.
struct TimeAxis {
  float left = 0, width = 1;
  LogTime from{}, until{};

  /// May be outside of the axis.
  float xOf(LogTime moment) const;
  /// Of the nearest moment of the axis.
  LogTime momentAt(float x) const;
  bool shows(LogTime moment) const { return moment >= from && moment <= until; }
};

/// `room`: width of the window in pixels.
TimeAxis timeAxis(const ViewModel& model, float room);

/// Room beside the axis, right of it, for the names of curves; 0 without plots.
float legendWidth(const ViewModel& model, float room);

/// Asks the log's study for what this axis shows, into model.viewer.picture.
void askStudy(ViewModel& model, const TimeAxis& axis);

/// Applies the mouse of the last item, drawn over the axis: left seeks, with Ctrl it chooses the
/// part that is repeated; right, middle or Shift moves the axis, the wheel zooms at the mouse, a
/// double click of the right button shows all.
void applyTimeMouse(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis, SteadyTime now);

/// Whether the time of day is shown beside that of the session: it is wanted, and there is one.
bool showsClock(const ViewModel& model);

/// A session time as the time line writes it: seconds with three decimals.
std::string shownSeconds(Nanoseconds since_origin);

}  // namespace rocinante
