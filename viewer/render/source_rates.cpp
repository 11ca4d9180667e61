#include "viewer/render/source_rates.h"

#include <chrono>
#include <limits>

namespace rocinante {
namespace {

constexpr Nanoseconds kRateWindow = std::chrono::seconds(1);

std::string sourceOf(const LogChannel& channel) {
  const auto source = channel.metadata.find("source");
  const bool named = source != channel.metadata.end() && !source->second.empty();
  return named ? source->second : channel.topic;
}

/// Decoded packets speak for a source of their own, beside their octets.
bool isCounted(const LogChannel& channel) { return channel.captured() || channel.decoded(); }

}  // namespace

Status SourceRates::readOn(LogTime time) {
  const bool can_go_on = reached_ && *reached_ <= time && *reached_ >= time - kRateWindow;
  if (!can_go_on) {
    window_.clear();
    next_.reset();
    at_end_ = false;
    if (Status put = reader_.seek(time - kRateWindow + Nanoseconds(1)); !put) return put;
  }
  reached_ = time;
  while (true) {
    if (!next_ && !at_end_) {
      const auto message = reader_.next();
      if (!message) return message.error();
      at_end_ = !*message;
      if (*message) next_ = Counted{(*message)->log_time, (*message)->channel};
    }
    if (!next_ || next_->time > time) break;
    if (isCounted(*next_->channel)) window_.push_back(*next_);
    next_.reset();
  }
  while (!window_.empty() && window_.front().time <= time - kRateWindow) window_.pop_front();
  return {};
}

Result<std::map<std::string, std::uint64_t>> SourceRates::at(LogTime time, StateDamage& damage) {
  if (Status read = readOn(time); !read) {
    reached_.reset();
    return read.error();
  }
  const auto endOf = [](LogTime moment) {
    return LogPosition{moment, std::numeric_limits<std::uint64_t>::max()};
  };
  addDamageBetween(reader_, endOf(time - kRateWindow), endOf(time), damage);
  std::map<std::string, std::uint64_t> rates;
  for (const LogChannel& channel : reader_.channels()) {
    if (isCounted(channel)) rates.emplace(sourceOf(channel), 0);
  }
  for (const Counted& one : window_) ++rates[sourceOf(*one.channel)];
  return rates;
}

}  // namespace rocinante
