#include "core/series/series_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kMinBins = 64;
constexpr std::size_t kMaxStateBytes = 256;
/// What a text takes beside its bytes, in a list that has room for more.
constexpr std::size_t kBesideText = 2 * sizeof(std::string);

}  // namespace

Nanoseconds binWidth(LogTime from, LogTime until, std::size_t bins) {
  if (until <= from) return Nanoseconds(1);
  return (until - from) / static_cast<std::int64_t>(bins) + Nanoseconds(1);
}

void SeriesStore::record(StateSeries& states, LogTime time, std::string_view text) {
  text = text.substr(0, kMaxStateBytes);
  std::vector<std::string>& texts = states.texts;
  auto found = std::ranges::find(texts, text);
  if (found == texts.end()) {
    if (!states.has_others) {
      states.has_others = texts.size() + 1 >= StateBin::kStates || !makeTextRoom(text.size());
      texts.emplace_back(states.has_others ? "other texts" : text);
    }
    found = texts.end() - 1;
  }
  states.bins.add(time, static_cast<StateBin::Value>(found - texts.begin()));
}

bool SeriesStore::makeTextRoom(std::size_t bytes) {
  const std::uint64_t all = text_bytes_ + bytes + kBesideText;
  if (all > options_.max_bytes / 4) return false;
  text_bytes_ = all;
  fit(series_.size() + states_.size());
  return true;
}

/// Halves bins until `count` series fit.
void SeriesStore::fit(std::size_t count) {
  // By what they may take, since the last sample of each may come at the end.
  static_assert(sizeof(StateBin) == sizeof(ValueBin));
  const auto most_bytes = [&] {
    return count * options_.max_bins * sizeof(ValueBin) + text_bytes_;
  };
  while (options_.max_bins > kMinBins && most_bytes() > options_.max_bytes) {
    options_.max_bins /= 2;
    for (ValueBins& series : series_) series.halve();
    for (auto& [key, states] : states_) states.bins.halve();
  }
}

bool SeriesStore::makeRoom() {
  const std::size_t count = series_.size() + states_.size();
  if (count >= kMaxSeries) return false;
  fit(count + 1);
  return true;
}

SeriesStore::Id SeriesStore::idOf(const SeriesKey& key) {
  if (options_.only && !options_.only->contains(key)) return kUnwanted;
  const auto known = ids_.find(key);
  if (known != ids_.end()) return known->second;
  const Id made = branch();
  if (made != kUnwanted) ids_.emplace(key, made);
  return made;
}

SeriesStore::Id SeriesStore::branch() {
  if (!makeRoom()) return kUnwanted;
  const Nanoseconds width = binWidth(options_.from, options_.until, options_.max_bins);
  series_.emplace_back(options_.from, width, options_.max_bins);
  return series_.size() - 1;
}

SeriesStore::Id SeriesStore::branch(Id id) {
  if (id == kUnwanted || !makeRoom()) return kUnwanted;
  // A copy first: the list moves as it grows.
  ValueBins copied = series_[id];
  series_.push_back(std::move(copied));
  return series_.size() - 1;
}

void SeriesStore::derive(const SeriesKey& key) {
  Derived derived{idOf(key), DerivedValue(key), {}};
  if (derived.id == kUnwanted) return;
  const std::vector<SeriesKey>& stated = derived.value.stated();
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const Id id = idOf(stated[i]);
    if (id == kUnwanted) continue;
    if (id >= followers_.size()) followers_.resize(id + 1);
    followers_[id].push_back({derived_.size(), i});
  }
  derived_.push_back(std::move(derived));
}

void SeriesStore::tell(Id id, std::optional<double> value) {
  for (const Follower& follower : followers_[id]) {
    derived_[follower.derived].value.take(follower.stated, value);
    has_news_ = true;
  }
}

void SeriesStore::settle(LogTime time, bool exactly) {
  const auto take = [this](Derived& derived, LogTime at, const std::optional<double>& value) {
    derived.newest = value && std::isfinite(*value) ? value : std::nullopt;
    if (derived.newest) {
      record(derived.id, at, *value);
    } else {
      end(derived.id, at);
    }
  };
  for (Derived& derived : derived_) {
    while (const auto between = derived.value.nextBefore(time)) {
      take(derived, between->time, between->value);
    }
  }
  if (std::exchange(has_news_, false)) {
    ++derived_samples_;
    for (Derived& derived : derived_) {
      if (const auto value = derived.value.at(time)) take(derived, time, *value);
    }
  }
  for (Derived& derived : derived_) {
    if (!exactly) break;
    if (const auto value = derived.value.asOf(time)) take(derived, time, *value);
  }
}

std::optional<double> SeriesStore::newest(const SeriesKey& derived) const {
  const auto id = ids_.find(derived);
  if (id == ids_.end()) return std::nullopt;
  const auto found = std::ranges::find(derived_, id->second, &Derived::id);
  return found == derived_.end() ? std::nullopt : found->newest;
}

StateSeries* SeriesStore::statesOf(const SeriesKey& key) {
  if (options_.only && !options_.only->contains(key)) return nullptr;
  const auto known = states_.find(key);
  if (known != states_.end()) return &known->second;
  if (!makeRoom()) return nullptr;
  const Nanoseconds width = binWidth(options_.from, options_.until, options_.max_bins);
  StateSeries made{StateBins(options_.from, width, options_.max_bins), {}};
  return &states_.emplace(key, std::move(made)).first->second;
}

const ValueBins* SeriesStore::values(const SeriesKey& key) const {
  const auto found = ids_.find(key);
  return found == ids_.end() ? nullptr : values(found->second);
}

const StateSeries* SeriesStore::states(const SeriesKey& key) const {
  const auto found = states_.find(key);
  return found == states_.end() ? nullptr : &found->second;
}

std::vector<SeriesKey> SeriesStore::keys() const {
  std::vector<SeriesKey> keys;
  for (const auto& [key, id] : ids_) {
    if (!series_[id].bins().empty()) keys.push_back(key);
  }
  const auto numbers = static_cast<std::ptrdiff_t>(keys.size());
  for (const auto& [key, states] : states_) {
    if (values(key) == nullptr) keys.push_back(key);
  }
  std::inplace_merge(keys.begin(), keys.begin() + numbers, keys.end());
  return keys;
}

std::uint64_t SeriesStore::bytes() const {
  std::uint64_t bytes = text_bytes_;
  for (const ValueBins& series : series_) bytes += series.bytes();
  for (const auto& [key, states] : states_) bytes += states.bins.bytes();
  return bytes;
}

}  // namespace rocinante
