#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/program/render_moments.h"

namespace rocinante {

/// The file names of a job: docs/programs/render.md, section "Names of files".
struct RenderFiles {
  std::filesystem::path output, sheet, video, identity, depth;  ///< as requested; empty: none
  std::filesystem::path frames;                                 ///< a folder
  std::vector<std::string> cameras;  ///< as requested; one empty name for the default
  std::vector<RenderMoment> moments;
  std::string frame_type = "png";  ///< the ending in `frames`

  /// `file` for one camera of several: "f.png" becomes "f.overview.png".
  std::filesystem::path ofCamera(const std::filesystem::path& file, std::size_t camera) const;
  /// The same for one of several moments as well: "ids-00001.overview.png".
  std::filesystem::path ofMoment(const std::filesystem::path& file, std::size_t moment,
                                 std::size_t camera) const;
  /// In `frames`: "frame-00001.png", "frame-00003-picked.png", "overview/frame-00001.png".
  std::filesystem::path frame(std::size_t moment, std::size_t camera) const;

  /// Checks all files; refused when two have the same name or one exists.
  Status check(bool overwrite) const;
};

/// Text as part of a file name: letters, digits, inner dots, `_` and `-` stay, each run of other
/// bytes becomes one `_`; at most 60 bytes. "unnamed" when nothing is left.
std::string fileNamePart(std::string_view text);

}  // namespace rocinante
