#include "golden/approval/golden_folder.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "viewer/picture/lfs_pointer.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxPictureBytes = std::uint64_t{1} << 30U;
constexpr std::uint64_t kMaxLogBytes = std::uint64_t{4} << 30U;

Result<Picture> readOne(const std::filesystem::path& file, const std::string& pixels) {
  const auto bytes = readFile(file, kMaxPictureBytes);
  if (!bytes.ok()) {
    return Error{
        bytes.error().kind,
        bytes.error().kind == ErrorKind::not_found
            ? fmt::format("golden {} is missing", file.string())
            : fmt::format("golden {} cannot be read: {}", file.string(), bytes.error().what),
        {}};
  }
  if (isLfsPointer(bytesOf(*bytes))) {
    return Error{ErrorKind::unsupported,
                 fmt::format("golden {} is a Git LFS pointer, not the picture; `git lfs pull` "
                             "fetches it",
                             file.string()),
                 {}};
  }
  auto picture = decodePng(bytesOf(*bytes), file.string());
  if (!picture.ok()) {
    return Error{ErrorKind::damaged,
                 fmt::format("golden {} cannot be read: {}", file.string(), picture.error().what),
                 {}};
  }
  if (pictureXxh3(*picture) != pixels) {
    return Error{ErrorKind::damaged,
                 fmt::format("golden {} is not the picture that the manifest lists", file.string()),
                 {}};
  }
  return picture;
}

}  // namespace

Result<GoldenFolder> GoldenFolder::of(const Suite& suite) {
  if (suite.store_ref.empty()) return GoldenFolder(suite.goldens, suite.store);
  auto git = GitStore::open(suite.file.parent_path(), suite.store_ref);
  if (!git.ok()) return git.error();
  return GoldenFolder(suite.goldens, std::move(*git));
}

std::filesystem::path GoldenFolder::fileOf(const std::string& picture,
                                           const std::string& pixels) const {
  return isInStore(picture, pixels) ? store_ / picture : goldens_ / picture;
}

std::filesystem::path GoldenFolder::arrivingFile(const std::string& picture) const {
  return goldens_ / ("." + picture + ".new");
}

std::filesystem::path GoldenFolder::fileOf(const AcceptedRun& accepted) const {
  return hasStore() && accepted.log == accepted.session + ".mcap" ? store_ / accepted.log
                                                                  : goldens_ / accepted.log;
}

Status GoldenFolder::verify(const AcceptedRun& accepted) const {
  const std::string file = fileOf(accepted).string();
  if (git_ && fileOf(accepted).parent_path() == store_) {
    if (Status brought = git_->bring(accepted.log); !brought) return brought;
  }
  Xxh3 hash;
  bool is_first = true, is_pointer = false;
  const Status read = readFileInParts(file, kMaxLogBytes, [&](ByteView part, std::uint64_t) {
    if (std::exchange(is_first, false)) is_pointer = isLfsPointer(part);
    hash.add(part);
    return Status{};
  });
  if (!read) {
    return Error{read.error().kind,
                 read.error().kind == ErrorKind::not_found
                     ? fmt::format("accepted log {} is missing", file)
                     : fmt::format("accepted log {} cannot be read: {}", file, read.error().what),
                 {}};
  }
  if (is_pointer) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("accepted log {} is a Git LFS pointer; `git lfs pull` fetches the log", file),
        {}};
  }
  if (hexOf(hash.digest()) != accepted.bytes) {
    return Error{ErrorKind::damaged,
                 fmt::format("accepted log {} is not the one that the manifest lists", file),
                 {}};
  }
  return {};
}

bool GoldenFolder::has(const AcceptedPicture& accepted) const {
  if (git_ && isInStore(accepted.picture, accepted.pixels)) return git_->has(accepted.picture);
  std::error_code ignored;
  return std::filesystem::exists(fileOf(accepted.picture, accepted.pixels), ignored) ||
         std::filesystem::exists(arrivingFile(accepted.picture), ignored);
}

Result<Picture> GoldenFolder::readVerified(const std::string& picture,
                                           const std::string& pixels) const {
  if (git_ && isInStore(picture, pixels)) {
    if (Status brought = git_->bring(picture); !brought) return brought.error();
  }
  auto found = readOne(fileOf(picture, pixels), pixels);
  if (found.ok()) return found;
  // An approve was killed between writing the manifest and the last rename.
  auto arriving = readOne(arrivingFile(picture), pixels);
  return arriving.ok() ? std::move(arriving) : std::move(found);
}

Result<Picture> GoldenFolder::read(const AcceptedPicture& accepted) const {
  return readVerified(accepted.picture, accepted.pixels);
}

Result<Picture> GoldenFolder::readAreas(const AcceptedPicture& accepted) const {
  return readVerified(accepted.areas, accepted.areas_pixels);
}

}  // namespace rocinante
