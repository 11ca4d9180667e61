#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/posed_scene.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/report/json_text.h"
#include "core/series/series_scan.h"
#include "viewer/shown/plot_scale.h"

namespace rocinante {

/// The joint values and signals of a session as curves, drawn as the window's plots are. One pass
/// over the log gathers them, a few messages at a time, between which a page continues.
class WebPlots {
 public:
  /// Borrows the cell and the bytes of the log. `chosen`: values by their names (series_key.h),
  /// such as a layout plots.
  WebPlots(const Cell& cell, LogReader log, LogTime start, LogTime end,
           const std::vector<std::string>& chosen);

  /// Reads the next `messages`. Returns the part of the log that is read, 0 to 1.
  Result<double> read(std::uint64_t messages);

  /// JSON: `lanes`, one for each joint, and behind them one for each of the first 256 signals that
  /// were numbers, of that many pixels: name (of a joint, or `signal PATH NAME`), text (its low and
  /// high end with the last unit), curve and bars (paths of SVG), lower and upper (its limits from
  /// the top, where they are in the lane); and `more`, the number of signals without a lane. With
  /// an empty name the chosen values come first, and then the signals of no device.
  /// `device`: null for one that is not in the cell. `state`: of the moment, for its joints.
  std::string lanesJson(const std::string& name, const PosedDevice* device,
                        const SessionState& state, std::size_t width, double height) const;

  /// JSON: the chosen values at that moment by their names, as texts; without those that are not
  /// known then. As precise as curves are, which hold a few thousand values.
  std::string chosenJson(LogTime time) const;

 private:
  struct Chosen {
    std::string name;
    PlotValue value;
  };

  Json laneOf(const SeriesScan& series, const ValueBins* bins, const PlotValue& value,
              std::string_view unit, std::size_t width, double height) const;
  std::vector<ValueColumn> columnsOf(const SeriesScan& series, const ValueBins* bins,
                                     std::size_t count) const;

  LogReader log_;
  LogTime start_, end_;
  std::unique_ptr<SeriesScan> series_;
  std::vector<Chosen> chosen_;
  std::unique_ptr<SeriesScan> chosen_series_;  ///< null: nothing is chosen
  bool ended_ = false;
};

}  // namespace rocinante
