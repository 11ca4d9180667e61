#include "viewer/ui/study/study_picture.h"

namespace rocinante {

bool isChosen(const SeriesKey& key) { return key.kind == SeriesKey::Kind::link; }

std::set<SeriesKey> chosenKeys(const StudyWish& wish) {
  std::set<SeriesKey> keys;
  for (const SeriesKey& key : wish.keys) {
    if (isChosen(key)) keys.insert(key);
  }
  return keys;
}

std::vector<ValueColumn> columnsUntil(const ValueBins* values, const StudyWish& wish,
                                      LogTime reached) {
  std::vector<ValueColumn> columns;
  if (values != nullptr) columns = values->columns(wish.from, wish.until, wish.columns);
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

std::shared_ptr<const StudyPicture> alignedPicture(const StudyPicture& beside,
                                                   const StudyWish& wish,
                                                   const EventAlignment& alignment) {
  auto aligned = std::make_shared<StudyPicture>();
  aligned->wish = wish;
  aligned->wish.keys = beside.wish.keys;
  aligned->whole = beside.whole;
  const Nanoseconds known = beside.wish.until - beside.wish.from;
  for (const std::vector<ValueColumn>& curve : beside.curves) {
    std::vector<ValueColumn>& columns = aligned->curves.emplace_back();
    if (curve.empty() || known.count() <= 0) continue;
    columns.resize(wish.columns);
    const double count = static_cast<double>(curve.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      // The middle of the column.
      const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(columns.size());
      const Nanoseconds since(
          static_cast<std::int64_t>(part * static_cast<double>((wish.until - wish.from).count())));
      const LogTime there = alignment.inB(wish.from + since);
      const double place = static_cast<double>((there - beside.wish.from).count()) /
                           static_cast<double>(known.count()) * count;
      if (place >= 0 && place < count) columns[i] = curve[static_cast<std::size_t>(place)];
    }
  }
  return aligned;
}

}  // namespace rocinante
