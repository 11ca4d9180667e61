#include "viewer/ui/live/source_watch.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace rocinante {
namespace {

constexpr Nanoseconds kTenth = std::chrono::milliseconds(100);

/// Faulty lines of the sender; does not count lines of later versions and corrected quaternions.
std::uint64_t faultyLines(const SourceCounts& counts) {
  std::uint64_t all = std::accumulate(counts.faults.begin(), counts.faults.end(), std::uint64_t{0});
  for (const PacketFault harmless :
       {PacketFault::unknown_statement, PacketFault::unnormalised_quaternion}) {
    all -= counts.faults[static_cast<std::size_t>(harmless)];
  }
  return all;
}

}  // namespace

bool SourceWatch::look(SteadyTime now,
                       const std::map<std::string, SourceCounts, std::less<>>& counts) {
  if (looked_ && now - *looked_ < kTenth) return false;
  looked_ = now;
  // The oldest sample, replaced by this one.
  const std::size_t place = next_;
  next_ = (next_ + 1) % kTenths;
  const SteadyTime oldest = times_[place];
  times_[place] = now;
  std::vector<LiveSource> seen;
  seen.reserve(counts.size());
  for (const auto& [name, one] : counts) {
    const std::uint64_t packets = one.packets + one.late;
    if (packets == 0) continue;  // only mentioned by other sources
    const auto [found, is_new] = watched_.try_emplace(name);
    Watched& watched = found->second;
    const std::uint64_t last = watched.packets[(place + kTenths - 1) % kTenths];
    if (is_new) watched.since = now - kTenth;
    if (is_new || packets != last) watched.heard = now;
    // For a new source, since its first packet.
    const SteadyTime from = std::max(oldest, watched.since);
    const double span_s = std::chrono::duration<double>(now - from).count();
    const std::uint64_t before = watched.packets[place];
    watched.packets[place] = packets;
    LiveSource row;
    row.name = name;
    row.rate_hz = static_cast<double>(packets - before) / std::max(span_s, 1.0);
    row.heard = watched.heard;
    row.packets = packets;
    row.lost = one.gap;
    row.late = one.late;
    row.restarts = one.restarts;
    row.faulty_lines = faultyLines(one);
    row.is_mixed = one.isMixed();
    seen.push_back(std::move(row));
  }
  const bool changed = !(seen == sources_);
  sources_ = std::move(seen);
  return changed;
}

}  // namespace rocinante
