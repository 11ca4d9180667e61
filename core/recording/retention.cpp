#include "core/recording/retention.h"

#include <algorithm>
#include <utility>

namespace rocinante {

void Retention::add(PieceFacts piece) {
  bytes_ += piece.bytes;
  kept_.push_back(std::move(piece));
}

void Retention::settle(const PieceFacts& piece) {
  // Usually the last one.
  const auto same = std::find_if(kept_.rbegin(), kept_.rend(), [&](const PieceFacts& each) {
    return each.file.path == piece.file.path;
  });
  if (same == kept_.rend()) return;
  bytes_ = bytes_ - same->bytes + piece.bytes;
  *same = piece;
}

std::vector<PieceFacts> Retention::surplus(std::optional<std::uint64_t> current_bytes,
                                           std::optional<LogTime> reached) {
  std::vector<PieceFacts> surplus;
  const std::uint64_t current = current_bytes ? 1 : 0;
  while (!kept_.empty()) {
    const bool too_many = limits_.keep && kept_.size() + current > *limits_.keep;
    const bool too_large =
        limits_.disk_quota_bytes && bytes_ + current_bytes.value_or(0) > *limits_.disk_quota_bytes;
    const bool too_old = limits_.span && reached && kept_.front().end &&
                         *kept_.front().end + *limits_.span < *reached;
    // The last piece stays, however large or old, unless a newer one exists.
    if (!too_many && !(too_old && kept_.size() + current > 1) &&
        (!too_large || kept_.size() + current == 1))
      break;
    PieceFacts& oldest = kept_.front();
    bytes_ -= oldest.bytes;
    surplus.push_back(std::move(oldest));
    kept_.pop_front();
  }
  return surplus;
}

void Retention::countDeleted(const PieceFacts& piece) {
  ++deleted_.count;
  deleted_.packets += piece.packets;
  deleted_.bytes += piece.bytes;
}

bool Retention::holds(const std::filesystem::path& path) const {
  return std::ranges::any_of(
      kept_, [&](const PieceFacts& each) { return each.file.path == path && each.file.isThere(); });
}

}  // namespace rocinante
