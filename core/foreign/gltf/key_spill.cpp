#include "core/foreign/gltf/key_spill.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kBlockNumbers = 1024;
constexpr std::size_t kBlockBytes = kBlockNumbers * sizeof(float);

/// A file without a name, which is gone when it is closed; -1 with errno.
int unnamedFileIn(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  // Some file systems have no O_TMPFILE.
  std::string path = folder + "/.rocinante-XXXXXX";
  const int named = ::mkostemp(path.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(path.c_str());
  return named;
}

}  // namespace

Result<KeySpill> KeySpill::make(const std::string& folder) {
  const int file = unnamedFileIn(folder);
  if (file < 0) {
    return Error{ErrorKind::unreadable,
                 std::string("cannot make a temporary file: ") + std::strerror(errno), folder};
  }
  return KeySpill(file, folder);
}

KeySpill::~KeySpill() {
  if (file_ >= 0) ::close(file_);
}

KeySpill::KeySpill(KeySpill&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      folder_(std::move(other.folder_)),
      lists_(std::move(other.lists_)),
      blocks_(other.blocks_) {}

Error KeySpill::refusal(const char* what) const {
  return {ErrorKind::unreadable, std::string(what) + ": " + std::strerror(errno), folder_};
}

std::size_t KeySpill::addList() {
  lists_.emplace_back();
  return lists_.size() - 1;
}

Status KeySpill::append(std::size_t list, std::span<const float> numbers) {
  List& to = lists_[list];
  while (!numbers.empty()) {
    const std::size_t room = std::min(kBlockNumbers - to.open.size(), numbers.size());
    to.open.insert(to.open.end(), numbers.begin(),
                   numbers.begin() + static_cast<std::ptrdiff_t>(room));
    numbers = numbers.subspan(room);
    if (to.open.size() < kBlockNumbers) continue;
    if (Status written = writeBlock(to); !written) return written;
  }
  return {};
}

Status KeySpill::writeBlock(List& list) {
  const ByteView bytes = std::as_bytes(std::span(list.open));
  const std::uint64_t from = blocks_ * kBlockBytes;
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(from + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return refusal("cannot write a temporary file");
    done += static_cast<std::size_t>(count);
  }
  list.blocks.push_back(blocks_++);
  list.open.clear();
  return {};
}

std::uint64_t KeySpill::bytesOf(std::size_t list) const {
  const List& of = lists_[list];
  return of.blocks.size() * kBlockBytes + of.open.size() * sizeof(float);
}

Status KeySpill::read(std::size_t list, const std::function<Status(ByteView)>& use) const {
  std::array<std::byte, kBlockBytes> bytes;
  for (const std::uint64_t block : lists_[list].blocks) {
    const std::uint64_t from = block * kBlockBytes;
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count =
          ::pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(from + done));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return refusal("cannot read a temporary file");
      done += static_cast<std::size_t>(count);
    }
    if (Status used = use(bytes); !used) return used;
  }
  const std::vector<float>& open = lists_[list].open;
  return open.empty() ? Status{} : use(std::as_bytes(std::span(open)));
}

}  // namespace rocinante
