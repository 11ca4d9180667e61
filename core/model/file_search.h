#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/bytes.h"
#include "core/result.h"

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

/// Finds files by the names that models use, within search roots and nowhere else
/// (docs/cell-format.md, section "Where files are looked for"). Links are followed before a
/// file is judged to lie within. Touches the file system only to look; opens nothing.
class FileSearch {
 public:
  /// Notes roots and lookups in `lookups` from now on; borrowed.
  void noteIn(FileLookups* lookups) { lookups_ = lookups; }
  /// Names mean what `answers` say from now on: nothing is looked for, and roots mean nothing.
  void answerFrom(FileAnswers answers) { answers_ = std::move(answers); }

  /// A root that does not exist is refused by its name.
  Status addRoot(const std::filesystem::path& root);
  /// The roots of ROCINANTE_PATH, AMENT_PREFIX_PATH (with and without share) and ROS_PACKAGE_PATH;
  /// entries that do not exist are left out.
  void addEnvironmentRoots();
  /// For a bare model file: a folder above it that is named as a package becomes a root when the
  /// model names that package.
  void setPackagesAbove(const std::filesystem::path& folder);

  /// `beside` is the folder of the file that says `name`.
  FoundFile find(const std::string& name, const std::filesystem::path& beside) const;
  /// The same without noting it; any number of threads at once.
  FoundFile look(const std::string& name, const std::filesystem::path& beside) const;
  /// Notes what look() gave.
  void note(const FileLookup& lookup) const;

  /// The path as find() would give it when `file` lies within a root; no_file, outside, missing.
  FoundFile check(const std::filesystem::path& file) const;

 private:
  struct Root {
    std::filesystem::path given;
    std::filesystem::path canonical;
  };
  FoundFile checkIn(const std::vector<Root>& roots, const std::filesystem::path& file) const;
  FoundFile lookFor(const std::string& name, const std::filesystem::path& beside) const;

  FileLookups* lookups_ = nullptr;
  FileAnswers answers_;
  std::vector<Root> roots_;
  std::filesystem::path packages_above_;  // empty: none
};

/// The bytes of a regular file of at most `most_bytes`; not_found, unreadable, or unsupported when
/// it is larger or no regular file.
Result<Bytes> readWholeFile(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace rocinante
