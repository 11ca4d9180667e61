#include "viewer/ui/model/open_state.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 5000;

}  // namespace

bool canBeShown(std::string_view file_name) {
  constexpr std::array<std::string_view, 9> kEndings{".cell.toml", ".urdf", ".sdf", ".obj", ".stl",
                                                     ".dae",       ".gltf", ".glb", ".mcap"};
  std::string name(file_name);
  std::ranges::transform(name, name.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return std::ranges::any_of(kEndings, [&](std::string_view end) {
    return name.size() > end.size() && name.ends_with(end);
  });
}

Result<std::vector<FileEntry>> listFolder(const fs::path& folder) {
  std::error_code fault;
  fs::directory_iterator each(folder, fs::directory_options::skip_permission_denied, fault);
  if (fault) {
    return Error{ErrorKind::refused, "cannot list the folder: " + fault.message(), folder.string()};
  }
  std::vector<FileEntry> entries;
  for (; !fault && each != fs::directory_iterator() && entries.size() < kMaxEntries;
       each.increment(fault)) {
    const std::string name = each->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code unknown;
    if (each->is_directory(unknown)) {
      entries.push_back({name + "/", true});
    } else if (canBeShown(name) && each->is_regular_file(unknown)) {
      entries.push_back({name, false});
    }
  }
  std::ranges::sort(entries, {},
                    [](const FileEntry& entry) { return std::pair(!entry.is_folder, entry.name); });
  return entries;
}

void OpenState::open(const fs::path& where) {
  shown = just_opened = true;
  enter(folder.empty() ? where : folder);
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
