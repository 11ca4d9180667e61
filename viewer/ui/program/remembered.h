#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "viewer/ui/model/view_memory.h"
#include "viewer/ui/program/view_content.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// Brings what was remembered of the user into the window and keeps what the user did there. A file
/// that cannot be read is named and never written. One that cannot be written is named. Main
/// thread.
class Remembered {
 public:
  /// `wanted` false: under a script or with --fresh, nothing is read or written.
  static Remembered load(bool wanted);

  /// Width and height of the window: those of the arguments unless 0, else the last ones.
  std::pair<int, int> sizeFor(int width, int height) const;
  bool isLight() const { return memory_.theme == Theme::light; }
  /// Theme, recent files and the places of panels, before the content is shown.
  void apply(ViewContent& content);
  /// The same, and the window's size, after it was shown.
  void keep(const ViewContent& content, const Window& window);
  /// Adds it to what other windows have saved meanwhile.
  void save() const;

 private:
  ViewMemory memory_;
  std::filesystem::path file_;  ///< empty: nothing is written
  std::vector<RecentContent> shown_;
};

}  // namespace rocinante
