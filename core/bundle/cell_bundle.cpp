#include "core/bundle/cell_bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/bundle/bundle_names.h"
#include "core/bundle/cell_folder.h"
#include "core/log/log_profile.h"
#include "core/search/file_search.h"
#include "core/search/found_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

fs::path canonicalOf(const fs::path& path) {
  std::error_code error;
  fs::path canonical = fs::canonical(path, error);
  return error ? fs::absolute(path, error).lexically_normal() : canonical;
}

/// The path of the cell's own file: links in its folder are followed, but the file itself is not,
/// since the names in it are looked for beside the link.
fs::path placeOf(const fs::path& path) {
  return canonicalOf(path.has_parent_path() ? path.parent_path() : ".") / path.filename();
}

/// "pkg" of package://pkg/a.stl; empty where there is none.
std::string packageOf(std::string_view name) {
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!name.starts_with(scheme)) continue;
    name.remove_prefix(scheme.size());
    name.remove_prefix(std::min(name.find_first_not_of('/'), name.size()));
    const std::size_t slash = name.find('/');
    return slash == std::string_view::npos ? std::string() : std::string(name.substr(0, slash));
  }
  return {};
}

/// The roots given by the user, without links.
Result<std::set<fs::path>> givenRoots(const CellOptions& options) {
  FileLookups noted;
  FileSearch search;
  search.noteIn(&noted);
  for (const fs::path& root : options.search) {
    if (Status added = search.addRoot(root); !added) return added.error();
  }
  if (options.search_environment) search.addEnvironmentRoots();
  return std::set<fs::path>(noted.roots.begin(), noted.roots.end());
}

BundleNames namesFor(const fs::path& main, const FileLookups& noted,
                     const std::set<fs::path>& given) {
  BundleNames names(main.parent_path());
  std::set<std::string> packages;
  for (const FileLookup& lookup : noted.lookups) {
    const fs::path& root = lookup.found.root;
    if (root.empty()) continue;
    packages.insert(packageOf(lookup.name));
    if (given.contains(root) && root != main.parent_path()) {
      names.addOtherRoot(root);
    } else {
      names.addOwnRoot(root);
    }
  }
  // A package is found by its folder's name.
  if (packages.contains(names.commonFolder().filename().string())) {
    names.addOwnRoot(names.commonFolder().parent_path());
  }
  return names;
}

Error refusalOf(const Cell& cell, const Finding& first) {
  std::string what = "the cell loads with errors, so a log cannot carry it: " + first.text;
  if (const std::size_t count = countOf(cell.faults, Severity::error); count > 1) {
    what += fmt::format("; {} errors in all, rocinante check lists them", count);
  }
  return {ErrorKind::damaged, std::move(what), first.place()};
}

/// Files by the names that they will have, each with a path that leads to it.
Result<std::map<std::string, fs::path>> filesOf(const Cell& cell, const fs::path& path,
                                                const FileLookups& noted,
                                                const BundleNames& names) {
  std::map<fs::path, fs::path> places{{placeOf(path), path}};
  for (const fs::path& file : cell.files) {
    if (file != path) places.emplace(canonicalOf(file), file);
  }
  for (const FileLookup& lookup : noted.lookups) {
    if (!lookup.found.path.empty()) {
      places.emplace(canonicalOf(lookup.found.path), lookup.found.path);
    }
  }
  if (places.size() > kMaxBundledFiles) {
    return Error{ErrorKind::unsupported,
                 fmt::format("the cell has {} files; at most {} can be attached", places.size(),
                             kMaxBundledFiles),
                 path.string()};
  }
  std::map<std::string, fs::path> files;
  for (const auto& [place, file] : places) {
    const std::string name = names.nameOf(place);
    if (!isBundleName(name) || !files.emplace(name, file).second) {
      return Error{ErrorKind::unsupported, "the file cannot be attached under its name",
                   file.string()};
    }
  }
  return files;
}

/// Refuses files that lie where only the cell itself says to look.
Status checkRoots(const std::map<std::string, fs::path>& files, const fs::path& main,
                  const std::set<fs::path>& given, const CellOptions& options,
                  const FileLookups& noted) {
  std::vector<fs::path> roots{main.parent_path()};
  roots.insert(roots.end(), given.begin(), given.end());
  for (const PackageFolder& package : options.packages) {
    roots.push_back(canonicalOf(package.folder));
  }
  // A bare model names no roots: those that are not the user's are by our own rules.
  const bool is_bare = main.extension() != ".toml";
  std::vector<fs::path> mesh_roots;
  for (const FileLookup& lookup : noted.lookups) {
    if (lookup.found.root.empty() || !(is_bare || lookup.found.root_for_meshes)) continue;
    mesh_roots.push_back(lookup.found.root);
  }
  const auto isIn = [](const std::vector<fs::path>& folders, const fs::path& file) {
    return std::ranges::any_of(folders, [&](const fs::path& folder) {
      return std::ranges::mismatch(folder, file).in1 == folder.end();
    });
  };
  for (const auto& [name, path] : files) {
    const fs::path file = canonicalOf(path);
    if (path == main || placeOf(path) == main || isIn(roots, file)) continue;
    if (isMeshOrTexture(file) && isIn(mesh_roots, file)) continue;
    return Error{ErrorKind::refused,
                 fmt::format("a log cannot carry the cell: this file lies outside its folder, "
                             "where the cell itself says to look; --search {} takes it along",
                             shellWord(typedPath(file.parent_path()))),
                 typedPath(file)};
  }
  return {};
}

Status readContents(const std::map<std::string, fs::path>& files, CellBundle& bundle) {
  std::uint64_t left = kMaxBundledBytes;
  for (const auto& [name, path] : files) {
    std::error_code error;
    if (fs::file_size(path, error) > left && !error) {
      return Error{ErrorKind::unsupported,
                   fmt::format("the files of the cell are larger than the {} MiB that can be "
                               "attached",
                               kMaxBundledBytes >> 20),
                   path.string()};
    }
    auto bytes = readWholeFile(path, left);
    if (!bytes.ok()) return bytes.error();
    left -= bytes->size();
    Sha256 sha256;
    sha256.add(*bytes);
    bundle.manifest.files.push_back({name, bytes->size(), hexOf(sha256.finish())});
    bundle.contents.push_back(std::move(*bytes));
  }
  return {};
}

Status noteNames(const FileLookups& noted, const BundleNames& names, BundleManifest& manifest) {
  std::map<std::pair<std::string, std::string>, BundleManifest::Name> known;
  for (const FileLookup& lookup : noted.lookups) {
    BundleManifest::Name name;
    name.in = names.nameOf(canonicalOf(lookup.beside));
    name.written = manifestWord(lookup.name);
    name.why = lookup.found.why;
    if (!lookup.found.path.empty()) name.means = names.nameOf(canonicalOf(lookup.found.path));
    const auto [same, is_new] = known.emplace(std::pair(name.in, name.written), name);
    if (!is_new && same->second != name) {
      return Error{
          ErrorKind::unsupported,
          fmt::format("the name {} means two files, so a log cannot carry the cell", name.written),
          lookup.beside.string()};
    }
  }
  if (known.size() > kMaxBundledNames) {
    return Error{ErrorKind::unsupported,
                 fmt::format("the cell names files {} times; at most {} names can be attached",
                             known.size(), kMaxBundledNames),
                 ""};
  }
  for (auto& [key, name] : known) manifest.names.push_back(std::move(name));
  return {};
}

/// What must be equal for two loads to be the same.
auto outcomeOf(const Cell& cell) {
  std::vector<std::tuple<Severity, std::string, int, int>> faults;
  for (const Finding& fault : cell.faults) {
    faults.emplace_back(fault.severity, fault.rule, static_cast<int>(fault.line),
                        static_cast<int>(fault.column));
  }
  // Sorted: the order may depend on file names, which differ in the bundle.
  std::sort(faults.begin(), faults.end());
  return std::tuple(faults, cell.files.size(), cell.devices.size(), cell.models.size());
}

/// Loads the bundle now, while the original exists: an attachment that does not load is useless.
Status prove(const CellBundle& bundle, const Cell& cell, const ParallelFor& parallel) {
  CellOptions options;
  options.parallel = parallel;
  const auto again = loadBundle(bundle, "", options);
  if (!again.ok()) return again.error();
  if (outcomeOf(*again) == outcomeOf(cell)) return {};
  return Error{ErrorKind::damaged, "the cell changed while it was read, so a log cannot carry it",
               cell.file};
}

}  // namespace

Result<CellBundle> collectCell(const fs::path& path, CellOptions options, MissingMeshes missing,
                               BundleRoots roots) {
  FileLookups noted;
  options.lookups = &noted;
  options.answers = {};
  options.geometry = true;
  const auto cell = loadCell(path, options);
  if (!cell.ok()) return cell.error();
  const auto refused = std::ranges::find_if(cell->faults, [&](const Finding& fault) {
    return fault.severity == Severity::error &&
           (missing == MissingMeshes::refused || fault.rule != "model.missing-file");
  });
  if (refused != cell->faults.end()) return refusalOf(*cell, *refused);
  const auto given = givenRoots(options);
  if (!given.ok()) return given.error();

  const fs::path main = placeOf(path);
  const BundleNames names = namesFor(main, noted, *given);
  CellBundle bundle;
  bundle.manifest.main = names.nameOf(main);
  bundle.manifest.search = names.otherRoots();
  for (const fs::path& root : noted.roots) {
    const std::string name = names.nameOf(root);
    if (!given->contains(root) && isBundleName(name)) bundle.manifest.folders.push_back(name);
  }
  const auto files = filesOf(*cell, path, noted, names);
  if (!files.ok()) return files.error();
  if (roots == BundleRoots::of_user) {
    if (Status sound = checkRoots(*files, main, *given, options, noted); !sound) {
      return sound.error();
    }
  }
  if (Status read = readContents(*files, bundle); !read) return read.error();
  if (Status done = noteNames(noted, names, bundle.manifest); !done) return done.error();
  for (const FileLookup& lookup : noted.lookups) {
    if (lookup.found.package.empty()) continue;
    bundle.manifest.packages.emplace(manifestWord(packageOf(lookup.name)),
                                     names.nameOf(lookup.found.package));
  }
  for (const Finding& fault : cell->faults) {
    if (fault.severity == Severity::warning) bundle.warnings.push_back(fault);
  }
  if (Status proved = prove(bundle, *cell, options.parallel); !proved) return proved.error();
  return bundle;
}

std::vector<std::string> bundleWarnings(const CellBundle& bundle) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> lines;
  for (const Finding& warning : bundle.warnings) {
    if (lines.size() == kShown) {
      lines.push_back(fmt::format("... and {} more warnings (rocinante check lists all)",
                                  bundle.warnings.size() - kShown));
      break;
    }
    lines.push_back(warning.print());
  }
  return lines;
}

AttachedBundle::AttachedBundle(const CellBundle& bundle)
    : manifest_text_(manifestText(bundle.manifest)) {
  const std::string manifest_name(profile::kCellManifest);
  attachments_.push_back({manifest_name, mediaTypeOf(manifest_name), bytesOf(manifest_text_)});
  for (std::size_t i = 0; i < bundle.manifest.files.size(); ++i) {
    const std::string& name = bundle.manifest.files[i].name;
    attachments_.push_back(
        {std::string(profile::kCellFolder) + name, mediaTypeOf(name), bundle.contents[i]});
  }
  Sha256 sha256;
  sha256.add(bytesOf(manifest_text_));
  metadata_.name = profile::kCell;
  metadata_.entries = {{std::string(profile::kFormatKey), std::string(profile::kFormat)},
                       {std::string(profile::kCellMainKey), bundle.manifest.main},
                       {std::string(profile::kCellManifestKey), manifest_name},
                       {std::string(profile::kCellSha256Key), hexOf(sha256.finish())}};
}

Status AttachedBundle::writeTo(LogWriter& log, LogTime time) const {
  for (const BundleAttachment& each : attachments_) {
    Status written = log.writeAttachment(each.name, each.media_type, time, each.data);
    if (!written) return written;
  }
  return log.writeMetadata(metadata_);
}

}  // namespace rocinante
