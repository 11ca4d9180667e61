#include "core/packet/state_folder.h"

#include <algorithm>

#include "core/packet/packet_limits.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kAllCame = ~std::uint64_t{0};

/// Moves the record of seen numbers by `steps`: the old highest becomes one of them.
std::uint64_t movedOn(std::uint64_t recent, std::uint64_t steps) {
  if (steps > limits::kReorderWindow) return 0;
  const std::uint64_t shifted = steps == limits::kReorderWindow ? 0 : recent << steps;
  return shifted | std::uint64_t{1} << (steps - 1);
}

/// Notes the number that is `below` (1 to 64) the highest; false when it was seen before.
bool noteLate(std::uint64_t& recent, std::uint64_t below) {
  const std::uint64_t bit = std::uint64_t{1} << (below - 1);
  if ((recent & bit) != 0) return false;
  recent |= bit;
  return true;
}

}  // namespace

Newness newnessOf(const SessionState& state, const PacketHeader& header) {
  const auto found = state.sources().find(header.source);
  if (found == state.sources().end()) return Newness::newest;
  const SourceState& source = found->second;
  if (source.run != header.run) return Newness::restart;
  const std::optional<std::uint64_t>& highest = source.highest_sequence;
  if (header.reset || !header.sequence || !highest) return Newness::newest;
  const bool own = header.by.empty();
  if (own && isRestart(*header.sequence, *highest)) return Newness::restart;
  const bool is_above = *header.sequence > *highest || (!own && *header.sequence == *highest);
  return is_above ? Newness::newest : Newness::late;
}

Applied StateFolder::fold() {
  if (header_.via) countRelay();
  if (!state_.open_.empty()) abandonOldRestatements();
  if (!findSource()) return Applied::refused;
  if (header_.by.empty()) ++(header_.via ? counts_->filtered : counts_->whole);
  if (!admit()) return Applied::late;

  ++state_.packets_;
  ++(header_.by.empty() ? counts_->packets : counts_->by_others);
  for (const FaultAt& fault : packet_.faults) count(fault.fault);
  source_->time_ns = header_.time_ns;
  if (header_.part) beginPart();
  for (const Statement& statement : packet_.statements) foldStatement(statement);
  if (header_.part) finishPart();
  return Applied::yes;
}

bool StateFolder::findSource() {
  if (const auto* known = state_.source_cache_.find(header_.source)) {
    source_ = known->state;
    counts_ = known->counts;
    return true;
  }
  auto found = state_.sources_.find(header_.source);
  if (found == state_.sources_.end()) {
    if (state_.sources_.size() == limits::kSources) return false;
    const std::uint64_t weight = kSourceWeight + header_.source.size() + header_.run.size();
    if (state_.weight_ + weight > limits::kStateBytes) return false;
    state_.weight_ += weight;
    SourceState fresh;
    fresh.run = header_.run;
    found = state_.sources_.emplace(std::string(header_.source), std::move(fresh)).first;
    state_.counts_.emplace(found->first, SourceCounts());
  }
  source_ = &found->second;
  counts_ = &state_.counts_.find(header_.source)->second;
  state_.source_cache_.remember(found->first, {source_, counts_});
  return true;
}

// Newest wins (docs/packet-format.md, section "Newest wins").
bool StateFolder::admit() {
  const bool own = header_.by.empty();
  if (header_.reset) forgetSequence();
  const bool other_run = !sameName(source_->run, header_.run);
  const bool again = own && header_.sequence && source_->highest_sequence &&
                     isRestart(*header_.sequence, *source_->highest_sequence);
  if (other_run || again) {
    forgetSequence();
    state_.open_.erase(std::string(header_.source));
    state_.weight_ += header_.run.size() - source_->run.size();
    source_->run = header_.run;
    if (own) ++counts_->restarts;
  }
  if (!header_.sequence) return true;
  const std::uint64_t sequence = *header_.sequence;
  std::optional<std::uint64_t>& highest = source_->highest_sequence;
  if (!highest || sequence > *highest) {
    if (!own || header_.via || !highest) {
      counts_->recent = kAllCame;
    } else {
      const std::uint64_t steps = sequence - *highest;
      counts_->gap += steps - 1;
      counts_->recent = movedOn(counts_->recent, steps);
    }
    highest = sequence;
    return true;
  }
  if (!own) return sequence == *highest;
  ++counts_->late;
  if (sequence == *highest || !noteLate(counts_->recent, *highest - sequence)) {
    ++counts_->duplicates;
  } else {
    --counts_->gap;
  }
  return false;
}

void StateFolder::forgetSequence() {
  source_->highest_sequence.reset();
  counts_->recent = kAllCame;
}

void StateFolder::countRelay() {
  auto found = state_.relays_.find(header_.via->relay);
  if (found == state_.relays_.end()) {
    if (state_.relays_.size() == limits::kRelays) return;
    found = state_.relays_.emplace(std::string(header_.via->relay), RelayCounts()).first;
  }
  RelayCounts& relay = found->second;
  const std::uint64_t sequence = header_.via->sequence;
  ++relay.packets;
  if (relay.highest && isRestart(sequence, *relay.highest)) {
    ++relay.restarts;
    relay.highest.reset();
  }
  if (!relay.highest) {
    relay.recent = kAllCame;
    relay.highest = sequence;
  } else if (sequence > *relay.highest) {
    relay.gap += sequence - *relay.highest - 1;
    relay.recent = movedOn(relay.recent, sequence - *relay.highest);
    relay.highest = sequence;
  } else if (sequence < *relay.highest && noteLate(relay.recent, *relay.highest - sequence)) {
    --relay.gap;
  }
}

void StateFolder::abandonOldRestatements() {
  if (time_ < state_.open_until_) return;
  state_.open_until_ = LogTime::max();
  for (auto open = state_.open_.begin(); open != state_.open_.end();) {
    const LogTime until = open->second.began + limits::kRestatementSpan;
    if (time_ >= until) {
      open = state_.open_.erase(open);
    } else {
      state_.open_until_ = std::min(state_.open_until_, until);
      ++open;
    }
  }
}

void StateFolder::beginPart() {
  const RestatementPart& part = *header_.part;
  auto found = state_.open_.find(header_.source);
  if (found != state_.open_.end() &&
      (found->second.id != part.id || found->second.came.size() != part.count)) {
    state_.open_.erase(found);
    found = state_.open_.end();
  }
  if (found == state_.open_.end()) {
    SessionState::OpenRestatement open;
    open.id = part.id;
    open.came.resize(part.count);
    open.missing = part.count;
    open.began = time_;
    open.first_packet = state_.packets_;
    open.nothing_before = counts_->packets + counts_->by_others == 1;
    // A log may reach the last representable moment.
    const LogTime until =
        time_ + std::min<Nanoseconds>(limits::kRestatementSpan, LogTime::max() - time_);
    state_.open_until_ = state_.open_.empty() ? until : std::min(state_.open_until_, until);
    found = state_.open_.emplace(std::string(header_.source), std::move(open)).first;
  }
  SessionState::OpenRestatement& open = found->second;
  if (open.came[part.index - 1]) return;
  open.came[part.index - 1] = true;
  --open.missing;
}

void StateFolder::finishPart() {
  const auto open = state_.open_.find(header_.source);
  if (open->second.missing != 0) return;
  const std::uint64_t first_packet = open->second.first_packet;
  const bool nothing_before = open->second.nothing_before;
  state_.open_.erase(open);
  // Otherwise reading a keyframe of many sources would walk over all items for each of them.
  if (!nothing_before) forgetUnrepeated(first_packet);
}

Applied SessionState::apply(LogTime time, const Packet& packet) {
  return StateFolder(*this, time, packet).fold();
}

}  // namespace rocinante
