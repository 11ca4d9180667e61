#include "core/bundle/attached_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <utility>

#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/bundle/cell_folder.h"
#include "core/log/log_profile.h"
#include "core/mcap/records.h"

namespace rocinante {
namespace {

std::string sha256Of(ByteView bytes) {
  Sha256 sha256;
  sha256.add(bytes);
  return hexOf(sha256.finish());
}

std::string entryOf(const LogMetadata& record, std::string_view key) {
  const auto found = record.entries.find(std::string(key));
  return found == record.entries.end() ? std::string() : found->second;
}

/// Numbers of a log's attachments by their names.
using AttachmentNumbers = std::multimap<std::string_view, std::size_t>;

/// The attachment of that name and SHA-256. A merged log may have several of one name.
Result<Bytes> readByHash(const LogReader& log, const AttachmentNumbers& numbers,
                         const std::string& name, const std::string& sha256,
                         std::uint64_t most_bytes) {
  std::optional<Error> fault;
  const auto remember = [&](Error error) {
    if (!fault) fault = std::move(error);
  };
  const auto [begin, end] = numbers.equal_range(name);
  for (auto each = begin; each != end; ++each) {
    if (log.attachments()[each->second].data_bytes > most_bytes) {
      remember({ErrorKind::damaged,
                fmt::format("attachment {} is larger than it should be", plainText(name)),
                log.name()});
      continue;
    }
    auto bytes = log.readAttachment(each->second);
    if (bytes.ok() && sha256Of(*bytes) == sha256) return bytes;
    remember(bytes.ok() ? Error{ErrorKind::damaged,
                                fmt::format("attachment {} is not what was attached: its SHA-256 "
                                            "differs",
                                            plainText(name)),
                                log.name()}
                        : bytes.error());
  }
  if (fault) return *fault;
  return Error{
      ErrorKind::damaged,
      fmt::format("the log's cell is incomplete: attachment {} is missing", plainText(name)),
      log.name()};
}

}  // namespace

bool isLog(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (path.extension() == ".mcap") return true;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> begin{};
  file.read(begin.data(), begin.size());
  return file.gcount() == static_cast<std::streamsize>(begin.size()) &&
         std::ranges::equal(std::as_bytes(std::span(begin)), mcap::magic());
}

bool carriesCell(const LogReader& log) {
  return std::ranges::any_of(
      log.metadata(), [](const LogMetadata& record) { return record.name == profile::kCell; });
}

Result<std::optional<CellBundle>> readAttachedCell(const LogReader& log) {
  const auto record = std::ranges::find(log.metadata(), profile::kCell, &LogMetadata::name);
  if (record == log.metadata().end()) return std::optional<CellBundle>();
  if (const std::string format = entryOf(*record, profile::kFormatKey);
      format != profile::kFormat) {
    return Error{ErrorKind::unsupported,
                 fmt::format("the log's cell has format {}; this program reads format {}",
                             plainText(format), profile::kFormat),
                 log.name()};
  }
  const std::string manifest_name = entryOf(*record, profile::kCellManifestKey);
  AttachmentNumbers numbers;
  for (std::size_t i = 0; i < log.attachments().size(); ++i) {
    numbers.emplace(log.attachments()[i].name, i);
  }
  if (!numbers.contains(manifest_name)) {
    // The record is written last: a copy that leaves attachments out leaves it alone.
    return std::optional<CellBundle>();
  }
  const auto text = readByHash(log, numbers, manifest_name,
                               entryOf(*record, profile::kCellSha256Key), kMaxManifestBytes);
  if (!text.ok()) return text.error();
  auto manifest = parseManifest(*text, log.name() + ":" + plainText(manifest_name));
  if (!manifest.ok()) return manifest.error();

  CellBundle bundle;
  bundle.manifest = std::move(*manifest);
  for (const BundleManifest::File& file : bundle.manifest.files) {
    auto bytes = readByHash(log, numbers, std::string(profile::kCellFolder) + file.name,
                            file.sha256, file.bytes);
    if (!bytes.ok()) return bytes.error();
    bundle.contents.push_back(std::move(*bytes));
  }
  return std::optional(std::move(bundle));
}

namespace {

Result<CellBundle> readLogsCell(const std::filesystem::path& path, const CellOptions& options) {
  if (!options.search.empty() || !options.packages.empty()) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("a cell inside a log carries all its files: {} has no effect on it",
                             options.search.empty() ? "--package" : "--search"),
                 path.string()};
  }
  const auto log = LogReader::open(path);
  if (!log.ok()) return log.error();
  auto bundle = readAttachedCell(*log);
  if (!bundle.ok()) return bundle.error();
  if (*bundle) return std::move(**bundle);
  return Error{ErrorKind::not_found,
               "the log carries no cell: name a cell before it, or attach one "
               "(rocinante log attach LOG --cell CELL -o OUT)",
               path.string()};
}

}  // namespace

Result<CellBundle> collectCellOrLog(const std::filesystem::path& path, const CellOptions& options,
                                    BundleRoots roots) {
  if (isLog(path)) return readLogsCell(path, options);
  return collectCell(path, options, MissingMeshes::refused, roots);
}

Result<Cell> loadCellOrLog(const std::filesystem::path& path, const CellOptions& options) {
  if (!isLog(path)) return loadCell(path, options);
  const auto bundle = readLogsCell(path, options);
  if (!bundle.ok()) return bundle.error();
  return loadBundle(*bundle, path.string() + ":" + std::string(profile::kCellFolder), options);
}

}  // namespace rocinante
