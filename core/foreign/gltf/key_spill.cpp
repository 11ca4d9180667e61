#include "core/foreign/gltf/key_spill.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kBlockNumbers = 1024;
constexpr std::size_t kBlockBytes = kBlockNumbers * sizeof(float);

}  // namespace

Result<KeySpill> KeySpill::make(const std::string& folder) {
  Result<UnnamedFile> file = UnnamedFile::make(folder);
  if (!file) return file.error();
  return KeySpill(std::move(*file));
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
  Status written = file_.write(blocks_ * kBlockBytes, std::as_bytes(std::span(list.open)));
  if (!written) return written;
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
    if (Status filled = file_.read(block * kBlockBytes, bytes); !filled) return filled;
    if (Status used = use(bytes); !used) return used;
  }
  const std::vector<float>& open = lists_[list].open;
  return open.empty() ? Status{} : use(std::as_bytes(std::span(open)));
}

}  // namespace rocinante
