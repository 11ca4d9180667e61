#include "core/series/signal_series.h"

#include <algorithm>
#include <utility>

namespace rocinante {

void SignalSeries::take(SeriesStore& store, SignalKind kind, double number, std::string_view text,
                        LogTime time, bool states) {
  const bool is_number = kind == SignalKind::number;
  if (kind == SignalKind::text) {
    endNumbers(store, time);
  } else {
    if (!std::exchange(is_known_, true)) id_ = store.idOf(key_);
    if (is_number && std::exchange(is_other_unit_, false)) useUnit(store, time);
    store.record(id_, time, number);
    if (units_.size() > 1) {
      const SeriesStore::Id its = units_[in_use_].id;
      if (is_number) {
        store.record(its, time, number);
      } else {
        store.end(its, time);
      }
    }
  }
  if (!is_number) {
    if (!states) return;
    if (states_ == nullptr) states_ = store.statesOf(key_);
    if (states_ == nullptr) return;
    states_->has_numbers = states_->has_numbers || was_number_;
    return store.record(*states_, time,
                        kind == SignalKind::text ? text
                        : number != 0            ? "true"
                                                 : "false");
  }
  was_number_ = true;
  if (states_ == nullptr) return;
  states_->bins.end(time);
  states_->has_numbers = true;
}

void SignalSeries::end(SeriesStore& store, LogTime time) {
  stateUnit({});
  endNumbers(store, time);
  if (states_ != nullptr) states_->bins.end(time);
}

std::vector<UnitSeries> SignalSeries::units(const SeriesStore& store) const {
  if (units_.size() == 1) return {{units_[0].name, store.values(id_)}};
  std::vector<UnitSeries> units;
  for (const Unit& unit : units_) units.push_back({unit.name, store.values(unit.id)});
  return units;
}

void SignalSeries::endNumbers(SeriesStore& store, LogTime time) {
  store.end(id_, time);
  if (units_.size() > 1) store.end(units_[in_use_].id, time);
}

/// The next number is in the unit that is stated now.
void SignalSeries::useUnit(SeriesStore& store, LogTime time) {
  auto found = std::ranges::find(units_, unit_, &Unit::name);
  if (found == units_.end() && units_.size() < kMaxUnits) {
    // What was gathered so far is of the first one.
    if (units_.size() == 1) units_[0].id = store.branch(id_);
    const bool is_first = units_.empty();
    const bool is_last = units_.size() + 1 == kMaxUnits;
    units_.push_back({is_last ? "other units" : unit_, SeriesStore::kUnwanted});
    found = units_.end() - 1;
    if (!is_first && id_ != SeriesStore::kUnwanted) found->id = store.branch();
  }
  if (found == units_.end()) --found;
  const auto place = static_cast<std::size_t>(found - units_.begin());
  if (place == in_use_) return;
  store.end(units_[in_use_].id, time);
  in_use_ = place;
}

}  // namespace rocinante
