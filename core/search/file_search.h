#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/search/found_file.h"

namespace rocinante {

class PackageNames;
class SearchFacts;

/// Finds files by the names that models use, within search roots and nowhere else
/// (docs/cell-format.md, section "Where files are looked for"). Links are followed before a file
/// counts as inside a root. Only reads the file system; opens no file but package.xml.
class FileSearch {
 public:
  FileSearch();

  /// Notes roots and lookups in `lookups` from now on; borrowed.
  void noteIn(FileLookups* lookups) { lookups_ = lookups; }
  /// Notes what the file system answers from now on in `facts`; borrowed.
  void noteFactsIn(SearchFacts* facts);
  /// From now on names are resolved by `answers` alone: nothing is looked for, and roots are
  /// ignored.
  void answerFrom(FileAnswers answers) { answers_ = std::move(answers); }

  /// Refuses a root that does not exist, naming it.
  Status addRoot(const std::filesystem::path& root);
  /// The roots of ROCINANTE_PATH, AMENT_PREFIX_PATH (with and without share) and ROS_PACKAGE_PATH;
  /// entries that do not exist are left out.
  void addEnvironmentRoots();
  /// Maps a package's name to a folder. The first of a name is used. Refuses a folder that does not
  /// exist, naming it.
  Status addPackage(const PackageFolder& package);
  /// For a bare model file: its package (the nearest folder above with a package.xml) becomes a
  /// root, and so does a folder above that is a package which the model names; of one beside the
  /// nearest folders above, meshes and textures are found.
  void setPackagesAbove(const std::filesystem::path& folder);

  /// `beside` is the folder of the file that contains `name`. `within` is how that file itself was
  /// found: its root counts for names in it, even if it is only a package's folder.
  FoundFile find(const std::string& name, const std::filesystem::path& beside,
                 const FoundFile* within = nullptr) const;
  /// The same without noting it; any number of threads at once.
  FoundFile look(const std::string& name, const std::filesystem::path& beside,
                 const FoundFile* within = nullptr) const;
  /// Notes the result of look().
  void note(const FileLookup& lookup) const;

  /// The path as find() would give it when `file` is inside a root; no_file, outside, missing.
  FoundFile check(const std::filesystem::path& file) const;

 private:
  struct Root {
    std::filesystem::path given;
    std::filesystem::path canonical;
    bool for_meshes = false;                              ///< isMeshOrTexture() only
    bool holds(const std::filesystem::path& path) const;  ///< one without links
  };
  struct Package {
    std::string name;
    Root folder;
  };
  using Folders = std::vector<std::filesystem::path>;
  std::filesystem::path canonicalOf(const std::filesystem::path& path,
                                    std::error_code& error) const;
  FoundFile checkIn(const std::vector<Root>& roots, const std::filesystem::path& file) const;
  FoundFile lookFor(const std::string& name, const std::filesystem::path& beside,
                    const FoundFile* within) const;
  FoundFile lookInPackage(const Package& package, const std::string& path) const;
  /// Folders above the bare model that are the package: its roots.
  void addPackagesAbove(const std::string& name, std::vector<Root>& roots) const;
  /// Folders near `from` and the roots whose package.xml declares this package.
  Folders declaredPackages(const std::string& name, const std::filesystem::path& from,
                           const std::vector<Root>& roots) const;
  /// Describes what was looked for in a package, and what is nearby.
  void explain(const std::string& name, const std::string& path, const std::filesystem::path& from,
               const std::vector<Root>& roots, FoundFile& missing) const;

  FileLookups* lookups_ = nullptr;
  SearchFacts* facts_ = nullptr;
  FileAnswers answers_;
  std::vector<Root> roots_;
  std::vector<Package> packages_;
  std::filesystem::path packages_above_;  // empty: none
  std::shared_ptr<PackageNames> names_;
};

/// The bytes of a regular file of at most `most_bytes`; not_found, unreadable, or unsupported when
/// it is larger or not a regular file.
Result<Bytes> readWholeFile(const std::filesystem::path& path, std::size_t most_bytes);

}  // namespace rocinante
