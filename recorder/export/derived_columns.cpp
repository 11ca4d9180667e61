#include "recorder/export/derived_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/name_hint.h"
#include "core/series/derived_value.h"
#include "core/series/placed_links.h"
#include "core/series/positional_names.h"

namespace rocinante {
namespace {

constexpr const char* kOption = "--derive";

/// As the table's columns have them: without a model joints are numbered from 1.
PositionalNames tableNames(const Cell* cell) {
  return [cell](std::string_view device, const DeviceState& device_state) {
    std::vector<std::string> names;
    if (cell != nullptr) names = positionalNames(*cell)(device, device_state);
    for (std::size_t i = 0;
         names.size() == i && device_state.joints && i < device_state.joints->value.size(); ++i) {
      names.push_back(std::to_string(i + 1));
    }
    return names;
  };
}

Result<SeriesKey> derivedKey(const std::string& text) {
  if (auto key = parseDerivedKey(text)) return *std::move(key);
  const std::string fault = derivationFault(text);
  return Error{
      ErrorKind::bad_argument,
      !fault.empty()
          ? fault
          : fmt::format("`{}` is not d/dt VALUE, mean SECONDS VALUE or VALUE - VALUE", text),
      kOption};
}

}  // namespace

Result<DerivedColumns> DerivedColumns::of(const Cell* cell, const std::vector<std::string>& texts,
                                          const std::filesystem::path& log, MomentWalk& session) {
  DerivedColumns columns(cell, log);
  for (const std::string& text : texts) {
    auto key = derivedKey(text);
    if (!key) return key.error();
    if (std::ranges::count(columns.keys_, *key) > 0) continue;
    columns.columns_.push_back(key->text());
    columns.keys_.push_back(*std::move(key));
  }
  for (const SeriesKey& key : columns.statedKeys()) {
    if (key.kind != SeriesKey::Kind::link) continue;
    if (cell == nullptr) {
      return Error{ErrorKind::bad_argument, "needs a cell: the log carries none, --cell CELL",
                   kOption};
    }
    if (checkLink(*cell, SessionState(), key)) continue;
    const Result<const SessionState*> state = session.stateAt(session.log().summary().end);
    if (!state) return state.error();
    if (Status there = checkLink(*cell, **state, key); !there) return there.error();
  }
  columns.known_ = columns.scanOf(columns.statedKeys(), session.log().summary().start);
  return columns;
}

std::set<SeriesKey> DerivedColumns::statedKeys() const {
  std::set<SeriesKey> all;
  for (const SeriesKey& key : keys_) {
    for (SeriesKey& stated : statedOf(key)) all.insert(std::move(stated));
  }
  return all;
}

std::unique_ptr<SeriesScan> DerivedColumns::scanOf(const std::set<SeriesKey>& keys,
                                                   LogTime from) const {
  SeriesScan::Options options;
  options.from = from;
  options.until = from;
  options.names = tableNames(cell_);
  options.cell = cell_;
  options.max_bins = 64;  // whether there are any, and the newest
  options.only = keys;
  return std::make_unique<SeriesScan>(std::move(options));
}

Status DerivedColumns::layOut(const std::vector<std::string>& others) {
  for (const SeriesKey& key : keys_) {
    for (const SeriesKey& stated : statedOf(key)) {
      // A link is placed by the cell, whatever packets state.
      if (stated.kind == SeriesKey::Kind::link || known_->values(stated) != nullptr) continue;
      if (known_->isText(stated)) {
        return Error{ErrorKind::bad_argument, noNumberOf(key, stated), kOption};
      }
      std::vector<std::string_view> names;
      for (const std::string& other : others) {
        const auto of_table = parseStatedKey(other);
        if (of_table && of_table->kind == stated.kind) names.push_back(other);
      }
      return Error{ErrorKind::not_found,
                   fmt::format("no packet states `{}`: {}", stated.text(),
                               whatThereIs(stated.text(), names)),
                   kOption};
    }
  }
  known_.reset();
  return {};
}

Status DerivedColumns::begin(MomentWalk& session, LogTime from) {
  auto opened = LogReader::open(path_);
  if (!opened.ok()) return opened.error();
  log_ = std::move(*opened);
  const LogTime start = log_->summary().start;
  const std::set<SeriesKey> keys(keys_.begin(), keys_.end());
  derived_ = scanOf(keys, start);
  const auto lead = leadOf(keys, from, start);
  if (lead) {
    const Result<const SessionState*> state = session.stateAt(*lead);
    if (!state) return state.error();
    derived_->beginWith(**state, *lead);
  }
  const Status there = lead ? log_->seek(*lead + Nanoseconds(1)) : log_->rewind();
  if (!there) return there;
  auto next = log_->next();
  if (!next.ok()) return next.error();
  next_ = *std::move(next);
  return {};
}

Status DerivedColumns::moveTo(LogTime moment) {
  const std::uint64_t samples = derived_->derivedSamples();
  while (next_ && next_->log_time <= moment) {
    derived_->add(*next_);
    auto next = log_->next();
    if (!next.ok()) return next.error();
    next_ = *std::move(next);
  }
  derived_->settle(moment);
  were_sampled_ = derived_->derivedSamples() != samples;
  return {};
}

void DerivedColumns::fill(std::span<double> row) const {
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    row[i] = derived_->newest(keys_[i]).value_or(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace rocinante
