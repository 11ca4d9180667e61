#include "core/bundle/cell_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <utility>

#include "core/bundle/bundle_names.h"
#include "core/bundle/private_folder.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

Status writeNewFile(const fs::path& path, ByteView bytes) {
  const auto refuse = [&] {
    return Error{ErrorKind::unreadable, std::string("cannot write: ") + std::strerror(errno),
                 path.string()};
  };
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (file < 0) return refuse();
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      const Error error = refuse();
      ::close(file);
      return error;
    }
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (::close(file) != 0) return refuse();
  return {};
}

/// The folders above a name, outermost first: "a/b" of "a/b/c" after "a".
void addFoldersOf(const std::string& name, std::set<std::string>& folders) {
  for (std::size_t slash = name.find('/'); slash != std::string::npos;
       slash = name.find('/', slash + 1)) {
    folders.insert(name.substr(0, slash));
  }
}

/// The meaning of names, by folder and name, from the manifest.
FileAnswers answersOf(const BundleManifest& manifest, const fs::path& root) {
  using Key = std::pair<std::string, std::string>;
  auto known = std::make_shared<std::map<Key, FoundFile>>();
  for (const BundleManifest::Name& name : manifest.names) {
    FoundFile found;
    found.why = name.why;
    if (!name.means.empty()) {
      found.path = root / name.means;
      found.root = root;
    }
    known->emplace(Key(name.in, name.written), std::move(found));
  }
  return [known, root](const std::string& name, const fs::path& beside) {
    const fs::path in = beside.lexically_relative(root);
    const auto found = known->find(Key(in == "." ? "" : in.generic_string(), manifestWord(name)));
    return found == known->end() ? FoundFile{} : found->second;
  };
}

}  // namespace

Status layOut(const CellBundle& bundle, const fs::path& folder) {
  std::set<std::string> folders;
  std::vector<std::string> names = bundle.manifest.folders;
  for (std::string& name : names) name += '/';
  for (const BundleManifest::File& file : bundle.manifest.files) names.push_back(file.name);
  for (const std::string& name : names) {
    addFoldersOf(name, folders);
    if (folders.size() > kMaxBundledFolders) {
      return Error{ErrorKind::unsupported,
                   fmt::format("the cell's files are in more than {} folders", kMaxBundledFolders),
                   folder.string()};
    }
  }
  for (const std::string& name : folders) {
    if (name.empty()) continue;
    std::error_code error;
    if (!fs::create_directory(folder / name, error)) {
      // A file may have the name of another's folder.
      return Error{ErrorKind::damaged,
                   "cannot make the folder" + (error ? ": " + error.message() : std::string()),
                   (folder / name).string()};
    }
  }
  for (std::size_t i = 0; i < bundle.manifest.files.size(); ++i) {
    if (Status written = writeNewFile(folder / bundle.manifest.files[i].name, bundle.contents[i]);
        !written) {
      return written;
    }
  }
  return {};
}

Result<Cell> loadBundle(const CellBundle& bundle, const std::string& shown_as,
                        const CellOptions& options) {
  const auto folder = PrivateFolder::make();
  if (!folder.ok()) return folder.error();
  const fs::path& root = (*folder)->path();
  if (Status written = layOut(bundle, root); !written) {
    return Error{written.error().kind, "the cell cannot be unpacked: " + written.error().what,
                 written.error().where};
  }
  CellOptions inside;
  inside.geometry = options.geometry;
  inside.strict = options.strict;
  inside.parallel = options.parallel;
  inside.progress = options.progress;
  inside.answers = answersOf(bundle.manifest, root);
  auto cell = loadCell(root / bundle.manifest.main, inside);
  if (!cell.ok()) {
    Cell nothing;
    nothing.files_below = root.string() + "/";
    nothing.files_shown_as = shown_as;
    return Error{cell.error().kind, nothing.shown(cell.error().what),
                 nothing.shown(cell.error().where)};
  }
  cell->files_below = root.string() + "/";
  cell->files_shown_as = shown_as;
  cell->file = cell->shown(cell->file);
  for (Finding& fault : cell->faults) {
    fault.file = cell->shown(fault.file);
    fault.text = cell->shown(fault.text);
    fault.hint = cell->shown(fault.hint);
  }
  for (CellRule& rule : cell->rules) rule.file = cell->shown(rule.file);
  cell->keeps_files = *folder;
  return cell;
}

}  // namespace rocinante
