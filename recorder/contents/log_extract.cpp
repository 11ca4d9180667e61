#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/part_file.h"
#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_folder.h"
#include "recorder/contents/attachments.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& name) { return fmt::format("\"{}\"", plainText(name)); }

std::string sha256Of(ByteView bytes) {
  Sha256 sha256;
  sha256.add(bytes);
  return hexOf(sha256.finish());
}

/// Writes every file into a new folder.
Status writeNewFolder(const CellBundle& files, const fs::path& path) {
  std::string folder = path.lexically_normal().string();
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  Result<PartFile> part = PartFile::makeFolder(folder);
  if (!part) return Error{part.error().kind, part.error().what, path.string()};
  Status written = layOut(files, part->beside());
  if (written) written = part->publish(false);
  if (!written) written = Error{written.error().kind, written.error().what, path.string()};
  return written;
}

Status writeInto(const CellBundle& files, const fs::path& folder) {
  for (std::size_t i = 0; i < files.contents.size(); ++i) {
    const fs::path path = folder / files.manifest.files[i].name;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
      return Error{ErrorKind::unreadable, "cannot make the folder: " + error.message(),
                   path.parent_path().string()};
    }
    if (Status written = writeFileWhole(path, files.contents[i], true); !written) return written;
  }
  return {};
}

Result<ExtractReport> write(const CellBundle& files, const FolderOutput& to) {
  std::error_code error;
  const bool exists = fs::exists(fs::symlink_status(to.path, error));
  const bool is_empty_folder =
      exists && fs::is_directory(to.path, error) && fs::is_empty(to.path, error);
  if (exists && !is_empty_folder && !to.overwrite) {
    return Error{ErrorKind::refused, "the folder exists; --force extracts into it",
                 to.path.string()};
  }
  const bool new_folder = !exists || (is_empty_folder && !to.overwrite);
  const Status written = new_folder ? writeNewFolder(files, to.path) : writeInto(files, to.path);
  if (!written) return written.error();
  ExtractReport report;
  report.files = files.contents.size();
  for (const Bytes& content : files.contents) report.bytes += content.size();
  return report;
}

}  // namespace

Result<std::size_t> findAttachment(const LogReader& log, const std::string& name,
                                   std::optional<std::size_t> index) {
  const std::vector<LogAttachment>& attachments = log.attachments();
  if (index) {
    if (*index >= 1 && *index <= attachments.size()) return *index - 1;
    return Error{
        ErrorKind::not_found,
        fmt::format("no attachment has index {}: the log has {}", *index, attachments.size()),
        log.name()};
  }
  std::optional<std::size_t> found;
  std::string sha256;
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    if (attachments[i].name != name) continue;
    const auto bytes = log.readAttachment(i);
    if (!bytes.ok()) return bytes.error();
    if (found && sha256Of(*bytes) != sha256) {
      return Error{ErrorKind::bad_argument,
                   fmt::format("several attachments are named {}: choose one by --index "
                               "(--list shows them)",
                               quoted(name)),
                   log.name()};
    }
    if (!found) sha256 = sha256Of(*bytes);
    if (!found) found = i;
  }
  if (found) return *found;
  return Error{ErrorKind::not_found,
               fmt::format("no attachment is named {} (--list shows all)", quoted(name)),
               log.name()};
}

Result<ExtractReport> extractAll(const LogReader& log, const FolderOutput& to) {
  if (log.attachments().empty()) {
    return Error{ErrorKind::not_found, "the log has no attachments", log.name()};
  }
  CellBundle files;
  std::map<std::string, std::string> known;
  for (std::size_t i = 0; i < log.attachments().size(); ++i) {
    const std::string& name = log.attachments()[i].name;
    if (!isBundleName(name)) {
      return Error{ErrorKind::refused,
                   fmt::format("attachment {0} is named {1}, which cannot be a file name here "
                               "(--index {0} -o FILE extracts it)",
                               i + 1, quoted(name)),
                   log.name()};
    }
    auto bytes = log.readAttachment(i);
    if (!bytes.ok()) return bytes.error();
    std::string sha256 = sha256Of(*bytes);
    const auto [same, is_new] = known.emplace(name, sha256);
    if (!is_new && same->second != sha256) {
      return Error{ErrorKind::refused,
                   fmt::format("two different attachments are named {} (--index {} -o FILE "
                               "extracts the second)",
                               quoted(name), i + 1),
                   log.name()};
    }
    if (!is_new) continue;
    files.manifest.files.push_back({name, bytes->size(), std::move(sha256)});
    files.contents.push_back(std::move(*bytes));
  }
  return write(files, to);
}

Result<ExtractReport> extractCell(const LogReader& log, const FolderOutput& to) {
  const auto bundle = readAttachedCell(log);
  if (!bundle.ok()) return bundle.error();
  if (!*bundle) return Error{ErrorKind::not_found, "the log carries no cell", log.name()};
  auto report = write(**bundle, to);
  if (!report.ok()) return report;
  report->main = (*bundle)->manifest.main;
  report->search = (*bundle)->manifest.search;
  report->packages = (*bundle)->manifest.packages;

  CellOptions options;
  for (const auto& [name, folder] : report->packages) {
    options.packages.push_back({name, to.path / folder});
  }
  for (const std::string& root : report->search) options.search.push_back(to.path / root);
  const auto inside = loadBundle(**bundle, "", {});
  const auto outside = loadCell(to.path / report->main, options);
  report->stands_alone = inside.ok() && outside.ok() &&
                         inside->faults.size() == outside->faults.size() &&
                         inside->files.size() == outside->files.size();
  return report;
}

}  // namespace rocinante
