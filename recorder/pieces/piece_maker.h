#pragma once

#include <memory>
#include <string>

#include "core/bundle/cell_bundle.h"
#include "core/foreign/decode/decoder_set.h"
#include "core/recording/piece_log.h"
#include "core/recording/piece_namer.h"
#include "recorder/pieces/note_box.h"

namespace rocinante {

/// Creates the logs of one session: each with its own name, the session's id, the cell and the
/// decoders.
class PieceMaker {
 public:
  struct Options {
    PieceNamer::Options naming;
    LogWriterOptions writing;
    std::string session_id;
    std::shared_ptr<const CellBundle> cell;  ///< attached to each log; null for none
    bool attach_once = false;                ///< the cell to the first only
    /// Attached to each log; null for none.
    std::shared_ptr<const decode::DecoderSet> decoders;
    NoteBox* notes = nullptr;  ///< may be null
  };

  explicit PieceMaker(Options options) : options_(std::move(options)), namer_(options_.naming) {}

  /// A log that begins at `start`. Creates its folder if only the last one is missing. Leaves no
  /// incomplete file behind.
  Result<MadePiece> make(LogTime start, const PieceNamer::Ours& ours);

 private:
  Error failed(Error error);

  Options options_;
  PieceNamer namer_;
  bool attached_ = false;
  bool lockless_reported_ = false;
};

}  // namespace rocinante
