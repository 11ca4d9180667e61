#include "core/foreign/recordings/bag_folder.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>

#include "core/base/atomic_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadataName = "metadata.yaml";
/// rosbag2 writes a few hundred bytes for each topic and file.
constexpr std::uint64_t kMaxMetadataBytes = std::uint64_t{64} << 20U;
/// Most missing files that are named one by one, and most that are too many.
constexpr std::size_t kMaxFilesNamed = 20;
/// Of a file that rosbag2 compressed as a whole.
constexpr std::string_view kPacked = ".zstd";

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

std::string nameIn(std::string_view path) { return fs::path(unquoted(path)).filename().string(); }

std::optional<std::uint64_t> countIn(std::string_view text) {
  std::uint64_t count = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

/// The few keys of rosbag2's metadata that matter here; not a reader of YAML.
struct BagMetadata {
  /// Of the list `files`, which bags have since version 5.
  struct FileCount {
    std::string name;
    std::optional<std::uint64_t> messages;
  };
  std::vector<std::string> files;  ///< names without folders
  std::vector<FileCount> counts;
  std::optional<std::uint64_t> messages;  ///< of all files
  std::string compression_format, compression_mode;

  void addFile(std::string_view path) {
    std::string name = nameIn(path);
    if (!name.empty()) files.push_back(std::move(name));
  }

  bool lists(std::string_view name) const {
    return std::ranges::any_of(files, [&](const std::string& listed) {
      return listed == name || (listed.ends_with(kPacked) &&
                                listed.substr(0, listed.size() - kPacked.size()) == name);
    });
  }
};

class MetadataReader {
 public:
  BagMetadata read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      takeLine(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(metadata_);
  }

 private:
  void takeLine(std::string_view raw) {
    std::string_view line = trimmed(raw);
    if (line.empty() || line.front() == '#') return;
    const std::size_t indent = raw.find_first_not_of(" \t");
    const bool is_item = line.starts_with("- ");
    if (is_item) line = trimmed(line.substr(2));
    if (is_item && section_ == "relative_file_paths") return metadata_.addFile(line);
    if (is_item && section_ == "files") metadata_.counts.emplace_back();
    const std::size_t colon = line.find(':');
    if (colon == line.npos) return;
    const std::string_view key = line.substr(0, colon);
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (key == "rosbag2_bagfile_information") {
      keys_at_.reset();
      return;
    }
    if (!keys_at_) keys_at_ = indent;
    if (!is_item && indent == *keys_at_) return takeKey(key, value);
    if (section_ != "files" || metadata_.counts.empty()) return;
    if (key == "path") metadata_.counts.back().name = nameIn(value);
    if (key == "message_count") metadata_.counts.back().messages = countIn(value);
  }

  void takeKey(std::string_view key, std::string_view value) {
    section_ = key;
    if (key == "message_count") metadata_.messages = countIn(value);
    if (key == "compression_format") metadata_.compression_format = unquoted(value);
    if (key == "compression_mode") metadata_.compression_mode = unquoted(value);
    if (key != "relative_file_paths" || !value.starts_with('[')) return;
    // [bag_0.mcap, bag_1.mcap]
    value.remove_prefix(1);
    value = value.substr(0, value.find(']'));
    while (!value.empty()) {
      const std::size_t comma = std::min(value.find(','), value.size());
      metadata_.addFile(value.substr(0, comma));
      value.remove_prefix(std::min(comma + 1, value.size()));
    }
  }

  BagMetadata metadata_;
  std::string section_;                     ///< the last key of the bag itself
  std::optional<std::size_t> keys_at_ = 0;  ///< the column of those keys; empty: the next one's
};

Result<BagMetadata> metadataOf(const fs::path& folder) {
  const auto text = readFile(folder / kMetadataName, kMaxMetadataBytes);
  if (!text) return text.error();
  return MetadataReader().read(*text);
}

bool hasMetadata(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kMetadataName, error);
}

/// Those that may be a bag's, by name.
std::vector<fs::path> storageFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const std::string ending = entries->path().extension().string();
    if (ending == ".db3" || ending == ".mcap") files.push_back(entries->path());
  }
  std::ranges::sort(files);
  return files;
}

std::string whereIn(const fs::path& folder) {
  return " (" + (folder / kMetadataName).string() + ")";
}

}  // namespace

std::vector<fs::path> filesOfBagFolder(const fs::path& folder) {
  if (!hasMetadata(folder)) return {};
  std::vector<fs::path> files = storageFilesIn(folder);
  const auto metadata = metadataOf(folder);
  if (!metadata) return files;
  std::vector<fs::path> listed;
  std::ranges::copy_if(files, std::back_inserter(listed), [&](const fs::path& file) {
    return metadata->lists(file.filename().string());
  });
  // A bag whose files were renamed is read all the same.
  return listed.empty() ? files : listed;
}

std::vector<fs::path> filesOfRecording(const fs::path& recording) {
  std::vector<fs::path> files = filesOfBagFolder(recording);
  if (files.empty()) files.push_back(recording);
  return files;
}

std::vector<std::string> damageOfBagFolder(const fs::path& folder) {
  std::vector<std::string> damage;
  if (!hasMetadata(folder)) return damage;
  const auto metadata = metadataOf(folder);
  if (!metadata) {
    damage.push_back(metadata.error().text());
    return damage;
  }
  std::error_code error;
  const auto is_there = [&](const std::string& name) {
    return fs::is_regular_file(folder / name, error);
  };
  std::size_t missing = 0, unlisted = 0;
  const std::string where = whereIn(folder);
  for (const std::string& name : metadata->files) {
    const bool is_packed = name.ends_with(kPacked);
    const std::string unpacked = is_packed ? name.substr(0, name.size() - kPacked.size()) : name;
    if (is_there(unpacked)) continue;
    if (++missing > kMaxFilesNamed) continue;
    if (is_packed && is_there(name)) {
      damage.push_back("the bag's file " + name + " is compressed; `zstd -d` unpacks it" + where);
    } else {
      damage.push_back("the bag's file " + name + " is missing: its messages are not there" +
                       where);
    }
  }
  const auto more = [&](std::size_t count, const std::string& what) {
    if (count <= kMaxFilesNamed) return;
    damage.push_back("and " + std::to_string(count - kMaxFilesNamed) + " more files " + what +
                     where);
  };
  more(missing, "of the bag are missing");
  const std::vector<fs::path> files = filesOfBagFolder(folder);
  for (const fs::path& file : storageFilesIn(folder)) {
    const std::string name = file.filename().string();
    if (metadata->files.empty() || metadata->lists(name) || ++unlisted > kMaxFilesNamed) continue;
    const bool is_read = std::ranges::find(files, file) != files.end();
    damage.push_back(
        "the bag does not list the file " + name +
        (is_read ? ": it is read, as none that is listed is there" : ": it is not read") + where);
  }
  more(unlisted, "are not listed");
  return damage;
}

std::vector<ros::StatedMessages> statedOfBagFolder(const fs::path& folder, std::size_t first) {
  std::vector<ros::StatedMessages> stated;
  const std::vector<fs::path> files = filesOfBagFolder(folder);
  const auto metadata = files.empty() ? Result<BagMetadata>(BagMetadata()) : metadataOf(folder);
  if (!metadata) return stated;
  for (const BagMetadata::FileCount& each : metadata->counts) {
    const auto file = std::ranges::find(files, folder / each.name);
    if (file == files.end() || !each.messages) continue;
    const auto place = static_cast<std::size_t>(file - files.begin());
    stated.push_back({first + place, 1, each.messages, each.name, whereIn(folder), {}});
  }
  const bool is_packed =
      metadata->compression_mode == "MESSAGE" || metadata->compression_mode == "message";
  std::string compression = metadata->compression_format;
  if (!is_packed || compression == "zstd") compression.clear();
  if (metadata->messages || !compression.empty()) {
    stated.push_back({first, files.size(), metadata->messages, "the bag", whereIn(folder),
                      std::move(compression)});
  }
  return stated;
}

}  // namespace rocinante
