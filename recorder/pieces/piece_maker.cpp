#include "recorder/pieces/piece_maker.h"

#include <fmt/format.h>

#include <utility>

#include "core/foreign/decode/carried_decoders.h"

namespace rocinante {

Error PieceMaker::failed(Error error) {
  namer_.takeBack();
  return error;
}

Result<MadePiece> PieceMaker::make(LogTime start, const PieceNamer::Ours& ours) {
  const Result<std::filesystem::path> path = namer_.next(start, ours);
  if (!path) return failed(path.error());
  std::error_code ignored;
  const std::filesystem::path folder = path->parent_path();
  const bool made_folder = !folder.empty() && std::filesystem::create_directory(folder, ignored);
  Result<LogWriter> log = LogWriter::create(*path, options_.writing, options_.session_id);
  if (!log) {
    if (made_folder) std::filesystem::remove(folder, ignored);
    return failed(log.error());
  }
  if (!log->locked() && options_.notes != nullptr && !std::exchange(lockless_reported_, true)) {
    options_.notes->say(
        fmt::format("the file system of {} has no locks: nothing stops a second program from "
                    "writing the same file",
                    path->string()));
  }
  const PieceFile file = PieceFile::at(*path);
  Status attached;
  if (options_.decoders) attached = decode::attachDecoders(*options_.decoders, *log, start);
  const bool with_cell = options_.cell && !(options_.attach_once && attached_);
  if (attached && with_cell) attached = AttachedBundle(*options_.cell).writeTo(*log, start);
  if (!attached) {
    // A log without its cell or decoders is not kept.
    if (file.isThere()) std::filesystem::remove(*path, ignored);
    return failed(attached.error());
  }
  attached_ = attached_ || with_cell;
  return MadePiece{std::move(*log), file};
}

}  // namespace rocinante
