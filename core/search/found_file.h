#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rocinante {

/// What became of a name that a cell or model gives for a file.
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
  std::filesystem::path root;  ///< in which it lies, without links; empty unless found
  std::filesystem::path root_as_given;
  /// The folder, without links, of the package that the name says, where the folder itself is named
  /// otherwise; else empty.
  std::filesystem::path package;
  /// What is known besides about a file that is missing: parts of problem() and hint().
  std::string detail, advice;
  /// "there is no such file within the search roots", for a fault's sentence; empty when found.
  std::string problem() const;
  std::string hint() const;
};

/// A name that was looked for, and what became of it.
struct FileLookup {
  std::filesystem::path beside;  ///< the folder of the file that says the name
  std::string name;
  FoundFile found;
};

/// What a search did, for those who must do it again elsewhere.
struct FileLookups {
  std::vector<std::filesystem::path> roots;  ///< without links, in the order they are looked into
  std::vector<FileLookup> lookups;           ///< each as often as it came
};

/// What the names mean where that is known beforehand: FileLookup::found by name and folder.
using FileAnswers =
    std::function<FoundFile(const std::string& name, const std::filesystem::path& beside)>;

}  // namespace rocinante
