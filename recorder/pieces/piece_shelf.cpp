#include "recorder/pieces/piece_shelf.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/figure_text.h"

namespace rocinante {

PieceShelf::PieceShelf(RetentionLimits limits, NoteBox& notes)
    : notes_(notes), limits_(limits), retention_(limits) {}

void PieceShelf::put(std::unique_ptr<PieceLog> piece, std::string reason, const PieceFacts& about) {
  bytes_ever_ += piece->bytes();
  retention_.add(piece->facts());
  closer_.close(std::move(piece), std::move(reason), about);
}

void PieceShelf::keepLimits(std::optional<std::uint64_t> current_bytes) {
  for (PieceFacts& each : retention_.surplus(current_bytes)) closer_.remove(std::move(each));
  const std::uint64_t bytes = retention_.bytes() + current_bytes.value_or(0);
  if (!limits_.disk_quota_bytes || bytes <= *limits_.disk_quota_bytes || too_large_reported_)
    return;
  too_large_reported_ = true;
  notes_.warn(fmt::format("one piece alone takes {}, more than --disk-quota {}", sizeText(bytes),
                          sizeText(*limits_.disk_quota_bytes)));
}

Status PieceShelf::settle() { return settle(closer_.takeDone()); }

Status PieceShelf::finish() { return settle(closer_.finish()); }

Status PieceShelf::settle(std::vector<PieceCloser::Done> done) {
  Status outcome;
  for (PieceCloser::Done& each : done) {
    const std::string path = each.facts.file.path.string();
    const std::string size = sizeText(each.facts.bytes);
    if (each.piece) {
      each.piece->addRefused(refused_);
      retention_.settle(each.facts);
      if (const auto disturbed = each.piece->newDisturbance()) notes_.warn(disturbed->text());
      if (each.facts.trouble) continue;
      if (each.status) {
        notes_.say(fmt::format("{} is written ({})", path, size));
      } else if (outcome) {
        outcome = each.status;
      }
    } else if (!each.status) {
      notes_.warn(each.status.error().text());
    } else if (!each.was_gone) {
      retention_.countDeleted(each.facts);
      notes_.say(fmt::format("{} is deleted ({})", path, size));
    }
  }
  return outcome;
}

RecordedFiles PieceShelf::files() const {
  return {{retention_.kept().begin(), retention_.kept().end()}, retention_.deleted()};
}

}  // namespace rocinante
