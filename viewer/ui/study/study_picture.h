#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/series/series_scan.h"
#include "core/session/event_alignment.h"
#include "viewer/shown/xy_shape.h"

namespace rocinante {

/// What the time line and the plots of a window show.
struct StudyQuery {
  std::vector<SeriesKey> keys;
  LogTime from{}, until{};
  std::size_t columns = 0;        ///< pixels from `from` to `until`, at most 8192
  std::size_t strip_columns = 0;  ///< of the sources' rates, at most 8192
  std::vector<std::pair<SeriesKey, SeriesKey>> paths{};  ///< one over another: of x and of y
  /// Into how many parts paths cut the time.
  static constexpr std::size_t kPathColumns = 4096;
  /// How long a column is, at least 1 ns: the shortest that is asked for.
  Nanoseconds pixel() const {
    const std::size_t most = std::max<std::size_t>(columns, paths.empty() ? 1 : kPathColumns);
    return std::max(Nanoseconds(1), (until - from) / static_cast<std::int64_t>(most));
  }
  /// The values of curves and of paths.
  std::set<SeriesKey> values() const;
  bool operator==(const StudyQuery&) const = default;
};

/// Packets and losses of one source, or of all (with an empty name): by column, per second.
struct SourceStrip {
  std::string source;
  std::vector<float> rates, lost;
  float most = 0;  ///< of `rates` in the whole log, so that zooming changes no height
};

/// A signal's booleans and texts by column. Without columns: it has none.
struct StateCurve {
  std::vector<StateColumn> columns;
  std::vector<std::string> texts;  ///< by state
  bool has_numbers = false;        ///< it was a number too
};

/// A signal's numbers in one unit by column; without columns where it is the only one.
struct UnitCurve {
  std::string unit;  ///< empty: none
  std::vector<ValueColumn> columns;
};
using UnitCurves = std::map<SeriesKey, std::vector<UnitCurve>>;

/// What of some values a table has.
struct TableKeys {
  std::vector<SeriesKey> keys;
  std::string left_out;  ///< the others, as the end of a sentence; or empty
};
/// Without those that packets state as texts alone.
TableKeys tableKeys(const std::vector<SeriesKey>& keys, const SeriesScan& all);

/// What packets state as texts alone.
std::set<SeriesKey> textsOf(const SeriesScan& all);

/// The answer to a wish, ready to be drawn.
struct StudyPicture {
  StudyQuery wish;
  /// By key: the values of joints and poses, and rates as if they were values. Empty for a value
  /// that no packet states.
  std::vector<std::vector<ValueColumn>> curves;
  std::vector<StateCurve> states;   ///< by key
  UnitCurves units;                 ///< of signals, and of what is derived of them alone
  std::vector<XyColumns> paths;     ///< of the wish's
  std::vector<SourceStrip> strips;  ///< all, then by source
  std::vector<std::pair<LogTime, LogTime>> damaged;  ///< packets may be missing there
  /// Every value that packets state; null until all of the log is read, and while it grows.
  std::shared_ptr<const std::vector<SeriesKey>> stated;
  /// Those of them that are texts alone; null as `stated` is.
  std::shared_ptr<const std::set<SeriesKey>> texts;
  LogTime reached{};   ///< known until here
  bool whole = false;  ///< everything is known, as finely as pixels are
  std::string fault;   ///< why the log cannot be read; one sentence, or empty
};

/// True for what is gathered only when it is asked for: there are too many to gather all.
bool isChosen(const SeriesKey& key);
/// Those of a wish.
std::set<SeriesKey> chosenKeys(const StudyQuery& wish);

/// The columns of a wish that a value has, known until `reached`: a curve ends there. Null: none.
std::vector<ValueColumn> columnsUntil(const ValueBins* values, const StudyQuery& wish,
                                      LogTime reached);
/// The units of the signals of a wish in `all` of the log, with their numbers in `shown`, a part of
/// it. What is derived of signals has their unit, or none where that is not the same one in all of
/// the log.
UnitCurves unitsUntil(const StudyQuery& wish, const SeriesScan& all, const SeriesScan& shown,
                      LogTime reached);
StateCurve statesUntil(const StateSeries* states, const StudyQuery& wish, LogTime reached);

/// The curves of a picture of the log beside, at the times of `wish`, which is of the shown log.
std::shared_ptr<const StudyPicture> alignedPicture(const StudyPicture& beside,
                                                   const StudyQuery& wish,
                                                   const EventAlignment& alignment);

}  // namespace rocinante
