#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// The media type of a file by the ending of its name; application/octet-stream when the ending is
/// unknown.
std::string mediaTypeOf(std::string_view name);

/// `text` as a manifest can hold it: invalid UTF-8 and control characters become %XX.
std::string manifestWord(std::string_view text);

/// Gives files the names that they have in a bundle, so that their relative places are kept: the
/// cell's own below the folder that its folder and its search roots have in common; those of other
/// roots (--search) below search/1/NAME, search/2/NAME and so on, where NAME is the root's. All
/// paths are absolute and without links.
class BundleNames {
 public:
  /// `main_folder` is that of the cell's file.
  explicit BundleNames(std::filesystem::path main_folder);

  /// A root of the cell's own that holds files.
  void addOwnRoot(const std::filesystem::path& root);
  /// A root given by the user, or one where the cell finds a file although it has no folder in
  /// common with the cell.
  void addOtherRoot(const std::filesystem::path& root);

  const std::filesystem::path& commonFolder() const { return common_; }

  /// The name of a file or folder. Empty for the common folder itself, and for a path outside all
  /// roots.
  std::string nameOf(const std::filesystem::path& path) const;
  /// The bundle's names of the other roots, as they were added.
  std::vector<std::string> otherRoots() const;

 private:
  std::filesystem::path common_;
  std::vector<std::filesystem::path> others_;
};

}  // namespace rocinante
