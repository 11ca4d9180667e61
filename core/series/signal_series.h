#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/log_types.h"
#include "core/packet/packet.h"
#include "core/series/series_store.h"

namespace rocinante {

/// The numbers of a signal that were stated in one unit; borrowed until the next one is recorded.
struct UnitSeries {
  std::string_view unit;              ///< empty: none was stated
  const ValueBins* values = nullptr;  ///< null: there was no room for them
};

/// Takes what is stated of one signal into its series: numbers and booleans together, numbers by
/// unit where there are several, and states. One thread.
class SignalSeries {
 public:
  /// Units kept apart; the last stands for all further ones, "other units".
  static constexpr std::size_t kMaxUnits = 8;

  explicit SignalSeries(SeriesKey key) : key_(std::move(key)) {}

  /// The unit from now on, which is that of the numbers to come.
  void stateUnit(std::string_view unit) {
    if (unit_ == unit) return;
    unit_ = unit;
    is_other_unit_ = true;
  }
  /// `states`: false for numbers alone.
  void take(SeriesStore& store, SignalKind kind, double number, std::string_view text, LogTime time,
            bool states);
  void end(SeriesStore& store, LogTime time);

  /// In the order in which they came; booleans have none and count in an only one.
  std::vector<UnitSeries> units(const SeriesStore& store) const;

 private:
  /// Its numbers in one unit; of an only one `id_` has them.
  struct Unit {
    std::string name;
    SeriesStore::Id id = SeriesStore::kUnwanted;
  };
  void useUnit(SeriesStore& store, LogTime time);
  void endNumbers(SeriesStore& store, LogTime time);

  SeriesKey key_;
  SeriesStore::Id id_ = SeriesStore::kUnwanted;  ///< of all numbers; known once there is one
  std::string unit_;                             ///< as it is stated now
  std::vector<Unit> units_;                      ///< of numbers
  std::size_t in_use_ = 0;                       ///< of `units_`, by the last number
  StateSeries* states_ = nullptr;                ///< null: it was no state yet
  bool is_known_ = false;                        ///< `id_` is
  bool was_number_ = false;                      ///< and not only a boolean
  bool is_other_unit_ = true;                    ///< `unit_` was stated since the last number
};

}  // namespace rocinante
