#include "viewer/ui/panels/plot_lane.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/kinematics/joint_values.h"
#include "core/series/derived_value.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kLaneGap = 6;

/// What a picture has of a value, of its curves or its states; null: not known yet.
template <class Curve>
const Curve* curveOf(const StudyPicture* picture, const std::vector<Curve> StudyPicture::*curves,
                     const SeriesKey& series) {
  if (picture == nullptr) return nullptr;
  const auto& keys = picture->wish.keys;
  const auto found = std::ranges::find(keys, series);
  const auto place = static_cast<std::size_t>(found - keys.begin());
  if (found == keys.end() || place >= (picture->*curves).size()) return nullptr;
  return &(picture->*curves)[place];
}

const std::vector<UnitCurve>* unitsIn(const StudyPicture* picture, const SeriesKey& series) {
  if (picture == nullptr) return nullptr;
  const auto found = picture->units.find(series);
  return found == picture->units.end() ? nullptr : &found->second;
}

/// The numbers of a signal in one unit; null: not known yet, or it has none.
const std::vector<ValueColumn>* columnsIn(const StudyPicture* picture, const SeriesKey& series,
                                          const std::string& unit) {
  const std::vector<UnitCurve>* const units = unitsIn(picture, series);
  if (units == nullptr) return nullptr;
  const auto found = std::ranges::find(*units, unit, &UnitCurve::unit);
  if (found == units->end()) return nullptr;
  return units->size() == 1 ? curveOf(picture, &StudyPicture::curves, series) : &found->columns;
}

const StateCurve* statesOf(const StudyPicture* picture, const SeriesKey& series) {
  const StateCurve* const states = curveOf(picture, &StudyPicture::states, series);
  return states == nullptr || states->columns.empty() ? nullptr : states;
}

/// The column at a pixel of the axis; null: none.
template <class Column>
const Column* columnAt(const std::vector<Column>& columns, const StudyPicture& picture,
                       const TimeAxis& axis, float x) {
  if (columns.empty()) return nullptr;
  const float first = axis.xOf(picture.wish.from);
  const float last = axis.xOf(picture.wish.until);
  const auto count = static_cast<float>(columns.size());
  const float column = (x - first) / std::max(last - first, 1.0F) * count;
  if (column < 0) return nullptr;
  return &columns[std::min(static_cast<std::size_t>(column), columns.size() - 1)];
}

void scaleLane(PlotLane& lane) {
  if (lane.is_states) return;
  double low = 1, high = -1;
  for (const PlottedCurve& plotted : lane.curves) {
    for (const std::vector<ValueColumn>* columns : {plotted.columns, plotted.beside}) {
      const auto range = columns == nullptr ? std::nullopt : rangeOf(*columns, plotted.value);
      if (!range) continue;
      const bool is_first = low > high;
      low = is_first ? range->first : std::min(low, range->first);
      high = is_first ? range->second : std::max(high, range->second);
    }
  }
  for (const PlottedCurve& plotted : lane.curves) {
    if (low <= high) includeLimits(plotted.value, low, high);
  }
  lane.scale = plotScale(low, high, lane.unit, std::max(1, static_cast<int>(lane.height / px(15))));
  // The unit of signals stands beside the lane alone.
  lane.scale.per_seconds = lane.signal_unit.empty() ? lane.per_seconds : 0;
}

bool isOfSignals(const SeriesKey& key) {
  return std::ranges::all_of(statedOf(key), [](const SeriesKey& stated) {
    return stated.kind == SeriesKey::Kind::signal;
  });
}

}  // namespace

std::string signalUnit(const ViewModel& model, const SeriesKey& key) {
  if (!isOfSignals(key)) return {};
  std::optional<std::string> unit;
  for (const SeriesKey& stated : statedOf(key)) {
    const auto* const item = model.state().findSignal(stated.name, {stated.link, stated.part});
    const std::string its = item == nullptr ? std::string() : item->value.unit;
    if (unit && *unit != its) return {};
    unit = its;
  }
  return unit.value_or("");
}

std::vector<std::string> signalUnits(const ViewModel& model, const SeriesKey& key) {
  std::vector<std::string> units;
  for (const StudyPicture* picture :
       {model.viewer.picture.get(), model.viewer.picture_beside.get()}) {
    const std::vector<UnitCurve>* const its = unitsIn(picture, key);
    if (its == nullptr) continue;
    for (const UnitCurve& curve : *its) {
      if (std::ranges::find(units, curve.unit) == units.end()) units.push_back(curve.unit);
    }
  }
  if (units.empty()) units.push_back(signalUnit(model, key));
  return units;
}

std::vector<PlotLane> plotLanes(const ViewModel& model) {
  std::map<std::tuple<PlotUnit, int, std::string>, PlotLane> by_unit;
  PlotLane of_states;
  of_states.is_states = true;
  const StudyPicture* const picture = model.viewer.picture.get();
  const StudyPicture* const beside = model.viewer.picture_beside.get();
  for (const PlotBoard::Curve& curve : model.viewer.plots.curves()) {
    PlottedCurve plotted;
    plotted.curve = &curve;
    plotted.value = plotValue(curve.key, model.scene());
    const SeriesKey& series = plotted.value.series;
    plotted.columns = curveOf(picture, &StudyPicture::curves, series);
    plotted.beside = curveOf(beside, &StudyPicture::curves, series);
    plotted.states = statesOf(picture, series);
    if (plotted.states != nullptr) {
      plotted.states_beside = statesOf(beside, series);
      of_states.curves.push_back(plotted);
      if (!plotted.states->has_numbers) continue;
    }
    const std::vector<std::string> units = signalUnits(model, curve.key);
    for (const std::string& signal_unit : units) {
      PlottedCurve its = plotted;
      if (units.size() > 1) {
        its.only_unit = signal_unit;
        its.columns = columnsIn(picture, series, signal_unit);
        its.beside = columnsIn(beside, series, signal_unit);
      }
      useSignalRange(its.value, model.cell().signals, signal_unit);
      const bool is_alone = isOfSignals(curve.key) && signal_unit.empty();
      PlotLane& lane = by_unit[{its.value.unit, its.value.per_seconds,
                                is_alone ? curve.key.text() : signal_unit}];
      lane.unit = its.value.unit;
      lane.per_seconds = its.value.per_seconds;
      lane.signal_unit = signal_unit;
      lane.curves.push_back(std::move(its));
    }
  }
  std::vector<PlotLane> lanes;
  if (!of_states.curves.empty()) lanes.push_back(std::move(of_states));
  for (auto& [unit, lane] : by_unit) lanes.push_back(std::move(lane));
  return lanes;
}

float plotRowHeight() { return ImGui::GetTextLineHeight() + px(1); }

void placeLanes(std::vector<PlotLane>& lanes, float top, float height) {
  float weights = 0, of_states = 0;
  const auto weight = [](const PlotLane& lane) {
    return 2 + static_cast<float>(std::min<std::size_t>(lane.curves.size(), 8));
  };
  float room = height - px(kLaneGap) * static_cast<float>(lanes.size() - 1);
  for (const PlotLane& lane : lanes) {
    if (!lane.is_states) weights += weight(lane);
  }
  for (const PlotLane& lane : lanes) {
    if (!lane.is_states) continue;
    // Rows that numbers leave no room for are named as more.
    const float most = weights > 0 ? room * 0.6F : room;
    of_states = std::min(static_cast<float>(lane.curves.size()) * plotRowHeight(), most);
  }
  room -= of_states;
  for (PlotLane& lane : lanes) {
    lane.top = top;
    lane.height = lane.is_states ? of_states : std::max(px(12), room * weight(lane) / weights);
    top += lane.height + px(kLaneGap);
    scaleLane(lane);
  }
}

std::optional<double> valueAt(const PlottedCurve& plotted, const StudyPicture& picture,
                              const TimeAxis& axis, float x) {
  if (plotted.columns == nullptr) return std::nullopt;
  const ValueColumn* const column = columnAt(*plotted.columns, picture, axis, x);
  if (column == nullptr || !column->held) return std::nullopt;
  return plotted.value.shown(static_cast<double>(*column->held));
}

const std::string* stateAt(const PlottedCurve& plotted, const StudyPicture& picture,
                           const TimeAxis& axis, float x) {
  const StateColumn* const column = columnAt(plotted.states->columns, picture, axis, x);
  return column == nullptr || !column->held ? nullptr : &plotted.states->texts[*column->held];
}

std::optional<double> shownValue(const ViewModel& model, const PlottedCurve& plotted) {
  const SeriesKey& series = plotted.value.series;
  if (series.kind == SeriesKey::Kind::signal) {
    if (plotted.only_unit && *plotted.only_unit != signalUnit(model, series)) return std::nullopt;
    return signalStated(model.state(), series);
  }
  if (series.kind == SeriesKey::Kind::link) {
    const auto pose =
        poseIn(model.scene(), {series.name, series.link}, {series.frame, series.frame_link});
    const auto part = posePart(series.part);
    if (!pose || !part) return std::nullopt;
    return plotted.value.shown(poseNumbers(*pose)[*part]);
  }
  const DeviceState* const device_state =
      series.isOfDevice() ? model.state().findDevice(series.name) : nullptr;
  if (device_state == nullptr) return std::nullopt;
  if (series.kind == SeriesKey::Kind::pose) {
    const auto part = posePart(series.part);
    if (!device_state->pose || !part) return std::nullopt;
    return plotted.value.shown(poseNumbers(device_state->pose->value.pose)[*part]);
  }
  const PosedDevice* const device = model.scene().findDevice(series.name);
  const auto names = device != nullptr && device->model != nullptr ? positionalNames(*device->model)
                                                                   : std::vector<std::string>();
  const auto stated = jointStated(*device_state, series.part, names);
  if (!stated) return std::nullopt;
  return plotted.value.shown(*stated);
}

}  // namespace rocinante
