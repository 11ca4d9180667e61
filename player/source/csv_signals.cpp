#include "player/source/csv_signals.h"

#include <algorithm>
#include <utility>

#include "core/foreign/table/table_fields.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

bool isSame(const CsvSignals::Change& a, const CsvSignals::Change& b) {
  return a.kind == b.kind && a.number == b.number && a.text == b.text;
}

}  // namespace

std::string_view CsvSignals::add(NamedSignal signal, std::size_t column) {
  const bool has_device = signal.device.empty() || isName(signal.device);
  if (!has_device || !isName(signal.name.name)) return "packets have no such name";
  if (!names_.insert(signalNameText(signal.device, signal.name)).second) {
    return "stated twice: the first of them counts";
  }
  columns_.push_back({std::move(signal), column});
  latest_.emplace_back();
  return {};
}

bool CsvSignals::say(std::size_t row, std::size_t index, const SignalValue& value) {
  Change change;
  change.row = row;
  change.index = static_cast<std::uint32_t>(index);
  change.kind = value.kind;
  change.number = value.number;
  if (value.kind == SignalKind::text) {
    if (!isSignalText(value.text)) return false;
    const auto place = static_cast<std::uint32_t>(texts_.size());
    const auto [known, is_new] = text_places_.try_emplace(value.text, place);
    if (is_new) texts_.push_back(&known->first);
    change.text = known->second;
  }
  std::optional<Change>& latest = latest_[index];
  if (latest && isSame(*latest, change)) return true;
  change.is_first = !latest.has_value();
  latest = change;
  changes_.push_back(change);
  return true;
}

std::span<const CsvSignals::Change> CsvSignals::of(std::size_t row) const {
  const auto first = std::ranges::lower_bound(changes_, row, {}, &Change::row);
  return {first, std::ranges::upper_bound(changes_, row, {}, &Change::row)};
}

bool CsvSignals::changesAgain(std::size_t row) const {
  // A turn begins with what the last one ended with.
  return std::ranges::any_of(of(row), [this](const Change& change) {
    return !change.is_first || !isSame(*latest_[change.index], change);
  });
}

}  // namespace rocinante
