#include "golden/approval/staging_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <vector>

namespace rocinante {
namespace {

constexpr char kStagingBegin[] = ".staged-";

}  // namespace

Result<StagingFolder> StagingFolder::make(const std::filesystem::path& folder) {
  const auto parent = FolderLock::take(folder);
  if (!parent.ok()) return parent.error();
  std::string made = (folder / kStagingBegin).string() + "XXXXXX";
  if (::mkdtemp(made.data()) == nullptr) {
    return Error{ErrorKind::unreadable,
                 std::string("cannot create a file in it: ") + std::strerror(errno),
                 folder.string()};
  }
  auto lock = FolderLock::take(made);
  if (!lock.ok()) {
    std::error_code ignored;
    std::filesystem::remove(made, ignored);
    return lock.error();
  }
  return StagingFolder(std::move(made), std::move(*lock));
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

bool isAbandonedStaging(const std::filesystem::path& path) {
  std::error_code ignored;
  return path.filename().string().starts_with(kStagingBegin) &&
         std::filesystem::is_directory(std::filesystem::symlink_status(path, ignored)) &&
         FolderLock::tryTake(path).has_value();
}

void removeAbandonedStaging(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> abandoned;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (isAbandonedStaging(entry.path())) abandoned.push_back(entry.path());
  }
  for (const auto& one : abandoned) std::filesystem::remove_all(one, ignored);
}

}  // namespace rocinante
