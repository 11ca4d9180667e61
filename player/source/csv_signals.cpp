#include "player/source/csv_signals.h"

#include <algorithm>
#include <utility>

#include "core/foreign/table/table_fields.h"
#include "core/packet/packet_text.h"

namespace rocinante {

std::string_view CsvSignals::add(NamedSignal signal, std::size_t column) {
  const bool has_device = signal.device.empty() || isName(signal.device);
  if (!has_device || !isName(signal.name.name)) return "packets have no such name";
  const auto is_same = [&](const Column& each) { return each.signal == signal; };
  if (std::ranges::any_of(columns_, is_same)) return "said twice: the first of them counts";
  columns_.push_back({std::move(signal), column});
  latest_.emplace_back();
  return {};
}

bool CsvSignals::say(std::size_t row, std::size_t index, SignalValue value) {
  if (value.kind == SignalKind::text && !isSignalText(value.text)) return false;
  std::optional<SignalValue>& latest = latest_[index];
  if (latest == value) return true;
  changes_.push_back({row, index, value, !latest.has_value()});
  latest = std::move(value);
  return true;
}

std::span<const CsvSignals::Change> CsvSignals::of(std::size_t row) const {
  const auto first = std::ranges::lower_bound(changes_, row, {}, &Change::row);
  return {first, std::ranges::upper_bound(changes_, row, {}, &Change::row)};
}

bool CsvSignals::changesAgain(std::size_t row) const {
  // A turn begins with what the last one ended with.
  return std::ranges::any_of(of(row), [this](const Change& change) {
    return !change.is_first || latest_[change.index] != change.value;
  });
}

}  // namespace rocinante
