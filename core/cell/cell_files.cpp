#include "core/cell/cell_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rocinante {
namespace {

namespace fs = std::filesystem;

fs::path withoutLinks(const fs::path& path) {
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  return error ? path.lexically_normal() : canonical;
}

// Checks `format`; an error when it is a later one.
Status checkFormat(TomlTable& root, const fs::path& path) {
  const TomlNode* format = root.node("format");
  const bool is_number = format != nullptr && format->kind == TomlNode::Kind::integer;
  if (is_number && format->integer > 1) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("the cell has format {}; this program reads format 1", format->integer),
        path.string()};
  }
  if (!is_number || format->integer != 1) {
    root.error("cell.format", "format", "the cell does not say `format = 1`");
  }
  return Status{};
}

// Roots that a cell names, relative to its folder.
void addRoots(TomlTable& root, const fs::path& folder, bool are_used, FileSearch& search) {
  if (root.node("search") == nullptr) return;
  const auto entries = root.texts("search");
  if (!are_used) return;
  for (const std::string& entry : entries) {
    if (entry.find('\0') != std::string::npos || entry.empty()) {
      root.error("cell.bad-root", "search", "a search root is empty or not a path");
      continue;
    }
    const fs::path path = (folder / entry).lexically_normal();
    std::error_code ignored;
    if (fs::weakly_canonical(path, ignored) == path.root_path() && path.has_root_path()) {
      root.error("cell.bad-root", "search", "the whole file system cannot be a search root");
      continue;
    }
    if (const Status added = search.addRoot(path); !added.ok()) {
      root.error("cell.bad-root", "search",
                 fmt::format("{}: {}", added.error().what, quotedInFault(entry)));
    }
  }
}

// Folders of packages that a cell names, relative to its folder.
void addPackages(TomlTable& root, const fs::path& folder, bool are_used, FileSearch& search) {
  const auto packages = root.table("packages", "[packages]");
  if (!packages) return;
  for (const TomlNode::Entry& entry : root.node("packages")->entries) {
    const TomlNode& value = entry.value;
    if (entry.key.starts_with("x-")) continue;
    const bool is_path = value.kind == TomlNode::Kind::text && !value.text.empty() &&
                         value.text.find('\0') == std::string::npos;
    if (!is_path) {
      root.faults().error(
          "cell.bad-root", value.place,
          fmt::format("the folder of package {} is empty or not a path", quotedInFault(entry.key)));
      continue;
    }
    if (!are_used) continue;
    const fs::path path = (folder / value.text).lexically_normal();
    std::error_code ignored;
    if (fs::weakly_canonical(path, ignored) == path.root_path() && path.has_root_path()) {
      root.faults().error("cell.bad-root", value.place,
                          "the whole file system cannot be the folder of a package");
      continue;
    }
    if (const Status added = search.addPackage({entry.key, path}); !added.ok()) {
      root.faults().error("cell.bad-root", value.place,
                          fmt::format("{}: {}", added.error().what, quotedPathInFault(value.text)));
    }
  }
}

}  // namespace

CellFile& CellFiles::add(const fs::path& path, TomlNode document) {
  by_path_.emplace(withoutLinks(path), files_.size());
  CellFile& file = *files_.emplace_back(std::make_unique<CellFile>());
  file.path = path;
  file.folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  file.document = std::move(document);
  file.faults = std::make_unique<FaultList>(faults_, path.string());
  file.root = std::make_unique<TomlTable>(file.document, "the cell", *file.faults);
  return file;
}

Status CellFiles::readMain(ByteView bytes, const fs::path& path) {
  auto document = parseToml(textOf(bytes), path.string());
  if (!document.ok()) return document.error();
  CellFile& file = add(path, std::move(*document));
  TomlTable& root = *file.root;
  if (!root.has("format") && !root.has("device") && !root.has("model")) {
    return Error{ErrorKind::damaged, "this is not a cell: it has neither `format` nor a [[device]]",
                 path.string()};
  }
  if (Status format = checkFormat(root, path); !format.ok()) return format;
  if (Status added = search_.addRoot(file.folder); !added.ok()) return added;
  addRoots(root, file.folder, own_roots_, search_);
  addPackages(root, file.folder, own_roots_, search_);
  return Status{};
}

void CellFiles::readIncluded() {
  readIncludesOf(0, 0);
  putInOrder();
}

void CellFiles::readIncludesOf(std::size_t number, std::size_t depth) {
  reading_.push_back(number);
  TomlTable& root = *files_[number]->root;
  if (const TomlNode* given = root.node("include")) {
    static_cast<void>(root.texts("include"));  // reports entries that are not strings
    for (const TomlNode& name : given->items) {
      if (name.kind == TomlNode::Kind::text) readInclude(number, name, depth + 1);
    }
  }
  reading_.pop_back();
}

void CellFiles::readInclude(std::size_t number, const TomlNode& name, std::size_t depth) {
  CellFile& from = *files_[number];
  const std::string quoted = quotedPathInFault(name.text);
  const FoundFile found = search_.find(name.text, from.folder);
  if (found.path.empty()) {
    from.faults->error("cell.missing-file", name.place,
                       fmt::format("{} is not included: {}", quoted, found.problem()),
                       found.hint());
    return;
  }
  if (const auto known = by_path_.find(withoutLinks(found.path)); known != by_path_.end()) {
    const auto above = std::ranges::find(reading_, known->second);
    if (above == reading_.end()) {
      from.includes.push_back(known->second);
    } else {
      from.faults->error("cell.include-loop", name.place,
                         fmt::format("{} is not included: it is {}", quoted,
                                     placeInLoop(above - reading_.begin())),
                         "files cannot include each other in a circle");
    }
    return;
  }
  if (files_.size() >= kMaxCellFiles || depth > kMaxIncludeDepth) {
    from.faults->error("cell.too-many", name.place,
                       fmt::format("{} is not included: a cell has at most {} files, {} deep",
                                   quoted, kMaxCellFiles, kMaxIncludeDepth));
    return;
  }
  const auto refuse = [&](const Error& error) {
    from.faults->error("cell.unusable-include", name.place,
                       fmt::format("{} is not included: {}", quoted, error.text()));
  };
  const auto bytes = readWholeFile(found.path, kMaxCellBytes);
  if (!bytes.ok()) return refuse(bytes.error());
  auto document = parseToml(textOf(*bytes), found.path.string());
  if (!document.ok()) return refuse(document.error());
  const std::size_t added = files_.size();
  CellFile& file = add(found.path, std::move(*document));
  from.includes.push_back(added);
  if (Status format = checkFormat(*file.root, file.path); !format.ok()) {
    file.document.entries.clear();
    return refuse(format.error());
  }
  addRoots(*file.root, file.folder, own_roots_, search_);
  addPackages(*file.root, file.folder, own_roots_, search_);
  readIncludesOf(added, depth);
}

std::string CellFiles::placeInLoop(std::ptrdiff_t at) const {
  const CellFile& file = *files_[reading_[static_cast<std::size_t>(at)]];
  if (at + 1 == std::ssize(reading_)) return "this very file";
  return fmt::format("the file that includes this one, at {}:{}", file.path.string(),
                     file.root->place("include").line);
}

void CellFiles::putInOrder() {
  // Deepest first, last include first; then reversed.
  std::vector<bool> seen(files_.size(), false);
  const auto visit = [&](const auto& self, std::size_t number) -> void {
    if (seen[number]) return;
    seen[number] = true;
    const auto& below = files_[number]->includes;
    for (auto next = below.rbegin(); next != below.rend(); ++next) self(self, *next);
    order_.push_back(files_[number].get());
  };
  visit(visit, 0);
  std::ranges::reverse(order_);
}

bool CellFiles::includes(const std::string& above, const std::string& below) const {
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (files_[i]->faults && files_[i]->faults->file() == above) waiting.push_back(i);
  }
  std::vector<bool> seen(files_.size(), false);
  while (!waiting.empty()) {
    const std::size_t at = waiting.back();
    waiting.pop_back();
    for (const std::size_t next : files_[at]->includes) {
      if (files_[next]->faults->file() == below) return true;
      if (!seen[next]) waiting.push_back(next);
      seen[next] = true;
    }
  }
  return false;
}

void CellFiles::finish() {
  for (const auto& file : files_) file->root->finish();
  for (const auto& file : files_) file->faults.reset();
}

}  // namespace rocinante
