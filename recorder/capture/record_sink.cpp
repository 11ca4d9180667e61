#include "recorder/capture/record_sink.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/base/figure_text.h"
#include "core/base/random_id.h"
#include "core/recording/record_path.h"
#include "recorder/pieces/piece_maker.h"

namespace rocinante {
namespace {

/// Bytes of one endpoint's loss message in the log, with its index.
constexpr std::uint64_t kLossBytes = 512;
/// Chunks to aim for in a piece, so that pieces come close to their size.
constexpr std::uint64_t kChunksInPiece = 16;
constexpr std::uint64_t kLeastChunkBytes = 4'096;
/// Pieces per disk quota: deleting the oldest loses a small part of the whole.
constexpr std::uint64_t kPiecesInQuota = 8;

std::uint64_t cellBytes(const RecordOptions& options) {
  std::uint64_t bytes = 0;
  if (options.cell) {
    for (const Bytes& each : options.cell->contents) bytes += each.size();
  }
  return bytes;
}

SplitRule splitOf(const RecordOptions& options) {
  SplitRule split = options.split;
  if (split.size_bytes == 0 && options.limits.disk_quota_bytes) {
    split.size_bytes = *options.limits.disk_quota_bytes / kPiecesInQuota;
  }
  return split;
}

/// A piece that the cell alone fills would be followed by another without end.
Status checkSizes(const RecordOptions& options, const SplitRule& split) {
  const std::uint64_t cell = cellBytes(options);
  const std::uint64_t each = options.attach_once ? 0 : cell;
  if (options.limits.disk_quota_bytes && each >= *options.limits.disk_quota_bytes) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("--disk-quota {} is too small for one log: its cell alone takes {}",
                             sizeText(*options.limits.disk_quota_bytes), sizeText(cell)),
                 {}};
  }
  if (!options.ring && split.size_bytes > 0 && each >= split.size_bytes) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the cell takes {} of each piece of {}: use larger pieces or "
                             "--attach-once",
                             sizeText(cell), sizeText(split.size_bytes)),
                 {}};
  }
  return {};
}

/// A flight recorder must find out before the accident that it cannot write.
Status checkFolder(const RecordOptions& options, LogTime now) {
  const auto path = recordPath(options.log.string(), WallTime(now.time_since_epoch()));
  if (!path) return path.error();
  std::filesystem::path folder = path->has_parent_path() ? path->parent_path() : ".";
  std::error_code ignored;
  // The last folder will be created.
  if (!std::filesystem::exists(folder, ignored)) {
    folder = folder.has_parent_path() ? folder.parent_path() : ".";
  }
  // Create a file: permission bits do not tell everything that can refuse.
  std::string probe = (folder / ".rocinante-XXXXXX").string();
  const int file = ::mkstemp(probe.data());
  if (file >= 0) {
    ::close(file);
    ::unlink(probe.c_str());
    return {};
  }
  return Error{ErrorKind::unreadable,
               std::string("cannot create a file there: ") + std::strerror(errno), folder.string()};
}

}  // namespace

Result<RecordSink> makeSink(const RecordOptions& options, LogTime now, NoteBox& notes) {
  const SplitRule split = splitOf(options);
  if (Status sizes = checkSizes(options, split); !sizes) return sizes.error();
  PieceMaker::Options making;
  making.naming.output = options.log.string();
  making.naming.several =
      options.ring || split.size_bytes > 0 || split.time > Nanoseconds(0) || options.limits.keep;
  making.naming.overwrite = options.writing.overwrite;
  making.writing = options.writing;
  making.writing.closing_room_bytes += kLossBytes * options.endpoints.size();
  if (!options.ring && split.size_bytes > 0) {
    const auto wanted = std::max(split.size_bytes / kChunksInPiece, kLeastChunkBytes);
    making.writing.chunk_bytes =
        std::min(making.writing.chunk_bytes, static_cast<std::size_t>(wanted));
  }
  making.session_id = randomId(16);
  making.cell = options.cell;
  making.attach_once = options.attach_once;
  making.decoders = options.decoders;
  making.notes = &notes;
  auto maker = std::make_shared<PieceMaker>(std::move(making));
  PieceSequence::MakePiece make = [maker](LogTime start, const PieceNamer::Ours& ours) {
    return maker->make(start, ours);
  };
  if (options.ring) {
    if (Status folder = checkFolder(options, now); !folder) return folder.error();
    RingRecording::Options ring{*options.ring,   options.limits,  {},
                                std::move(make), options.ring_on, options.watch};
    return RecordSink{std::make_unique<RingRecording>(std::move(ring), notes),
                      options.log.string()};
  }
  Result<MadePiece> first = make(now, [](const auto&) { return false; });
  if (!first) return first.error();
  std::string name = first->file.path.string();
  PieceSequence::Options pieces{split, options.limits, {}, std::move(make)};
  return RecordSink{std::make_unique<PieceSequence>(std::move(*first), std::move(pieces), notes),
                    std::move(name)};
}

std::unique_ptr<CaptureSink> sinkOf(LogWriter log, const RecordOptions& options, NoteBox& notes) {
  MadePiece made{std::move(log), PieceFile::at(options.log)};
  return std::make_unique<PieceSequence>(std::move(made), PieceSequence::Options(), notes);
}

}  // namespace rocinante
