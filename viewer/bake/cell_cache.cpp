#include "viewer/bake/cell_cache.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "core/base/hash.h"
#include "core/base/loaded_module.h"
#include "core/bundle/cell_or_log.h"
#include "core/log/mapped_file.h"
#include "core/report/finding.h"
#include "core/search/search_facts.h"
#include "viewer/bake/bake_cell.h"
#include "viewer/bake/cell_inputs.h"
#include "viewer/bake/reader_id.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kInputSection = kFirstForeignSection;

void addWord(std::string& text, std::string_view word) {
  text += std::to_string(word.size());
  text += ':';
  text += word;
}

/// Everything that is asked for, and by whom. Files are checked when an entry is used.
BakedKey requestKey(const fs::path& path, const CellOptions& options) {
  std::error_code error;
  std::string text;
  addWord(text, cellReaderId());
  addWord(text, std::to_string(BakedFile::kFormat));
  addWord(text, fs::current_path(error).string());
  addWord(text, path.string());
  for (const fs::path& root : options.search) addWord(text, "root=" + root.string());
  for (const PackageFolder& package : options.packages) {
    addWord(text, "package=" + package.name);
    addWord(text, package.folder.string());
  }
  if (options.search_environment) {
    for (const char* name : {"ROCINANTE_PATH", "AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"}) {
      const char* const value = std::getenv(name);
      addWord(text, std::string(name) + "=" + (value == nullptr ? "" : value));
    }
  }
  // Without a decoder a picture is not drawn.
  addWord(text, findModule("librocinante_openimageio.so").string());
  return xxh3(bytesOf(text));
}

BakedKey keyOfDigits(const std::string& digits) {
  BakedKey key{};
  for (std::size_t i = 0; i < key.size(); ++i) {
    key[i] = static_cast<std::byte>(std::stoi(digits.substr(2 * i, 2), nullptr, 16));
  }
  return key;
}

WallTime systemTime() {
  return std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
}

}  // namespace

CellCache CellCache::ofUser() { return CellCache(CacheFolder::ofUser("cells")); }

Result<Cell> CellCache::load(const fs::path& path, const CellOptions& options) const {
  const bool kept_at_all = !folder().empty() && options.geometry && !options.answers &&
                           options.lookups == nullptr && options.facts == nullptr && !isLog(path);
  if (!kept_at_all) return loadCellOrLog(path, options);
  const std::string key = hexOf(requestKey(path, options));
  if (auto cell = kept(key, options)) return std::move(*cell);

  SearchFacts facts;
  CellOptions noted = options;
  noted.facts = &facts;
  const WallTime begun = now_ ? now_() : systemTime();
  auto cell = loadCellOrLog(path, noted);
  if (!cell.ok() || firstError(cell->faults) != nullptr) return cell;
  return keep(std::move(*cell), key, options, facts, begun);
}

std::optional<Cell> CellCache::kept(const std::string& key, const CellOptions& options) const {
  auto mapped = MappedFile::open(files_.fileOf(key));
  if (!mapped.ok() || mapped->bytes().size() > files_.mostBytes()) return std::nullopt;
  const auto file = std::make_shared<const MappedFile>(std::move(*mapped));
  const auto baked = BakedFile::parse(file->bytes(), files_.fileOf(key).string());
  if (!baked.ok() || baked->key() != keyOfDigits(key)) return std::nullopt;
  const auto section = baked->section(kInputSection);
  if (!section.ok()) return std::nullopt;
  const auto inputs = decodeInputs(*section);
  if (!inputs || !areUnchanged(*inputs, options.parallel)) return std::nullopt;
  auto cell = readBakedCell(*baked, file);
  if (!cell.ok()) return std::nullopt;
  files_.touch(key);
  return std::move(*cell);
}

Cell CellCache::keep(Cell cell, const std::string& key, const CellOptions& options,
                     const SearchFacts& facts, WallTime begun) const {
  std::uint64_t bytes = 0;
  for (const fs::path& file : cell.files) {
    std::error_code gone;
    const std::uintmax_t size = fs::file_size(file, gone);
    if (!gone) bytes += size;
  }
  if (bytes < least_bytes_) return cell;

  BakeOptions how;
  how.key = keyOfDigits(key);
  how.parallel = options.parallel;
  // The files are read again after the last picture was decoded: one that changed meanwhile is
  // seen.
  std::optional<CellInputs> inputs;
  const auto made = std::make_shared<const Bytes>(bakeCell(cell, how, [&] {
    inputs = inputsOf(cell, facts, begun);
    std::vector<std::pair<std::uint32_t, Bytes>> more;
    if (inputs) more.emplace_back(kInputSection, encodeInputs(*inputs));
    return more;
  }));
  const auto baked = BakedFile::parse(*made, "baked cell");
  if (!baked.ok()) return cell;
  // What would not be read again is not kept.
  auto again = readBakedCell(*baked, made);
  if (!again.ok()) return cell;
  if (inputs) files_.store(key, *made);
  return std::move(*again);
}

}  // namespace rocinante
