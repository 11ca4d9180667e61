#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "core/base/result.h"
#include "core/base/time.h"
#include "viewer/ui/panels/frame_times.h"

namespace rocinante {

/// A frame that the window has shown.
struct ShownFrame {
  SteadyTime shown_at{};
  WallTime shown_wall{};
  LogTime moment{};     ///< of the session; the newest datagram's in live mode
  bool loaded = false;  ///< what was asked for is there
  bool drawn = false;   ///< the scene was drawn, not the panels alone
  int level = 0;        ///< of detail
  bool whole = false;   ///< the picture has everything, at full resolution
  FrameTimes times;     ///< of the scene's last drawing
};

/// Writes a line of CSV for each frame, for measurements: docs/programs/view.md, section "Detail".
/// Main thread.
class FrameJournal {
 public:
  /// Begins the file anew.
  static Status begin(const std::filesystem::path& file);
  /// Continues it; without a file the journal writes nothing.
  static Result<FrameJournal> open(const std::filesystem::path& file);

  bool active() const { return file_ != nullptr; }
  void add(const ShownFrame& frame);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace rocinante
