#include "recorder/pieces/piece_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/log/log_profile.h"
#include "core/recording/seam.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kRetry = std::chrono::seconds(1);

}  // namespace

PieceSequence::PieceSequence(MadePiece first, Options options, NoteBox& notes)
    : options_(std::move(options)),
      notes_(notes),
      piece_(std::make_unique<PieceLog>(std::move(first), options_.keyframes)),
      shelf_(options_.limits, notes) {
  opening_bytes_ = seen_bytes_ = piece_->bytes();
}

Status PieceSequence::begin(const SessionState& preceding, LogTime moment) {
  Status begun = piece_->begin(preceding, moment, std::nullopt);
  opening_bytes_ = seen_bytes_ = piece_->bytes();
  return begun;
}

bool PieceSequence::wanted(LogTime time) const {
  if (asked_ || full_) return true;
  return options_.split.time > Nanoseconds(0) && time_cell_ &&
         time >= *time_cell_ + options_.split.time;
}

bool PieceSequence::seamDue(LogTime time) {
  if (!wanted(time)) return false;
  if (!options_.make_next || piece_->empty()) {
    asked_ = false;
    return false;
  }
  // Datagrams of one time stay together.
  if (time <= piece_->lastTime()) return false;
  if (retry_at_ && time < *retry_at_) return false;
  if (!wanted_since_) wanted_since_ = time;
  return seamFits(piece_->state(), time, *wanted_since_);
}

Status PieceSequence::seam(LogTime time) {
  const auto ours = [&](const std::filesystem::path& path) {
    return (piece_->file().path == path && piece_->file().isThere()) || shelf_.holds(path);
  };
  // Flush before the next piece is created, which may take a while with a large cell: a kill
  // meanwhile loses nothing given to this one, and what the disk refuses can still be reported in
  // it.
  if (Status flushed = piece_->flushAll(); !flushed) return flushed;
  Result<MadePiece> made = options_.make_next(time, ours);
  if (!made) {
    retry_at_ = time + kRetry;
    const std::string trouble = made.error().text();
    if (trouble != last_trouble_) {
      notes_.warn(fmt::format("cannot create the next piece; recording continues in {}: {}",
                              piece_->file().path.string(), trouble));
      last_trouble_ = trouble;
    }
    return {};
  }
  auto next = std::make_unique<PieceLog>(std::move(*made), options_.keyframes);
  Status begun = next->begin(piece_->state(), time, origin_);
  std::swap(piece_, next);
  shelf_.put(std::move(next), std::string(profile::kSplitReason));
  asked_ = full_ = false;
  wanted_since_.reset();
  retry_at_.reset();
  last_trouble_.clear();
  opening_bytes_ = seen_bytes_ = piece_->bytes();
  largest_step_ = 0;
  shelf_.keepLimits(piece_->bytes());
  return begun;
}

Status PieceSequence::write(const CapturedDatagram& datagram) {
  if (!origin_ && datagram.captured()) origin_ = datagram.time;
  if (piece_->empty() && options_.split.time > Nanoseconds(0)) {
    time_cell_ = intervalBegin(datagram.time, origin_.value_or(datagram.time), options_.split.time);
  }
  Status written = piece_->write(datagram);
  if (options_.split.size_bytes > 0) noteSize();
  return written;
}

/// A piece is full when one more step as large as its largest would exceed the wanted size. It
/// holds at least as much as its opening, or only openings would be written.
void PieceSequence::noteSize() {
  const std::uint64_t bytes = piece_->bytes();
  if (bytes == seen_bytes_) return;
  largest_step_ = std::max(largest_step_, bytes - std::min(bytes, seen_bytes_));
  seen_bytes_ = bytes;
  full_ = bytes + largest_step_ > options_.split.size_bytes && bytes >= 2 * opening_bytes_;
}

void PieceSequence::tellDisturbance() {
  if (const auto disturbed = piece_->newDisturbance()) notes_.warn(disturbed->text());
}

Status PieceSequence::flush(LogTime, SteadyTime now) {
  Status flushed = piece_->flush(now);
  tellDisturbance();
  shelf_.keepLimits(piece_->bytes());
  Status settled = shelf_.settle();
  return flushed ? settled : flushed;
}

Status PieceSequence::close(const std::string& reason) {
  Status closed = piece_->close(reason);
  tellDisturbance();
  // The end of the piece counts too.
  shelf_.keepLimits(piece_->bytes());
  Status settled = shelf_.finish();
  return closed ? settled : closed;
}

std::vector<std::uint64_t> PieceSequence::refusedByFlow() const {
  std::vector<std::uint64_t> refused = shelf_.refusedByFlow();
  piece_->addRefused(refused);
  return refused;
}

RecordedFiles PieceSequence::files() const {
  RecordedFiles files = shelf_.files();
  files.pieces.push_back(piece_->facts());
  return files;
}

}  // namespace rocinante
