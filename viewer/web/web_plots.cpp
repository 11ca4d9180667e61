#include "viewer/web/web_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/cell/posed_scene.h"
#include "core/report/json_text.h"
#include "core/series/positional_names.h"
#include "viewer/shown/joint_rows.h"
#include "viewer/shown/plot_scale.h"
#include "viewer/shown/plot_shape.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxColumns = 8192;
/// Lanes of them; a list names all that there are.
constexpr std::size_t kMaxSignals = 256;

SeriesScan::Options optionsOf(const Cell& cell, LogTime start, LogTime end) {
  SeriesScan::Options options;
  options.from = start;
  options.until = end;
  options.names = positionalNames(cell);
  options.states = false;
  return options;
}

std::string curvePath(const PlotShape& shape, double height) {
  std::string path;
  for (const auto& line : shape.lines) {
    char pen = 'M';
    for (const PlotShape::Point& point : line) {
      path += fmt::format("{}{:.1f} {:.1f}", pen, point.x, height - point.y);
      pen = 'L';
    }
  }
  return path;
}

std::string barsPath(const PlotShape& shape, double height) {
  std::string path;
  for (const PlotShape::Bar& bar : shape.bars) {
    path += fmt::format("M{:.1f} {:.1f}V{:.1f}", bar.x + 0.5F, height - bar.high, height - bar.low);
  }
  return path;
}

Json placeOf(const std::optional<double>& limit, const PlotScale& scale, double height) {
  if (!limit) return nullptr;
  const double part = scale.part(*limit);
  if (!(part >= 0 && part <= 1)) return nullptr;
  return height - part * height;
}

Json laneJson(const PlotValue& value, std::string_view unit,
              const std::vector<ValueColumn>& columns, double height) {
  const auto range = rangeOf(columns, value);
  double low = range ? range->first : 1;
  double high = range ? range->second : -1;
  if (range) includeLimits(value, low, high);
  const PlotScale scale = plotScale(low, high, value.unit, 2);
  const PlotShape shape = plotShape(columns, value, scale, static_cast<float>(height));
  Json lane;
  if (range) {
    lane["text"] =
        fmt::format("{} to {}{}{}", plotText(range->first, value.unit, scale),
                    plotText(range->second, value.unit, scale), unit.empty() ? "" : " ", unit);
  }
  lane["curve"] = curvePath(shape, height);
  lane["bars"] = barsPath(shape, height);
  lane["lower"] = placeOf(value.lower, scale, height);
  lane["upper"] = placeOf(value.upper, scale, height);
  return lane;
}

}  // namespace

WebPlots::WebPlots(const Cell& cell, LogReader log, LogTime start, LogTime end,
                   const std::vector<std::string>& chosen)
    : log_(std::move(log)),
      start_(start),
      end_(end),
      series_(std::make_unique<SeriesScan>(optionsOf(cell, start, end))) {
  if (chosen.empty()) return;
  const SessionState empty_state;
  const PosedScene scene = poseScene(cell, empty_state);
  // Links and what is derived are gathered only when they are asked for.
  SeriesScan::Options options = optionsOf(cell, start, end);
  options.cell = &cell;
  options.only.emplace();
  for (const std::string& name : chosen) {
    const auto key = parseSeriesKey(name);
    if (!key) continue;
    chosen_.push_back({name, plotValue(*key, scene)});
    options.only->insert(chosen_.back().value.series);
  }
  chosen_series_ = std::make_unique<SeriesScan>(std::move(options));
}

Result<double> WebPlots::read(std::uint64_t messages) {
  for (std::uint64_t i = 0; i < messages && !ended_; ++i) {
    const auto message = log_.next();
    if (!message) return message.error();
    ended_ = !*message;
    if (ended_) break;
    series_->add(**message);
    if (chosen_series_) chosen_series_->add(**message);
  }
  if (ended_ || end_ <= start_) return 1.0;
  const double part = static_cast<double>((series_->reached() - start_).count()) /
                      static_cast<double>((end_ - start_).count());
  return std::clamp(part, 0.0, 0.999);
}

std::vector<ValueColumn> WebPlots::columnsOf(const SeriesScan& series, const ValueBins* bins,
                                             std::size_t count) const {
  std::vector<ValueColumn> columns;
  if (bins != nullptr) columns = bins->columns(start_, end_, count);
  // Nothing is known behind what was read: a curve ends there.
  for (std::size_t i = 0; !ended_ && i < columns.size(); ++i) {
    const Nanoseconds since =
        (end_ - start_) / static_cast<std::int64_t>(count) * static_cast<std::int64_t>(i);
    if (start_ + since > series.reached()) columns[i].held.reset();
  }
  return columns;
}

Json WebPlots::laneOf(const SeriesScan& series, const ValueBins* bins, const PlotValue& value,
                      std::string_view unit, std::size_t width, double height) const {
  const std::size_t count = std::clamp<std::size_t>(width, 1, kMaxColumns);
  return laneJson(value, unit, columnsOf(series, bins, count), height);
}

std::string WebPlots::chosenJson(LogTime time) const {
  Json values = Json::object();
  for (const Chosen& one : chosen_) {
    if (!ended_ && time > chosen_series_->reached()) continue;
    std::vector<UnitSeries> units = chosen_series_->unitsOf(one.value.series);
    if (units.empty()) units.push_back({{}, chosen_series_->values(one.value.series)});
    // Of several units one has this moment.
    const ValueBins* bins = nullptr;
    std::string_view unit;
    decltype(ValueColumn::held) held;
    for (const UnitSeries& of : units) {
      if (of.values == nullptr || held) continue;
      bins = of.values;
      unit = of.unit;
      held = bins->columns(time, time + Nanoseconds(1), 1).front().held;
    }
    if (!held) continue;
    const auto columns = columnsOf(*chosen_series_, bins, 64);
    const auto range = rangeOf(columns, one.value);
    if (!range) continue;
    const PlotScale scale = plotScale(range->first, range->second, one.value.unit, 2);
    std::string text = plotText(one.value.shown(static_cast<double>(*held)), one.value.unit, scale);
    if (!unit.empty()) text.append(" ").append(unit);
    values[one.name] = std::move(text);
  }
  return values.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string WebPlots::lanesJson(const std::string& name, const PosedDevice* device,
                                const SessionState& state, std::size_t width, double height) const {
  Json lanes = Json::array();
  const auto add = [&](Json lane, std::string of) {
    lane["name"] = std::move(of);
    lanes.push_back(std::move(lane));
  };
  const auto addUnits = [&](const SeriesScan& series, const PlotValue& value,
                            const std::string& of) {
    const std::vector<UnitSeries> units = series.unitsOf(value.series);
    if (units.empty()) {
      add(laneOf(series, series.values(value.series), value, {}, width, height), of);
    }
    for (const auto& [unit, values] : units) {
      Json lane = laneOf(series, values, value, unit, width, height);
      if (units.size() > 1) lane["unit"] = unit;
      add(std::move(lane), of);
    }
  };
  if (name.empty()) {
    for (const Chosen& one : chosen_) addUnits(*chosen_series_, one.value, one.name);
  }
  const auto isChosen = [&](const SeriesKey& key) {
    return std::ranges::any_of(chosen_, [&](const Chosen& one) { return one.value.series == key; });
  };
  if (device != nullptr) {
    for (const JointRow& row : jointRows(*device->model, state.findDevice(name), "")) {
      const PlotValue value = plotValue({SeriesKey::Kind::joint, name, row.name}, device->model);
      add(laneOf(*series_, series_->values(value.series), value, {}, width, height), row.name);
    }
  }
  std::vector<SeriesKey> signals = series_->keys();
  std::erase_if(signals, [&](const SeriesKey& key) {
    return key.kind != SeriesKey::Kind::signal || key.name != name ||
           (name.empty() && isChosen(key));
  });
  // As they are listed: those of the device itself first.
  std::sort(signals.begin(), signals.end(), [](const SeriesKey& a, const SeriesKey& b) {
    return std::tie(a.link, a.part) < std::tie(b.link, b.part);
  });
  const std::size_t more = signals.size() - std::min(signals.size(), kMaxSignals);
  signals.resize(signals.size() - more);
  for (const SeriesKey& key : signals) {
    addUnits(*series_, plotValue(key, nullptr), key.text());
  }
  const Json json = {{"lanes", std::move(lanes)}, {"more", more}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
