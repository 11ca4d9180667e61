#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/program/render_moments.h"

namespace rocinante {

/// How the files of a job are named: docs/programs/render.md, section "Names of files".
struct RenderFiles {
  std::filesystem::path output, sheet, video, identity, depth;  ///< as asked for; empty: not
  std::filesystem::path frames;                                 ///< a folder
  std::vector<std::string> cameras;  ///< as asked for; one empty name when none was
  std::vector<RenderMoment> moments;

  /// `file` for one camera of several: "f.png" becomes "f.overview.png".
  std::filesystem::path ofCamera(const std::filesystem::path& file, std::size_t camera) const;
  /// The same for one of several moments as well: "ids-00001.overview.png".
  std::filesystem::path ofMoment(const std::filesystem::path& file, std::size_t moment,
                                 std::size_t camera) const;
  /// In `frames`: "frame-00001.png", "frame-00003-picked.png", "overview/frame-00001.png".
  std::filesystem::path frame(std::size_t moment, std::size_t camera) const;

  /// All that will be written; refused when two are one, or one is there already.
  Status check(bool overwrite) const;
};

/// Text as a part of a file's name: letters, digits, dots inside, `_` and `-` stay, each run of
/// anything else becomes one `_`; at most 60 bytes. "unnamed" where nothing is left.
std::string fileNamePart(std::string_view text);

}  // namespace rocinante
