#pragma once

#include <atomic>
#include <cstdint>

#include "recorder/capture/capture_file_loop.h"
#include "recorder/pieces/note_box.h"

namespace rocinante {

/// Reads a stream that a server keeps (jetstream://) into a HandOver: by the stream's times, as
/// fast as the log is written, without dropping anything. It tells the source what is saved.
/// One thread, besides noteSaved().
class StreamLoop final : public CaptureFileLoop {
 public:
  /// All three must outlive the loop; `notes` gets what the source says of its connection.
  StreamLoop(DatagramSource& source, HandOver& out, LogTime begins, NoteBox& notes)
      : CaptureFileLoop(source, out, begins), notes_(notes) {}

  bool isLive() const override { return true; }
  bool keepsPlace() const override { return true; }
  void noteSaved(std::uint64_t count) override { saved_.store(count); }
  /// Also false when the stream had nothing.
  Result<bool> pass() override;
  Status finish() override;

 private:
  bool passEmpty() override;
  void noteGone();

  NoteBox& notes_;
  std::atomic<std::uint64_t> saved_{0};
  std::uint64_t gone_ = 0;  ///< from the stream, of those noted
};

}  // namespace rocinante
