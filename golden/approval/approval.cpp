#include "golden/approval/approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "golden/store/folder_lock.h"

namespace rocinante {
namespace {

constexpr int kMaxOfOneKey = 16;

Status renameFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code fault;
  std::filesystem::rename(from, to, fault);
  if (!fault) return {};
  return Error{ErrorKind::unreadable, "cannot rename: " + fault.message(), to.string()};
}

Status makeFolder(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (!fault) return {};
  return Error{ErrorKind::unreadable, "cannot create: " + fault.message(), folder.string()};
}

void removeFile(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

std::vector<AcceptedPicture> acceptedOf(const Manifest& manifest, const std::string& case_name,
                                        const std::string& key) {
  std::vector<AcceptedPicture> pictures;
  for (const AcceptedPicture* one : manifest.find(case_name, key)) pictures.push_back(*one);
  return pictures;
}

/// Accepted pictures with these pixels and the same masks, of any key.
std::vector<const AcceptedPicture*> alikeOf(const Manifest& manifest, const std::string& case_name,
                                            const AcceptedPicture& accepted) {
  auto found = manifest.findPixels(case_name, accepted.pixels, accepted.key);
  std::erase_if(found, [&](const AcceptedPicture* one) {
    return one->areas_pixels != accepted.areas_pixels;
  });
  return found;
}

/// Those of them with the same coverage; with any when it is unknown.
std::vector<const AcceptedPicture*> equalsOf(const Manifest& manifest, const std::string& case_name,
                                             const AcceptedPicture& accepted) {
  auto found = alikeOf(manifest, case_name, accepted);
  std::erase_if(found, [&](const AcceptedPicture* one) {
    return accepted.coverage && one->coverage != accepted.coverage;
  });
  return found;
}

std::string areasName(const std::string& picture) {
  return picture.substr(0, picture.size() - 4) + ".areas.png";
}

}  // namespace

bool Approval::isAccepted(const std::string& case_name, const AcceptedPicture& accepted) const {
  return std::ranges::any_of(equalsOf(seen_, case_name, accepted),
                             [&](const AcceptedPicture* old) { return folder_.has(*old); });
}

Result<std::filesystem::path> Approval::writeStaged(const Picture& picture) {
  if (!staging_) {
    // Beside their destination: a rename does not cross file systems.
    auto made = StagingFolder::make(folder_.hasStore() ? folder_.store() : folder_.goldens());
    if (!made.ok()) return made.error();
    staging_.emplace(std::move(*made));
  }
  std::filesystem::path file = staging_->path() / fmt::format("{}.png", ++files_);
  if (auto written = writePng(file, picture); !written) return written.error();
  return file;
}

Status Approval::stage(const std::string& case_name, AcceptedPicture accepted,
                       const Picture& picture, const Picture* areas, bool beside) {
  if (auto made = makeFolder(folder_.goldens()); !made) return made;
  if (folder_.hasStore()) {
    if (auto made = makeFolder(folder_.store()); !made) return made;
  }
  auto picture_file = writeStaged(picture);
  if (!picture_file.ok()) return picture_file.error();
  accepted.cell = cell_;
  if (const auto alike = alikeOf(seen_, case_name, accepted); !alike.empty()) {
    accepted.key = alike.front()->key;
  }
  Staged staged{case_name, std::move(accepted), beside, std::move(*picture_file), {}};
  if (areas != nullptr) {
    auto areas_file = writeStaged(*areas);
    if (!areas_file.ok()) {
      removeFile(staged.picture_file);
      return areas_file.error();
    }
    staged.areas_file = std::move(*areas_file);
  }
  staged_.push_back(std::move(staged));
  return {};
}

Status Approval::nameFiles(const Manifest& now, Staged& staged) const {
  AcceptedPicture& accepted = staged.accepted;
  if (folder_.hasStore()) {
    accepted.picture = accepted.pixels + ".png";
    if (!staged.areas_file.empty()) accepted.areas = accepted.areas_pixels + ".png";
    return {};
  }
  // Pictures that stay keep their names, of every key.
  std::set<std::string> taken;
  for (const AcceptedPicture* old : now.findAll(staged.case_name)) {
    if (staged.beside || old->key != accepted.key) taken.insert(old->picture);
  }
  int turn = 1;
  while (taken.contains(goldenFileName(staged.case_name, accepted.key, turn))) ++turn;
  if (turn > kMaxOfOneKey) {
    return Error{ErrorKind::refused,
                 fmt::format("this case already has {} accepted pictures, the limit", kMaxOfOneKey),
                 "case " + staged.case_name};
  }
  accepted.picture = goldenFileName(staged.case_name, accepted.key, turn);
  if (!staged.areas_file.empty()) accepted.areas = areasName(accepted.picture);
  return {};
}

Status Approval::moveToArriving(const Staged& staged) const {
  const auto place = [&](const std::string& name, const std::string& pixels) {
    // In a store the name is the hash, so an existing file has the same content.
    return folder_.isInStore(name, pixels) ? folder_.fileOf(name, pixels)
                                           : folder_.arrivingFile(name);
  };
  const AcceptedPicture& accepted = staged.accepted;
  if (auto moved = renameFile(staged.picture_file, place(accepted.picture, accepted.pixels));
      !moved) {
    return moved;
  }
  if (staged.areas_file.empty()) return {};
  return renameFile(staged.areas_file, place(accepted.areas, accepted.areas_pixels));
}

Result<std::vector<std::string>> Approval::commit() {
  std::vector<std::string> left_alone;
  if (staged_.empty()) {
    // Cleanup is optional: do not wait for the lock.
    const auto lock = FolderLock::tryTake(folder_.goldens());
    const auto now = Manifest::read(folder_.goldens());
    if (lock && now.ok()) cleanFolders(*now);
    return left_alone;
  }
  const auto lock = FolderLock::take(folder_.goldens());
  if (!lock.ok()) return lock.error();
  auto now = Manifest::read(folder_.goldens());
  if (!now.ok()) return now.error();
  cleanFolders(*now);

  const std::set<std::string> files_before = now->files();
  std::vector<std::string> arriving;
  Manifest after = *now;
  Status moved;
  for (Staged& staged : staged_) {
    // Another process accepted the same picture first; nothing to do.
    if (!equalsOf(*now, staged.case_name, staged.accepted).empty() &&
        equalsOf(seen_, staged.case_name, staged.accepted).empty()) {
      continue;
    }
    if (acceptedOf(*now, staged.case_name, staged.accepted.key) !=
        acceptedOf(seen_, staged.case_name, staged.accepted.key)) {
      left_alone.push_back(staged.case_name);
      continue;
    }
    moved = nameFiles(after, staged);
    if (moved) moved = moveToArriving(staged);
    if (!moved) break;
    arriving.push_back(staged.accepted.picture);
    if (!staged.accepted.areas.empty()) arriving.push_back(staged.accepted.areas);
    after.accept(staged.case_name, staged.accepted, staged.beside);
  }
  if (!cell_.empty()) {
    after.cells[cell_] = cell_files_;
    after.texts.insert(cell_texts_.begin(), cell_texts_.end());
  }
  after.dropUnusedCells();
  if (moved && !arriving.empty()) moved = after.write(folder_.goldens());
  if (!moved) {
    for (const std::string& name : arriving) removeFile(folder_.arrivingFile(name));
    return moved.error();
  }
  finishArrivals(folder_, after);
  const std::set<std::string> files_after = after.files();
  for (const std::string& name : files_before) {
    if (!files_after.contains(name)) removeFile(folder_.goldens() / name);
  }
  seen_ = std::move(after);
  staged_.clear();
  staging_.reset();
  return left_alone;
}

void Approval::cleanFolders(const Manifest& now) const {
  finishArrivals(folder_, now);
  removeAbandonedStaging(folder_.goldens());
  // Only the holder of the lock writes a manifest.
  std::error_code ignored;
  std::vector<std::filesystem::path> parts;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.goldens(), ignored)) {
    if (isManifestPart(entry.path())) parts.push_back(entry.path());
  }
  for (const auto& part : parts) removeFile(part);
  if (!folder_.hasStore()) return;
  if (const auto lock = FolderLock::tryTake(folder_.store())) {
    removeAbandonedStaging(folder_.store());
  }
}

void finishArrivals(const GoldenFolder& folder, const Manifest& manifest) {
  std::error_code ignored;
  std::vector<std::filesystem::path> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.goldens(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") && name.ends_with(".png.new")) left.push_back(entry.path());
  }
  if (left.empty()) return;
  std::map<std::string, std::string> pixels;
  for (const auto& [case_name, pictures] : manifest.cases) {
    for (const AcceptedPicture& accepted : pictures) {
      pixels[accepted.picture] = accepted.pixels;
      if (!accepted.areas.empty()) pixels[accepted.areas] = accepted.areas_pixels;
    }
  }
  for (const std::filesystem::path& file : left) {
    const std::string name = file.filename().string();
    const auto wanted = pixels.find(name.substr(1, name.size() - 5));
    const auto picture =
        wanted == pixels.end() ? Error{ErrorKind::not_found, {}, {}} : readPng(file);
    if (picture.ok() && pictureXxh3(*picture) == wanted->second) {
      // If this fails, GoldenFolder::read still finds the file under its arriving name.
      std::filesystem::rename(file, folder.goldens() / wanted->first, ignored);
    } else {
      removeFile(file);
    }
  }
}

}  // namespace rocinante
