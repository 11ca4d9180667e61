#include "core/foreign/recordings/bag_folder.h"

#include <algorithm>
#include <string_view>

#include "core/base/atomic_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadataName = "metadata.yaml";
/// rosbag2 writes a few hundred bytes for each topic and file.
constexpr std::uint64_t kMaxMetadataBytes = std::uint64_t{64} << 20U;
/// Most missing files that are named one by one.
constexpr std::size_t kMaxMissing = 20;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t from = text.find_first_not_of(kBlanks);
  if (from == text.npos) return {};
  return text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

std::string_view unquoted(std::string_view text) {
  text = trimmed(text);
  const bool is_quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                         text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// The few keys of rosbag2's metadata that matter here; not a reader of YAML.
struct BagMetadata {
  std::vector<std::string> files;  ///< names without folders
  std::string compression_format, compression_mode;
};

void addFile(BagMetadata& metadata, std::string_view path) {
  std::string name = fs::path(unquoted(path)).filename().string();
  if (!name.empty()) metadata.files.push_back(std::move(name));
}

BagMetadata readMetadata(std::string_view text) {
  BagMetadata metadata;
  bool in_files = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (in_files && line.starts_with("- ")) {
      addFile(metadata, line.substr(2));
      continue;
    }
    if (line.empty() || line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon == line.npos) continue;
    const std::string_view key = line.substr(0, colon);
    std::string_view value = trimmed(line.substr(colon + 1));
    in_files = key == "relative_file_paths";
    if (key == "compression_format") metadata.compression_format = unquoted(value);
    if (key == "compression_mode") metadata.compression_mode = unquoted(value);
    if (!in_files || !value.starts_with('[')) continue;
    // [bag_0.mcap, bag_1.mcap]
    value.remove_prefix(1);
    value = value.substr(0, value.find(']'));
    while (!value.empty()) {
      const std::size_t comma = std::min(value.find(','), value.size());
      addFile(metadata, value.substr(0, comma));
      value.remove_prefix(std::min(comma + 1, value.size()));
    }
  }
  return metadata;
}

}  // namespace

std::vector<fs::path> filesOfBagFolder(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  if (!fs::is_regular_file(folder / kMetadataName, error)) return files;
  fs::directory_iterator entries(folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const std::string ending = entries->path().extension().string();
    if (ending == ".db3" || ending == ".mcap") files.push_back(entries->path());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<std::string> damageOfBagFolder(const fs::path& folder) {
  std::vector<std::string> damage;
  const fs::path file = folder / kMetadataName;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return damage;
  const auto text = readFile(file, kMaxMetadataBytes);
  if (!text) {
    damage.push_back(text.error().text());
    return damage;
  }
  const BagMetadata metadata = readMetadata(*text);
  const auto is_there = [&](const std::string& name) {
    return fs::is_regular_file(folder / name, error);
  };
  std::size_t missing = 0;
  const std::string where = " (" + file.string() + ")";
  for (const std::string& name : metadata.files) {
    const bool is_packed = name.ends_with(".zstd");
    const std::string unpacked = is_packed ? name.substr(0, name.size() - 5) : name;
    if (is_there(unpacked)) continue;
    if (++missing > kMaxMissing) continue;
    if (is_packed && is_there(name)) {
      damage.push_back("the bag's file " + name + " is compressed; `zstd -d` unpacks it" + where);
    } else {
      damage.push_back("the bag's file " + name + " is missing: its messages are not there" +
                       where);
    }
  }
  if (missing > kMaxMissing) {
    damage.push_back("and " + std::to_string(missing - kMaxMissing) +
                     " more files of the bag are missing" + where);
  }
  if ((metadata.compression_mode == "MESSAGE" || metadata.compression_mode == "message") &&
      metadata.compression_format != "zstd") {
    damage.push_back("the messages are compressed with " + metadata.compression_format +
                     ", which is not read; `ros2 bag convert` makes a bag without compression" +
                     where);
  }
  return damage;
}

}  // namespace rocinante
