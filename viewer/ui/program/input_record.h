#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "viewer/ui/window/frame_input.h"

namespace rocinante {

/// The script commands that make `seen` of what the frame before it saw; empty: nothing changed.
std::string inputLines(const FrameInput& before, const FrameInput& seen);

/// Writes what a person does with a window as a script that does it again, frame by frame at its
/// times (docs/programs/view.md, section "Recording input"). A killed window leaves a script of all
/// frames but perhaps the last. Main thread.
class InputRecord {
 public:
  /// Begins the file anew. An empty name: nothing is recorded.
  static Result<InputRecord> begin(const std::filesystem::path& file);

  bool active() const { return file_ != nullptr; }
  /// A frame that was begun at `now`. Times are counted from the first one's.
  void add(const FrameInput& seen, SteadyTime now);
  void addDrop(const std::vector<std::filesystem::path>& files);
  /// Files that were opened are shown, or cannot be.
  void addFilesCame();
  /// Why recording ended early, once: a sentence.
  std::optional<std::string> takeFault();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void write(const std::string& text);

  std::unique_ptr<std::FILE, Closer> file_;
  std::filesystem::path name_;
  FrameInput before_;
  std::optional<SteadyTime> began_;
  std::optional<Nanoseconds> last_;
  std::optional<std::string> fault_;
};

}  // namespace rocinante
