#include "viewer/ui/model/open_state.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <utility>

#include "core/base/plain_text.h"
#include "core/foreign/recordings/opened_recording.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 5000;
/// Files whose beginning is read to tell whether they can be shown: a folder may be far away.
constexpr int kMostRead = 200;

/// Whether the name has one of the endings, which are in small letters, and more.
bool endsWithOne(std::string_view file_name, std::span<const std::string_view> endings) {
  std::string name(file_name);
  std::ranges::transform(name, name.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return std::ranges::any_of(endings, [&](std::string_view end) {
    return name.size() > end.size() && name.ends_with(end);
  });
}

bool isCellOrModel(std::string_view file_name) {
  constexpr std::array<std::string_view, 8> kEndings{".cell.toml", ".urdf", ".sdf",  ".obj",
                                                     ".stl",       ".dae",  ".gltf", ".glb"};
  return endsWithOne(file_name, kEndings);
}

/// Names of many things, recordings among them.
bool mayBeRecording(std::string_view file_name) {
  constexpr std::array<std::string_view, 4> kEndings{".csv", ".json", ".jsonl", ".ndjson"};
  return endsWithOne(file_name, kEndings);
}

/// A folder that is a bag is one thing.
bool isBagFolder(const fs::path& folder) {
  std::error_code none;
  return fs::exists(folder / "metadata.yaml", none) && isForeignRecording(folder);
}

}  // namespace

bool canBeShown(std::string_view file_name) {
  constexpr std::array<std::string_view, 7> kEndings{".mcap",   ".bag", ".db3", ".cap",
                                                     ".pcapng", ".lcm", ".pcap"};
  return endsWithOne(file_name, kEndings) || isCellOrModel(file_name);
}

bool canBeBeside(std::string_view file_name) { return !isCellOrModel(file_name); }

bool looksLikeEndpoint(std::string_view typed) {
  constexpr std::array<std::string_view, 5> kWays{"udp://", "pcap://", "subscribe://", "nats://",
                                                  "jetstream://"};
  if (std::ranges::any_of(kWays, [&](std::string_view way) { return typed.starts_with(way); })) {
    return true;
  }
  const std::size_t colon = typed.rfind(':');
  if (colon == typed.npos || typed.find('/') != typed.npos) return false;
  const std::string_view port = typed.substr(colon + 1, typed.find('?', colon) - colon - 1);
  return !port.empty() && port.size() <= 5 && std::ranges::all_of(port, isDigit);
}

Result<std::vector<FileEntry>> listFolder(const fs::path& folder) {
  std::error_code fault;
  fs::directory_iterator each(folder, fs::directory_options::skip_permission_denied, fault);
  if (fault) {
    return Error{ErrorKind::refused, "cannot list the folder: " + fault.message(), folder.string()};
  }
  std::vector<FileEntry> entries;
  int read = 0;
  for (; !fault && each != fs::directory_iterator() && entries.size() < kMaxEntries;
       each.increment(fault)) {
    const std::string name = each->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code unknown;
    if (each->is_directory(unknown)) {
      entries.push_back({name + "/", !isBagFolder(each->path())});
    } else if (each->is_regular_file(unknown) &&
               (canBeShown(name) || (mayBeRecording(name) && ++read <= kMostRead &&
                                     isForeignRecording(each->path())))) {
      entries.push_back({name, false});
    }
  }
  std::ranges::sort(entries, {},
                    [](const FileEntry& entry) { return std::pair(!entry.is_folder, entry.name); });
  return entries;
}

void OpenState::open(const fs::path& where) {
  shown = just_opened = true;
  beside = false;
  enter(folder.empty() ? where : folder);
}

void OpenState::openBeside(const fs::path& where) {
  open(where);
  beside = true;
}

std::vector<RecentContent> OpenState::offered() const {
  if (!beside) return recent;
  std::vector<RecentContent> logs;
  const auto add = [&](const fs::path& one) {
    if (one.empty() || one == log) return;
    if (std::ranges::find(logs, one, &RecentContent::log) == logs.end()) logs.push_back({{}, one});
  };
  add(before);
  for (const RecentContent& one : recent) add(one.log);
  return logs;
}

void OpenState::enter(const fs::path& where) {
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(where, ignored);
  folder = whole.empty() ? where : whole;
  text = {};
  start.begin();
  chosen = 0;
  fault.clear();
  entries.clear();
  if (auto listed = listFolder(folder); listed.ok()) {
    entries = std::move(*listed);
  } else {
    fault = listed.error().text();
  }
}

}  // namespace rocinante
