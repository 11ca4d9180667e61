#include "core/behaviour/number_recorder.h"

#include <fmt/format.h>

#include <bit>
#include <span>
#include <utility>

#include "core/packet/item_text.h"
#include "core/packet/state_items.h"

namespace rocinante {
namespace {

/// Of booleans and texts what they say.
std::string_view stateText(SignalKind kind, double number, std::string_view text) {
  return kind != SignalKind::boolean ? text : number != 0 ? "true" : "false";
}

}  // namespace

void NumberRecorder::begin(const SessionState& state, LogTime start) {
  start_ = start;
  const auto take = [&](const SignalItem& item) {
    const SignalValue& value = item.item.value;
    Signal* const signal = signalOf(item.device, item.name.link, item.name.name);
    if (signal == nullptr) return;
    statements_.push_back({nullptr, signal, true, value.kind, value.number, true, value.unit,
                           stateText(value.kind, value.number, value.text)});
  };
  eachItem(state, ByKind{take, [](const auto&) {}});
  keep(state, start, true);
}

NumberRecorder::Device* NumberRecorder::deviceOf(std::string_view name) {
  auto known = devices_.find(name);
  if (known == devices_.end()) {
    if (count_ == kMaxSignals) {
      ++beyond_;
      return nullptr;
    }
    known = devices_.try_emplace(std::string(name)).first;
    known->second.name = &known->first;
  }
  return &known->second;
}

NumberRecorder::Signal* NumberRecorder::signalOf(std::string_view device, std::string_view link,
                                                 std::string_view name) {
  if (last_device_ == nullptr || *last_device_->name != device) {
    Device* const of_device = deviceOf(device);
    if (of_device == nullptr) return nullptr;
    last_device_ = of_device;
    next_ = last_device_->signals.begin();
  }
  // Neighbours in a statement are usually neighbours in the map.
  Signals& signals = last_device_->signals;
  const bool is_next =
      next_ != signals.end() && next_->first.name == name && next_->first.link == link;
  if (!is_next) next_ = signals.find(SignalNameView(link, name));
  if (next_ == signals.end()) {
    if (count_ == kMaxSignals) {
      ++beyond_;
      return nullptr;
    }
    ++count_;
    SignalName its{std::string(link), std::string(name)};
    next_ = signals.emplace(std::move(its), Signal()).first;
    next_->second.device = last_device_;
    next_->second.name = &next_->first;
  }
  return &(next_++)->second;
}

void NumberRecorder::read(const Statement& statement) {
  if (statement.kind == StatementKind::remove) {
    const auto device = devices_.find(statement.name);
    if (device != devices_.end()) statements_.push_back({&device->second});
    return;
  }
  if (!isSignal(statement.kind)) return;
  const PathView& path = statement.path;
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    Said each;
    each.signal = signalOf(path.first, path.second, statement.names[i]);
    if (each.signal == nullptr) continue;
    if (!statement.is_default) {
      each.is_stated = true;
      each.kind = statement.signal_kinds[i];
      each.number = statement.numbers[i];
      each.has_unit = statement.kind == StatementKind::signal;
      each.unit = statement.unit;
      each.text = stateText(each.kind, each.number, statement.text);
    }
    statements_.push_back(each);
  }
}

bool NumberRecorder::keep(const SessionState& state, LogTime time, bool is_restated) {
  says_fact_ = false;
  for (const Said& each : statements_) {
    if (each.removed != nullptr) {
      while (!each.removed->stated.empty()) takeBack(*each.removed->stated.back(), time);
      continue;
    }
    Signal& signal = *each.signal;
    if (!each.is_stated) {
      takeBack(signal, time);
      continue;
    }
    const bool is_new = signal.place == kUnstatedPlace;
    if (is_new) {
      // The state may have had no room for it.
      Device& device = *signal.device;
      if (state.findSignal(*device.name, *signal.name) == nullptr) continue;
      signal.place = device.stated.size();
      device.stated.push_back(&signal);
      ++stated_;
    }
    if (!is_restated) count(signal, time);
    const bool is_other_kind = std::exchange(signal.kind, each.kind) != each.kind;
    if (each.kind != SignalKind::number) {
      if (std::exchange(signal.is_number, false)) add(signal, time, kUnstated);
      signal.unit.clear();
      if (!is_new && !is_other_kind && signal.text == each.text) continue;
      signal.text = each.text;
      change(signal);
      continue;
    }
    if (each.has_unit && signal.unit != each.unit) {
      signal.unit = each.unit;
      change(signal);
    }
    if (!std::exchange(signal.is_number, true)) change(signal);
    add(signal, time, each.number);
  }
  statements_.clear();
  if (stated_ + unseen_ == state.signalCount()) return says_fact_;
  takeBackLost(state, time);
  return true;
}

std::optional<std::vector<ChangedSignal>> NumberRecorder::takeChanged(const SessionState& state) {
  std::vector<ChangedSignal> changed;
  for (Signal* const signal : std::exchange(changed_, {})) {
    signal->is_changed = false;
    const auto* const item = state.findSignal(*signal->device->name, *signal->name);
    changed.push_back({*signal->device->name, *signal->name, item});
    // The state may have had no room for what was said.
    const bool is_number = item != nullptr && item->value.kind == SignalKind::number;
    if ((item != nullptr) != (signal->place != kUnstatedPlace) || is_number != signal->is_number ||
        (is_number && item->value.unit != signal->unit)) {
      is_astray_ = true;
    }
  }
  if (is_astray_ || beyond_ > 0) return std::nullopt;
  return changed;
}

void NumberRecorder::change(Signal& signal) {
  says_fact_ = true;
  if (!std::exchange(signal.is_changed, true)) changed_.push_back(&signal);
}

void NumberRecorder::takeBack(Signal& signal, LogTime time) {
  if (signal.place == kUnstatedPlace) return;
  std::vector<Signal*>& stated = signal.device->stated;
  stated[signal.place] = stated.back();
  stated[signal.place]->place = signal.place;
  stated.pop_back();
  signal.place = kUnstatedPlace;
  --stated_;
  signal.unit.clear();
  if (std::exchange(signal.is_number, false)) add(signal, time, kUnstated);
  change(signal);
}

/// A whole restatement forgets what it does not repeat.
void NumberRecorder::takeBackLost(const SessionState& state, LogTime time) {
  for (auto& [name, device] : devices_) {
    for (std::size_t i = device.stated.size(); i-- > 0;) {
      Signal& signal = *device.stated[i];
      if (state.findSignal(name, *signal.name) == nullptr) takeBack(signal, time);
    }
  }
  unseen_ = state.signalCount() - stated_;
  is_astray_ = is_astray_ || unseen_ > 0;
}

void NumberRecorder::add(Signal& signal, LogTime time, double value) {
  signal.times.push_back(std::bit_cast<double>((time - start_).count()));
  signal.values.push_back(value);
  if (signal.times.size() == kBlockRows) store(signal);
}

void NumberRecorder::store(Signal& signal) {
  if (signal.times.empty()) return;
  TrackSeries& series = numbers_[signalNameText(*signal.device->name, *signal.name)];
  series.width = 1;
  series.rows += signal.times.size();
  series.blocks.push_back(store_.size());
  for (std::vector<double>* column : {&signal.times, &signal.values}) {
    store_.append(std::as_bytes(std::span(*column)));
    column->clear();
  }
}

void NumberRecorder::count(Signal& signal, LogTime time) {
  constexpr std::size_t kNumbers = 3;
  std::vector<double>& rows = signal.rhythm;
  const std::int64_t bin = (time - start_) / kSaidBin;
  if (bin != std::exchange(signal.rhythm_bin, bin)) {
    if (rows.size() == kNumbers * kBlockRows) storeRhythm(signal);
    rows.insert(rows.end(), {std::bit_cast<double>((bin * kSaidBin).count()), 0, 0});
  }
  const double interval = secondsOf(time - signal.last_said.value_or(time));
  signal.last_said = time;
  rows[rows.size() - 2] += 1;
  rows[rows.size() - 1] += interval * interval;
}

void NumberRecorder::storeRhythm(Signal& signal) {
  if (signal.rhythm.empty()) return;
  TrackSeries& series = rhythms_[signalNameText(*signal.device->name, *signal.name)];
  series.width = 2;
  const std::size_t rows = signal.rhythm.size() / (series.width + 1);
  std::vector<double> block;
  for (std::size_t column = 0; column <= series.width; ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      block.push_back(signal.rhythm[row * (series.width + 1) + column]);
    }
  }
  series.rows += rows;
  series.blocks.push_back(store_.size());
  store_.append(std::as_bytes(std::span(block)));
  signal.rhythm.clear();
}

void NumberRecorder::finish(Account& left_out) {
  for (auto& [name, device] : devices_) {
    for (auto& [of_device, signal] : device.signals) {
      store(signal);
      storeRhythm(signal);
    }
  }
  if (beyond_ == 0) return;
  left_out.leaveOut({.kind = "signal",
                     .reason = fmt::format("at most {} signals are judged", kMaxSignals),
                     .count = beyond_,
                     .severity = Severity::warning});
}

}  // namespace rocinante
