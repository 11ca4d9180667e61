#include <fmt/format.h>

#include <algorithm>

#include "core/base/name_hint.h"
#include "core/document/fault_list.h"
#include "core/search/file_search.h"
#include "core/search/found_file.h"
#include "core/search/package_names.h"
#include "core/search/search_facts.h"

// Finds the folder of a package when no folder has the package's name.

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxFoldersAbove = 16;
constexpr int kNearFoldersAbove = 4;
constexpr std::size_t kMaxNearFolders = 256;

/// `folder` and those above it, nearest first, without the file system's root.
std::vector<fs::path> foldersUpFrom(fs::path folder, int most) {
  std::vector<fs::path> folders;
  for (int up = 0; up < most && folder.has_relative_path(); ++up) {
    folders.push_back(folder);
    folder = folder.parent_path();
  }
  return folders;
}

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

}  // namespace

Status FileSearch::addPackage(const PackageFolder& package) {
  if (answers_) return Status{};
  std::error_code error;
  const fs::path canonical = canonicalOf(package.folder, error);
  if (error || !fs::is_directory(canonical, error)) {
    return Error{
        ErrorKind::not_found,
        fmt::format("the folder of package {} does not exist", quotedInFault(package.name)),
        package.folder.string()};
  }
  const auto known = std::find_if(packages_.begin(), packages_.end(),
                                  [&](const Package& each) { return each.name == package.name; });
  if (known == packages_.end()) packages_.push_back({package.name, {package.folder, canonical}});
  return Status{};
}

void FileSearch::setPackagesAbove(const fs::path& folder) {
  if (answers_) return;
  packages_above_ = folder;
  std::error_code error;
  fs::path given = folder;
  for (const fs::path& above : foldersUpFrom(canonicalOf(folder, error), kMaxFoldersAbove)) {
    if (!names_->nameOf(above).empty()) {
      static_cast<void>(addRoot(given).ok());  // it exists
      return;
    }
    given /= "..";
  }
}

void FileSearch::addPackagesAbove(const std::string& name, std::vector<Root>& roots) const {
  if (packages_above_.empty()) return;
  std::error_code error;
  fs::path given = packages_above_;
  for (const fs::path& folder :
       foldersUpFrom(canonicalOf(packages_above_, error), kMaxFoldersAbove)) {
    if (folder.filename() == name || names_->nameOf(folder) == name) {
      roots.push_back({given, folder});
    }
    given /= "..";
  }
  // A package beside one of the nearest folders above, as models and their meshes are often kept.
  given = packages_above_;
  for (const fs::path& folder :
       foldersUpFrom(canonicalOf(packages_above_, error), kNearFoldersAbove)) {
    const fs::path beside = canonicalOf(folder / name, error);
    if (!error && isFolder(beside)) roots.push_back({given / name, beside, true});
    given /= "..";
  }
}

FoundFile FileSearch::lookInPackage(const Package& package, const std::string& path) const {
  FoundFile found = checkIn({package.folder}, package.folder.canonical / path);
  if (found.why == FoundFile::Why::found) {
    found.package = package.folder.canonical;
  } else if (found.why == FoundFile::Why::missing) {
    found.detail =
        fmt::format("package {} is {}, which has no such file", quotedInFault(package.name),
                    quotedPathInFault(package.folder.given.string()));
    found.advice = "check --package and [packages] of the cell";
  }
  return found;
}

FileSearch::Folders FileSearch::declaredPackages(const std::string& name, const fs::path& from,
                                                 const std::vector<Root>& roots) const {
  const auto isHeld = [&](const fs::path& folder) {
    return std::any_of(roots.begin(), roots.end(),
                       [&](const Root& root) { return root.holds(folder); });
  };
  Folders about;
  for (const fs::path& folder : foldersUpFrom(from, kMaxFoldersAbove)) {
    if (isHeld(folder)) about.push_back(folder);
  }
  for (const Root& root : roots) about.push_back(root.canonical);
  Folders packages;
  for (const fs::path& folder : about) {
    if (names_->nameOf(folder) == name) packages.push_back(folder);
    for (const fs::path& inner : names_->foldersIn(folder)) {
      if (names_->nameOf(inner) == name) packages.push_back(inner);
    }
  }
  return packages;
}

void FileSearch::explain(const std::string& name, const std::string& path, const fs::path& from,
                         const std::vector<Root>& roots, FoundFile& missing) const {
  if (facts_ != nullptr) facts_->noteMore();
  Folders about = foldersUpFrom(from, kNearFoldersAbove);
  for (const Root& root : roots) about.push_back(root.canonical);
  Folders near = about;
  for (const fs::path& folder : about) {
    const Folders inner = names_->foldersIn(folder);
    near.insert(near.end(), inner.begin(), inner.end());
  }
  if (near.size() > kMaxNearFolders) near.resize(kMaxNearFolders);

  for (const fs::path& folder : near) {
    if (folder.filename() != name && names_->nameOf(folder) != name) continue;
    missing.detail = fmt::format("package {} is {}, which has no such file", quotedInFault(name),
                                 quotedPathInFault(typedPath(folder)));
    return;
  }
  for (const fs::path& folder : foldersUpFrom(from, kMaxFoldersAbove)) {
    if (folder.filename() != name && !isFolder(folder / name)) continue;
    const fs::path there = folder.filename() == name ? folder : folder / name;
    missing.detail = fmt::format("package {} is {}, which has no such file", quotedInFault(name),
                                 quotedPathInFault(typedPath(there)));
    return;
  }
  missing.detail = fmt::format(
      "package {} is not found: no folder above the file or in a search root has this name or "
      "declares it in its package.xml",
      quotedInFault(name));
  const auto has_it = std::find_if(near.begin(), near.end(),
                                   [&](const fs::path& folder) { return isFile(folder / path); });
  if (has_it != near.end()) {
    missing.advice =
        fmt::format("the folder {} has such a file: --package {}={}, or [packages] in the cell",
                    quotedPathInFault(typedPath(*has_it)), name, typedPath(*has_it));
    return;
  }
  std::vector<std::string> folder_names;
  for (const fs::path& folder : near) folder_names.push_back(folder.filename().string());
  missing.advice = didYouMean(name, {folder_names.begin(), folder_names.end()});
  missing.advice +=
      (missing.advice.empty() ? "" : " ") +
      fmt::format("--search DIR of the folder that holds it, or --package {}=DIR", name);
}

}  // namespace rocinante
