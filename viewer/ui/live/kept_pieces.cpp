#include "viewer/ui/live/kept_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/random_id.h"
#include "core/foreign/decode/carried_decoders.h"
#include "core/log/log_profile.h"
#include "core/recording/seam.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kPieces = 10;

RetentionLimits retentionOf(const KeepLimits& limits) {
  RetentionLimits kept;
  kept.disk_quota_bytes = limits.bytes;
  kept.span = limits.time;
  return kept;
}

}  // namespace

KeptPieces::KeptPieces(std::filesystem::path folder, const KeepLimits& limits,
                       std::shared_ptr<const decode::DecoderSet> decoders)
    : folder_(std::move(folder)),
      limits_(limits),
      decoders_(std::move(decoders)),
      session_id_(randomId(16)),
      retention_(retentionOf(limits)) {}

std::filesystem::path KeptPieces::first() const {
  if (!retention_.kept().empty()) return retention_.kept().front().file.path;
  return piece_ ? piece_->file().path : std::filesystem::path();
}

std::vector<std::filesystem::path> KeptPieces::finished() const {
  std::vector<std::filesystem::path> paths;
  for (const PieceFacts& piece : retention_.kept()) paths.push_back(piece.file.path);
  return paths;
}

std::uint64_t KeptPieces::bytes() const {
  return retention_.bytes() + (piece_ ? piece_->bytes() : 0);
}

std::optional<std::string> KeptPieces::takeDisturbance() {
  return std::exchange(disturbance_, std::nullopt);
}

bool KeptPieces::seamDue(LogTime time) {
  if (!piece_ || piece_->empty() || time <= piece_->lastTime()) return false;
  const bool wanted =
      piece_->bytes() >= limits_.bytes / kPieces || time - *piece_began_ >= limits_.time / kPieces;
  if (!wanted) return false;
  if (!seam_wanted_) seam_wanted_ = time;
  return seamFits(piece_->state(), time, *seam_wanted_);
}

Status KeptPieces::seam(LogTime) { return closePiece(std::string(profile::kSplitReason)); }

Status KeptPieces::openPiece(LogTime time) {
  const std::filesystem::path path = folder_ / fmt::format("live-{:06}.mcap", ++made_);
  LogWriterOptions options;
  // Pieces of a small limit come close to it.
  options.chunk_bytes = static_cast<std::size_t>(
      std::clamp<std::uint64_t>(limits_.bytes / kPieces / 16, 4096, options.chunk_bytes));
  Result<LogWriter> log = LogWriter::create(path, options, session_id_);
  if (!log) return log.error();
  if (decoders_) {
    if (Status attached = decode::attachDecoders(*decoders_, *log, time); !attached) {
      return attached;
    }
  }
  piece_ = std::make_unique<PieceLog>(MadePiece{std::move(*log), PieceFile::at(path)},
                                      KeyframeOptions{});
  piece_began_ = time;
  if (Status begun = piece_->begin(state_, time, origin_); !begun) return begun;
  for (const LossSpan& span : std::exchange(waiting_losses_, {})) {
    if (Status written = piece_->writeLoss(span); !written) return written;
  }
  for (const ClockStep& step : std::exchange(waiting_steps_, {})) {
    if (Status written = piece_->writeStep(step); !written) return written;
  }
  return {};
}

Status KeptPieces::closePiece(const std::string& reason) {
  seam_wanted_.reset();
  if (!piece_) return {};
  const std::unique_ptr<PieceLog> piece = std::move(piece_);
  state_ = piece->state();
  finished_until_ = piece->lastTime().value_or(finished_until_) + Nanoseconds(1);
  Status closed = piece->close(reason);
  if (const auto trouble = piece->newDisturbance()) disturbance_ = trouble->text();
  piece->addRefused(refused_);
  bytes_ever_ += piece->bytes();
  retention_.add(piece->facts());
  deleteSurplus();
  return closed;
}

void KeptPieces::deleteSurplus() {
  if (held_) return;
  const auto current =
      piece_ ? std::optional<std::uint64_t>(piece_->bytes()) : std::optional<std::uint64_t>();
  for (const PieceFacts& piece : retention_.surplus(current, reached_)) {
    std::error_code ignored;
    // Another file may have its name by now.
    if (piece.file.isThere()) std::filesystem::remove(piece.file.path, ignored);
    std::filesystem::remove(piece.file.path.string() + ".marks", ignored);
    retention_.countDeleted(piece);
  }
}

Status KeptPieces::write(const CapturedDatagram& datagram) {
  if (!origin_ && datagram.captured()) origin_ = datagram.time;
  if (!piece_) {
    if (Status opened = openPiece(datagram.time); !opened) return opened;
  }
  reached_ = datagram.time;
  return piece_->write(datagram);
}

Status KeptPieces::writeLoss(const LossSpan& span) {
  if (piece_) return piece_->writeLoss(span);
  waiting_losses_.push_back(span);
  return {};
}

Status KeptPieces::writeStep(const ClockStep& step) {
  if (piece_) return piece_->writeStep(step);
  waiting_steps_.push_back(step);
  return {};
}

Status KeptPieces::flush(LogTime reached, SteadyTime now) {
  Status done;
  if (finish_at_ && reached >= *finish_at_) {
    if (!piece_ || seamFits(piece_->state(), reached, *finish_at_)) {
      const LogTime until = *std::exchange(finish_at_, std::nullopt);
      done = closePiece(std::string(profile::kSplitReason));
      finished_until_ = std::max(finished_until_, until);
    }
  }
  if (!piece_) return done;
  const Status flushed = piece_->flush(now);
  if (const auto trouble = piece_->newDisturbance()) disturbance_ = trouble->text();
  deleteSurplus();
  return done ? flushed : done;
}

Status KeptPieces::close(const std::string& reason) { return closePiece(reason); }

std::vector<std::uint64_t> KeptPieces::refusedByFlow() const {
  std::vector<std::uint64_t> refused = refused_;
  if (piece_) piece_->addRefused(refused);
  return refused;
}

}  // namespace rocinante
