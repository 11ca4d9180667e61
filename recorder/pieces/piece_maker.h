#pragma once

#include <memory>
#include <string>

#include "core/bundle/cell_bundle.h"
#include "core/recording/piece_log.h"
#include "core/recording/piece_namer.h"
#include "recorder/pieces/note_box.h"

namespace rocinante {

/// Makes the logs of one session, one after another: each with a name of its own, the session's
/// id, and the cell.
class PieceMaker {
 public:
  struct Options {
    PieceNamer::Options naming;
    LogWriterOptions writing;
    std::string session_id;
    std::shared_ptr<const CellBundle> cell;  ///< attached to each; null: none
    bool attach_once = false;                ///< to the first alone
    NoteBox* notes = nullptr;                ///< null: nobody listens
  };

  explicit PieceMaker(Options options) : options_(std::move(options)), namer_(options_.naming) {}

  /// One that begins at `start`. Its folder is made when only that is missing. What could not be
  /// made whole is not left behind.
  Result<MadePiece> make(LogTime start, const PieceNamer::Ours& ours);

 private:
  Error failed(Error error);

  Options options_;
  PieceNamer namer_;
  bool attached_ = false;
  bool lockless_told_ = false;
};

}  // namespace rocinante
