#include "viewer/ui/study/study_picture.h"

#include <algorithm>
#include <optional>

#include "core/series/derived_value.h"

namespace rocinante {
namespace {

template <class Bin>
std::vector<BinColumn<Bin>> columnsOf(const TimeBins<Bin>* bins, const StudyQuery& wish,
                                      LogTime reached) {
  if (bins == nullptr) return {};
  auto columns = bins->columns(wish.from, wish.until, wish.columns);
  if (wish.until <= reached) return columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto at = static_cast<std::int64_t>(i);
    if (wish.from + (wish.until - wish.from) / static_cast<std::int64_t>(columns.size()) * at >
        reached) {
      columns[i].held.reset();
    }
  }
  return columns;
}

/// Columns of the log beside, at the times of the shown one.
struct Mapping {
  const StudyQuery& there;
  const StudyQuery& here;
  const EventAlignment& alignment;

  template <class Column>
  std::vector<Column> of(const std::vector<Column>& curve) const {
    const Nanoseconds known = there.until - there.from;
    if (curve.empty() || known.count() <= 0) return {};
    std::vector<Column> columns(here.columns);
    const double count = static_cast<double>(curve.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      // The middle of the column.
      const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(columns.size());
      const Nanoseconds since(
          static_cast<std::int64_t>(part * static_cast<double>((here.until - here.from).count())));
      const LogTime at = alignment.inB(here.from + since);
      const double place = static_cast<double>((at - there.from).count()) /
                           static_cast<double>(known.count()) * count;
      if (place >= 0 && place < count) columns[i] = curve[static_cast<std::size_t>(place)];
    }
    return columns;
  }
};

/// The unit that all of the signals have in all of the log, or none; empty where one is no signal
/// with numbers.
std::optional<std::string> unitOfAll(const std::vector<SeriesKey>& signals, const SeriesScan& all) {
  std::optional<std::string> common;
  for (const SeriesKey& key : signals) {
    const auto units = all.unitsOf(key);
    if (units.empty()) return std::nullopt;
    const std::string its(units.size() == 1 ? units[0].unit : std::string_view());
    if (!common) common = its;
    if (*common != its) common->clear();
  }
  return common;
}

}  // namespace

bool isChosen(const SeriesKey& key) {
  return key.kind == SeriesKey::Kind::link || key.kind == SeriesKey::Kind::derived;
}

std::set<SeriesKey> chosenKeys(const StudyQuery& wish) {
  std::set<SeriesKey> keys;
  for (const SeriesKey& key : wish.values()) {
    if (isChosen(key)) keys.insert(key);
  }
  return keys;
}

std::set<SeriesKey> StudyQuery::values() const {
  std::set<SeriesKey> all(keys.begin(), keys.end());
  for (const auto& [x, y] : paths) {
    all.insert(x);
    all.insert(y);
  }
  return all;
}

TableKeys tableKeys(const std::vector<SeriesKey>& keys, const SeriesScan& all) {
  TableKeys made;
  for (const SeriesKey& key : keys) {
    if (!all.isText(key)) {
      made.keys.push_back(key);
      continue;
    }
    made.left_out += made.left_out.empty() ? "; texts are left out: " : ", ";
    made.left_out += key.text();
  }
  return made;
}

std::set<SeriesKey> textsOf(const SeriesScan& all) {
  std::set<SeriesKey> texts;
  for (const SeriesKey& key : all.keys()) {
    if (all.isText(key)) texts.insert(key);
  }
  return texts;
}

std::vector<ValueColumn> columnsUntil(const ValueBins* values, const StudyQuery& wish,
                                      LogTime reached) {
  return columnsOf(values, wish, reached);
}

UnitCurves unitsUntil(const StudyQuery& wish, const SeriesScan& all, const SeriesScan& shown,
                      LogTime reached) {
  UnitCurves made;
  for (const SeriesKey& key : wish.values()) {
    const auto units = all.unitsOf(key);
    const auto there = shown.unitsOf(key);
    for (const auto& [unit, values] : units) {
      UnitCurve& curve = made[key].emplace_back(UnitCurve{std::string(unit), {}});
      if (units.size() == 1) break;
      const auto found = std::ranges::find(there, unit, &UnitSeries::unit);
      if (found != there.end()) curve.columns = columnsUntil(found->values, wish, reached);
      if (curve.columns.empty()) curve.columns.resize(wish.columns);
    }
    if (key.kind != SeriesKey::Kind::derived) continue;
    if (const auto unit = unitOfAll(statedOf(key), all)) made[key].push_back({*unit, {}});
  }
  return made;
}

StateCurve statesUntil(const StateSeries* states, const StudyQuery& wish, LogTime reached) {
  if (states == nullptr) return {};
  return {columnsOf(&states->bins, wish, reached), states->texts, states->has_numbers};
}

std::shared_ptr<const StudyPicture> alignedPicture(const StudyPicture& beside,
                                                   const StudyQuery& wish,
                                                   const EventAlignment& alignment) {
  auto aligned = std::make_shared<StudyPicture>();
  aligned->wish = wish;
  aligned->wish.keys = beside.wish.keys;
  aligned->wish.paths = beside.wish.paths;
  aligned->paths = beside.paths;  // no axis of theirs is the time
  aligned->whole = beside.whole;
  const Mapping mapping{beside.wish, wish, alignment};
  for (const auto& curve : beside.curves) aligned->curves.push_back(mapping.of(curve));
  for (const auto& [key, curves] : beside.units) {
    std::vector<UnitCurve>& its = aligned->units[key];
    for (const auto& [unit, columns] : curves) its.push_back({unit, mapping.of(columns)});
  }
  for (const StateCurve& states : beside.states) {
    aligned->states.push_back({mapping.of(states.columns), states.texts, states.has_numbers});
  }
  return aligned;
}

}  // namespace rocinante
