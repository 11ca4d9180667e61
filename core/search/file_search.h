#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/search/found_file.h"

namespace rocinante {

class PackageNames;

/// Finds files by the names that models use, within search roots and nowhere else
/// (docs/cell-format.md, section "Where files are looked for"). Links are followed before a
/// file is judged to lie within. Touches the file system only to look; opens package.xml alone.
class FileSearch {
 public:
  FileSearch();

  /// Notes roots and lookups in `lookups` from now on; borrowed.
  void noteIn(FileLookups* lookups) { lookups_ = lookups; }
  /// Names mean what `answers` say from now on: nothing is looked for, and roots mean nothing.
  void answerFrom(FileAnswers answers) { answers_ = std::move(answers); }

  /// A root that does not exist is refused by its name.
  Status addRoot(const std::filesystem::path& root);
  /// The roots of ROCINANTE_PATH, AMENT_PREFIX_PATH (with and without share) and ROS_PACKAGE_PATH;
  /// entries that do not exist are left out.
  void addEnvironmentRoots();
  /// What a package's name means. The first of a name counts; a folder that does not exist is
  /// refused by its name.
  Status addPackage(const PackageFolder& package);
  /// For a bare model file: the package that it lies in (the nearest folder above with a
  /// package.xml) becomes a root, and a folder above that is a package which the model names.
  void setPackagesAbove(const std::filesystem::path& folder);

  /// `beside` is the folder of the file that says `name`. What that file itself was found as is
  /// `within`: its root counts for what it names, also where that is only a package's folder.
  FoundFile find(const std::string& name, const std::filesystem::path& beside,
                 const FoundFile* within = nullptr) const;
  /// The same without noting it; any number of threads at once.
  FoundFile look(const std::string& name, const std::filesystem::path& beside,
                 const FoundFile* within = nullptr) const;
  /// Notes what look() gave.
  void note(const FileLookup& lookup) const;

  /// The path as find() would give it when `file` lies within a root; no_file, outside, missing.
  FoundFile check(const std::filesystem::path& file) const;

 private:
  struct Root {
    std::filesystem::path given;
    std::filesystem::path canonical;
    bool holds(const std::filesystem::path& path) const;  ///< one without links
  };
  struct Package {
    std::string name;
    Root folder;
  };
  using Folders = std::vector<std::filesystem::path>;
  FoundFile checkIn(const std::vector<Root>& roots, const std::filesystem::path& file) const;
  FoundFile lookFor(const std::string& name, const std::filesystem::path& beside,
                    const FoundFile* within) const;
  FoundFile lookInPackage(const Package& package, const std::string& path) const;
  /// Folders above the bare model that are the package: its roots.
  void addPackagesAbove(const std::string& name, std::vector<Root>& roots) const;
  /// Folders at and about `from` and the roots that say in their package.xml to be the package.
  Folders saidPackages(const std::string& name, const std::filesystem::path& from,
                       const std::vector<Root>& roots) const;
  /// Says of a file of a package what was looked for, and what is near.
  void explain(const std::string& name, const std::string& path, const std::filesystem::path& from,
               const std::vector<Root>& roots, FoundFile& missing) const;

  FileLookups* lookups_ = nullptr;
  FileAnswers answers_;
  std::vector<Root> roots_;
  std::vector<Package> packages_;
  std::filesystem::path packages_above_;  // empty: none
  std::shared_ptr<PackageNames> names_;
};

/// The bytes of a regular file of at most `most_bytes`; not_found, unreadable, or unsupported when
/// it is larger or no regular file.
Result<Bytes> readWholeFile(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace rocinante
