#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "viewer/shown/plot_scale.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {

/// The height of small texts in plots, in interface units.
inline constexpr float kPlotTextPx = 12;

/// One curve of the frame that is being drawn. Borrowed from the model.
struct PlottedCurve {
  const PlotBoard::Curve* curve = nullptr;
  std::string name{};  ///< as the legend has room for it
  PlotValue value;
  const std::vector<ValueColumn>* columns = nullptr;  ///< null: not known yet
  const std::vector<ValueColumn>* beside = nullptr;   ///< of the session beside; null: none
  /// Of a signal in several units: the one whose numbers these are.
  std::optional<std::string> only_unit{};
  const StateCurve* states = nullptr;         ///< of a lane of states; never null there
  const StateCurve* states_beside = nullptr;  ///< null: none
};

/// Curves of one unit, under each other with the other lanes; or bands of states, one row each.
struct PlotLane {
  bool is_states = false;
  PlotUnit unit{};
  int per_seconds = 0;
  std::string signal_unit{};  ///< of signals, as packets state it; empty: none
  std::vector<PlottedCurve> curves;
  PlotScale scale;
  float top = 0, height = 0;

  float yOf(double shown) const {
    const double part = std::clamp(scale.part(shown), -1.0, 2.0);
    return top + height - static_cast<float>(part) * height;
  }
};

/// The lanes of what is plotted: states, and numbers by unit; not placed yet. A signal without a
/// unit has one of its own, and one in several units is in the lane of each with its numbers there.
std::vector<PlotLane> plotLanes(const ViewModel& model);

/// Places lanes under each other from `top` on, the more curves the higher, and scales them to what
/// is known.
void placeLanes(std::vector<PlotLane>& lanes, float top, float height);

/// The height of a row of states, and of a name in the legend.
float plotRowHeight();

/// The state at a pixel of the axis; null: none.
const std::string* stateAt(const PlottedCurve& plotted, const StudyPicture& picture,
                           const TimeAxis& axis, float x);

/// What a curve has at a pixel of the axis, as shown.
std::optional<double> valueAt(const PlottedCurve& plotted, const StudyPicture& picture,
                              const TimeAxis& axis, float x);

/// The unit of the signal at the shown moment, or of those that a value is derived of, if they have
/// one; empty for anything else.
std::string signalUnit(const ViewModel& model, const SeriesKey& key);
/// The units of a signal in both sessions, or of what is derived of signals; at least one. That of
/// the shown moment until more is known.
std::vector<std::string> signalUnits(const ViewModel& model, const SeriesKey& key);

/// The value of the shown moment itself, which is exact.
std::optional<double> shownValue(const ViewModel& model, const PlottedCurve& plotted);

}  // namespace rocinante
