#include "viewer/ui/study/study_picture.h"

namespace rocinante {
namespace {

template <class Bin>
std::vector<BinColumn<Bin>> columnsOf(const TimeBins<Bin>* bins, const StudyWish& wish,
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
  const StudyWish& there;
  const StudyWish& here;
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

}  // namespace

bool isChosen(const SeriesKey& key) {
  return key.kind == SeriesKey::Kind::link || key.kind == SeriesKey::Kind::derived;
}

std::set<SeriesKey> chosenKeys(const StudyWish& wish) {
  std::set<SeriesKey> keys;
  for (const SeriesKey& key : wish.values()) {
    if (isChosen(key)) keys.insert(key);
  }
  return keys;
}

std::set<SeriesKey> StudyWish::values() const {
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

std::vector<ValueColumn> columnsUntil(const ValueBins* values, const StudyWish& wish,
                                      LogTime reached) {
  return columnsOf(values, wish, reached);
}

StateCurve statesUntil(const StateSeries* states, const StudyWish& wish, LogTime reached) {
  if (states == nullptr) return {};
  return {columnsOf(&states->bins, wish, reached), states->texts, states->has_numbers};
}

std::shared_ptr<const StudyPicture> alignedPicture(const StudyPicture& beside,
                                                   const StudyWish& wish,
                                                   const EventAlignment& alignment) {
  auto aligned = std::make_shared<StudyPicture>();
  aligned->wish = wish;
  aligned->wish.keys = beside.wish.keys;
  aligned->wish.paths = beside.wish.paths;
  aligned->paths = beside.paths;  // no axis of theirs is the time
  aligned->whole = beside.whole;
  const Mapping mapping{beside.wish, wish, alignment};
  for (const auto& curve : beside.curves) aligned->curves.push_back(mapping.of(curve));
  for (const StateCurve& states : beside.states) {
    aligned->states.push_back({mapping.of(states.columns), states.texts, states.has_numbers});
  }
  return aligned;
}

}  // namespace rocinante
