#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/series/series_key.h"
#include "core/series/value_bins.h"

namespace rocinante {

/// What a lane of plots is measured in.
enum class PlotUnit { degrees, metres, quaternion, other, per_second };

/// A plotted value for people: where its numbers come from and how they are shown.
struct PlotValue {
  SeriesKey
      series;  ///< whose values it shows: of a mimic joint, those of the joint that it follows
  PlotUnit unit = PlotUnit::other;
  int per_seconds = 0;                 ///< 1: of its change in a second
  double factor = 1, offset = 0;       ///< shown = stated * factor + offset
  std::optional<double> lower, upper;  ///< its limits, as shown

  double shown(double stated) const { return stated * factor + offset; }
};

/// `model`: of the key's device; null when it is not known.
PlotValue plotValue(const SeriesKey& key, const Model* model);

/// The same by the models of a scene, also of a derived value, which has the unit of what it is
/// derived of: none for a difference of two units. A joint that follows another has no series that
/// something can be derived of.
PlotValue plotValue(const SeriesKey& key, const PosedScene& scene);

/// Takes the range that a cell expects of a signal for its limits, where it is in the unit that is
/// stated.
void useSignalRange(PlotValue& value, const std::vector<CellSignal>& expected,
                    std::string_view unit);

/// The vertical axis of a lane: a range with a margin, and ticks at round numbers. Values are in
/// the lane's unit.
struct PlotScale {
  double low = -1, high = 1;
  double step = 1;           ///< distance of ticks: 1, 2 or 5 times a power of ten
  double first = -1;         ///< the lowest tick
  int decimals = 0;          ///< that ticks need
  int per_seconds = 0;       ///< of the values
  bool millimetres = false;  ///< metres shown as a thousand times as many millimetres

  /// 0 at the bottom, 1 at the top.
  double part(double value) const { return (value - low) / (high - low); }
};

/// A scale for everything from `low` to `high` with about `ticks` ticks. Never empty: a single
/// value has a range around it, and nothing at all -1 to 1.
PlotScale plotScale(double low, double high, PlotUnit unit, int ticks);

/// "12.5°", "0.120 m", "35.0 mm", "60.1 /s": as precisely as `scale` can be read, and a digit more.
std::string plotText(double shown, PlotUnit unit, const PlotScale& scale);
/// "/s", "/s²" or nothing.
std::string perText(int per_seconds);
/// "°", "m", "mm", "/s", "m/s", "°/s²" or nothing.
std::string unitText(PlotUnit unit, const PlotScale& scale);

/// Widens the range of a curve by its limits, where the curve comes near them.
void includeLimits(const PlotValue& value, double& low, double& high);

/// The range of the columns, as shown by `value`, but for infinite ones; empty without any.
std::optional<std::pair<double, double>> rangeOf(const std::vector<ValueColumn>& columns,
                                                 const PlotValue& value);

}  // namespace rocinante
