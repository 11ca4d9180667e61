#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rocinante {

/// The path as somebody types it from the current folder.
std::string typedPath(const std::filesystem::path& path);

/// Whether the name ends as meshes, their materials and buffers, and pictures do. In either case.
bool isMeshOrTexture(const std::filesystem::path& path);

/// The result of looking for a file that a cell or model names.
struct FoundFile {
  enum class Why : std::uint8_t {
    found,
    found_elsewhere,  ///< an absolute name of another machine, found by its last parts
    missing,
    outside,     ///< it exists, but not within the search roots (a link out of them counts)
    no_file,     ///< a folder, a device, a pipe
    remote,      ///< http:, https:, ftp:
    expression,  ///< $(find pkg) and the like: a template, not a name
  };
  Why why = Why::missing;
  std::filesystem::path path;  ///< empty unless found; begins as the root was given
  std::filesystem::path root;  ///< that contains it, without links; empty unless found
  std::filesystem::path root_as_given;
  bool root_for_meshes = false;  ///< only meshes and textures are found in that root
  /// The folder, without links, of the named package when the folder's own name differs; else
  /// empty.
  std::filesystem::path package;
  /// More about a missing file, for problem() and hint().
  std::string detail, advice;
  /// "there is no such file within the search roots", for a fault's message; empty when found.
  std::string problem() const;
  std::string hint() const;
};

/// A name that was looked for, and the result.
struct FileLookup {
  std::filesystem::path beside;  ///< the folder of the file that contains the name
  std::string name;
  FoundFile found;
};

/// The record of a search, so that it can be repeated elsewhere.
struct FileLookups {
  std::vector<std::filesystem::path> roots;  ///< without links, in the order they are looked into
  std::vector<FileLookup> lookups;           ///< each as often as it came
};

/// Results known beforehand: FileLookup::found by name and folder.
using FileAnswers =
    std::function<FoundFile(const std::string& name, const std::filesystem::path& beside)>;

}  // namespace rocinante
