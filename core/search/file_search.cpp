#include "core/search/file_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "core/base/hex_digit.h"
#include "core/base/plain_text.h"
#include "core/search/found_file.h"
#include "core/search/package_names.h"
#include "core/search/search_facts.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxFoldersUp = 16;

// The parts of a file's name.
struct ParsedName {
  std::string path;     // with `/` and nothing before it when package is set
  std::string package;  // of package:// and model://
  bool absolute = false;
};

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

ParsedName parsedName(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!startsWith(name, scheme)) continue;
    name.erase(0, scheme.size());
    name.erase(0, std::min(name.find_first_not_of('/'), name.size()));
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) return {name, "", false};
    return {name.substr(slash + 1), name.substr(0, slash), false};
  }
  if (startsWith(name, "file:")) {
    name.erase(0, 5);
    if (startsWith(name, "///"))
      name.erase(0, 2);
    else if (startsWith(name, "//"))
      name.erase(0, 2);
  }
  const std::size_t letter = startsWith(name, "/") ? 1 : 0;  // /C:/Users as in file:///C:/Users
  const bool drive = name.size() > letter + 1 && name[letter + 1] == ':' &&
                     std::isalpha(static_cast<unsigned char>(name[letter])) != 0;
  return {name, "", drive || startsWith(name, "/")};
}

bool isPicture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array<std::string_view, 9> kEndings = {
      ".png", ".jpg", ".jpeg", ".tga", ".bmp", ".tif", ".tiff", ".dds", ".exr"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

FoundFile refusal(FoundFile::Why why) {
  FoundFile refused;
  refused.why = why;
  return refused;
}

/// A folder for models alone, in which the meshes of the models seldom lie.
bool isModelFolder(const fs::path& folder) {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"models", "robots", "sdf", "urdf", "xacro"});
  return std::ranges::find(kNames, folder.filename().string()) != kNames.end();
}

/// Names the root that permits a file outside the others.
void adviseRoot(const fs::path& place, const fs::path& from, FoundFile& outside) {
  std::error_code error;
  const fs::path file = fs::canonical(place, error);
  if (error || !fs::is_regular_file(file, error)) return;
  fs::path common;
  for (auto a = file.begin(), b = from.begin(); a != file.end() && b != from.end() && *a == *b;
       ++a, ++b) {
    common /= *a;
  }
  if (!common.has_relative_path()) common = file.parent_path();
  if (!common.has_relative_path()) return;
  const std::string typed = typedPath(common);
  outside.advice = fmt::format("--search {} permits it, or `search` in the cell",
                               shellWord(typed == "." ? "./" : typed));
}

// The places where a name may mean a file, best first.
std::vector<fs::path> candidatesFor(const ParsedName& name, const fs::path& beside,
                                    const std::vector<fs::path>& roots) {
  std::vector<fs::path> places;
  if (!name.package.empty()) {
    // A model is usually inside the package that it names, so search upwards first.
    fs::path folder = beside;
    for (int up = 0; up < kMaxFoldersUp && !folder.empty(); ++up) {
      if (folder.filename() == name.package) places.push_back(folder / name.path);
      places.push_back(folder / name.package / name.path);
      if (folder == folder.root_path()) break;
      folder = folder.parent_path();
    }
    for (const fs::path& root : roots) {
      if (root.filename() == name.package) places.push_back(root / name.path);
      places.push_back(root / name.package / name.path);
    }
    return places;
  }
  places.push_back(beside / name.path);
  if (name.absolute) return places;
  for (const fs::path& root : roots) places.push_back(root / name.path);
  if (isPicture(name.path)) {
    const fs::path file = fs::path(name.path).filename();
    places.push_back(beside / ".." / "materials" / "textures" / file);
    places.push_back(beside / "textures" / file);
  }
  return places;
}

}  // namespace

FileSearch::FileSearch() : names_(std::make_shared<PackageNames>()) {}

void FileSearch::noteFactsIn(SearchFacts* facts) {
  facts_ = facts;
  names_->noteIn(facts);
}

fs::path FileSearch::canonicalOf(const fs::path& path, std::error_code& error) const {
  if (facts_ != nullptr) facts_->note(path);
  return fs::canonical(path, error);
}

bool FileSearch::Root::holds(const fs::path& path) const {
  const auto [in_root, in_path] =
      std::mismatch(canonical.begin(), canonical.end(), path.begin(), path.end());
  return in_root == canonical.end();
}

Status FileSearch::addRoot(const fs::path& root) {
  if (answers_) return Status{};
  std::error_code error;
  const fs::path canonical = canonicalOf(root, error);
  if (error) return Error{ErrorKind::not_found, "the search root does not exist", root.string()};
  if (!fs::is_directory(canonical, error)) {
    return Error{ErrorKind::bad_argument, "the search root is not a folder", root.string()};
  }
  for (const Root& known : roots_) {
    if (known.canonical == canonical) return Status{};
  }
  roots_.push_back({root, canonical});
  if (lookups_ != nullptr) lookups_->roots.push_back(canonical);
  return Status{};
}

void FileSearch::addEnvironmentRoots() {
  struct Variable {
    const char* name;
    bool prefix;  // of an installation: packages are in share
  };
  for (const Variable& variable :
       {Variable{"ROCINANTE_PATH", false}, Variable{"AMENT_PREFIX_PATH", true},
        Variable{"ROS_PACKAGE_PATH", false}}) {
    const char* value = std::getenv(variable.name);
    std::string_view rest = value == nullptr ? "" : value;
    while (!rest.empty()) {
      const std::size_t colon = std::min(rest.find(':'), rest.size());
      const fs::path root = rest.substr(0, colon);
      rest.remove_prefix(std::min(colon + 1, rest.size()));
      if (root.empty()) continue;
      // Entries that do not exist are common there and ignored.
      if (variable.prefix) static_cast<void>(addRoot(root / "share").ok());
      static_cast<void>(addRoot(root).ok());
    }
  }
}

FoundFile FileSearch::checkIn(const std::vector<Root>& roots, const fs::path& file) const {
  std::error_code error;
  const fs::path canonical = canonicalOf(file, error);
  if (error) return {};
  for (const Root& root : roots) {
    if (!root.holds(canonical) || (root.for_meshes && !isMeshOrTexture(canonical))) continue;
    if (!fs::is_regular_file(canonical, error)) return refusal(FoundFile::Why::no_file);
    FoundFile found;
    found.why = FoundFile::Why::found;
    found.path = (root.given / canonical.lexically_relative(root.canonical)).lexically_normal();
    found.root = root.canonical;
    found.root_as_given = root.given;
    found.root_for_meshes = root.for_meshes;
    return found;
  }
  return refusal(FoundFile::Why::outside);
}

FoundFile FileSearch::check(const fs::path& file) const { return checkIn(roots_, file); }

FoundFile FileSearch::look(const std::string& name, const fs::path& beside,
                           const FoundFile* within) const {
  return answers_ ? answers_(name, beside) : lookFor(name, beside, within);
}

void FileSearch::note(const FileLookup& lookup) const {
  if (lookups_ != nullptr) lookups_->lookups.push_back(lookup);
}

FoundFile FileSearch::find(const std::string& name, const fs::path& beside,
                           const FoundFile* within) const {
  FoundFile found = look(name, beside, within);
  note({beside, name, found});
  return found;
}

FoundFile FileSearch::lookFor(const std::string& given, const fs::path& beside,
                              const FoundFile* within) const {
  if (given.empty() || given.size() > 4096 || given.find('\0') != std::string::npos) return {};
  for (const std::string_view scheme : {"http://", "https://", "ftp://"}) {
    if (startsWith(given, scheme)) return refusal(FoundFile::Why::remote);
  }
  if (given.find("$(") != std::string::npos || given.find("${") != std::string::npos) {
    return refusal(FoundFile::Why::expression);
  }

  std::error_code error;
  fs::path from = canonicalOf(beside.empty() ? fs::path(".") : beside, error);
  if (error) from = beside;
  FoundFile best;
  for (const std::string& name : {given, percentDecoded(given)}) {
    const ParsedName parsed = parsedName(name);
    const auto package = std::find_if(packages_.begin(), packages_.end(), [&](const Package& each) {
      return each.name == parsed.package;
    });
    if (!parsed.package.empty() && package != packages_.end()) {
      FoundFile found = lookInPackage(*package, parsed.path);
      if (found.why == FoundFile::Why::found || name == percentDecoded(given)) return found;
      continue;
    }
    std::vector<Root> roots = roots_;
    if (!parsed.package.empty()) addPackagesAbove(parsed.package, roots);
    std::vector<fs::path> folders;
    for (const Root& root : roots) folders.push_back(root.canonical);
    // Naming a package's folder permits everything in it.
    for (const Package& each : packages_) roots.push_back(each.folder);
    if (within != nullptr && !within->root.empty()) {
      roots.push_back({within->root_as_given, within->root, within->root_for_meshes});
    }
    // robot/urdf/arm.urdf beside robot/meshes: how most public repositories have it.
    if (isModelFolder(from) && from.parent_path().has_relative_path()) {
      roots.push_back({beside / "..", from.parent_path(), true});
    }
    // A found file is the answer; otherwise the first refusal that is not "missing".
    const auto isAnswer = [&](const fs::path& place, const fs::path& package_folder) {
      FoundFile found = checkIn(roots, place);
      found.package = package_folder;
      const bool is_found = found.why == FoundFile::Why::found;
      const bool is_better =
          best.why == FoundFile::Why::missing && found.why != FoundFile::Why::missing;
      if (is_found || is_better) best = std::move(found);
      if (is_better && best.why == FoundFile::Why::outside) adviseRoot(place, from, best);
      return is_found;
    };
    for (const fs::path& place : candidatesFor(parsed, from, folders)) {
      if (isAnswer(place, {})) return best;
    }
    if (!parsed.package.empty()) {
      for (const fs::path& folder : declaredPackages(parsed.package, from, roots)) {
        if (isAnswer(folder / parsed.path, folder)) return best;
      }
      if (best.why == FoundFile::Why::missing && name == given) {
        explain(parsed.package, parsed.path, from, roots, best);
      }
    }
    if (!parsed.absolute) continue;
    // Made on another machine: the longest tail of the path that is a file here.
    std::string_view rest = parsed.path;
    for (std::size_t slash = rest.find('/'); slash != std::string_view::npos;
         slash = rest.find('/')) {
      rest.remove_prefix(slash + 1);
      if (rest.empty() || startsWith(rest, "/")) continue;
      for (const fs::path& place : candidatesFor({std::string(rest), "", false}, from, folders)) {
        FoundFile found = checkIn(roots, place);
        if (found.why != FoundFile::Why::found) continue;
        found.why = FoundFile::Why::found_elsewhere;
        return found;
      }
    }
  }
  return best;
}

Result<Bytes> readWholeFile(const fs::path& path, std::size_t most_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return Error{ErrorKind::not_found, "there is no such file", path.string()};
  }
  if (!fs::is_regular_file(status)) {
    return Error{ErrorKind::unsupported, "this is not a regular file", path.string()};
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return Error{ErrorKind::unreadable, "its size cannot be read", path.string()};
  if (size > most_bytes) {
    return Error{ErrorKind::unsupported,
                 "the file is larger than " + std::to_string(most_bytes >> 20) + " MiB",
                 path.string()};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{ErrorKind::unreadable, "the file cannot be opened", path.string()};
  Bytes bytes(static_cast<std::size_t>(size));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (file.bad() || static_cast<std::size_t>(file.gcount()) != bytes.size()) {
    return Error{ErrorKind::unreadable, "the file cannot be read", path.string()};
  }
  return bytes;
}

}  // namespace rocinante
