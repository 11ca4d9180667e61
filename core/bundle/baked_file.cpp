#include "core/bundle/baked_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <set>
#include <span>
#include <string_view>

#include "core/base/hash.h"

namespace rocinante {
namespace {

static_assert(std::endian::native == std::endian::little);

/// As PNG's: a bit that text transfers lose, and line ends that they change.
constexpr std::string_view kBakedMagic = "\x8BRKCELL\n";
constexpr std::size_t kRowBytes = 24;  // id, CRC, offset, length
constexpr std::size_t kHeadBytes = 8 + 4 + 4 + 16 + 8;
constexpr std::size_t kHeadCrcBytes = 4;

void appendBytes(Bytes& bytes, ByteView more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

template <class Number>
void appendNumber(Bytes& bytes, Number number) {
  appendBytes(bytes, std::as_bytes(std::span(&number, 1)));
}

template <class Number>
Number numberAt(ByteView bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

std::size_t headBytes(std::size_t sections) {
  return kHeadBytes + sections * kRowBytes + kHeadCrcBytes;
}

}  // namespace

Bytes bakedFile(const BakedKey& key, const std::vector<BakedFile::Section>& sections) {
  assert(sections.size() <= BakedFile::kMaxSections);
  const std::size_t head = headBytes(sections.size());
  std::size_t total = head;
  for (const BakedFile::Section& section : sections) total += section.content.size();
  Bytes bytes;
  bytes.reserve(total);
  appendBytes(bytes, bytesOf(kBakedMagic));
  appendNumber<std::uint32_t>(bytes, BakedFile::kFormat);
  appendNumber<std::uint32_t>(bytes, static_cast<std::uint32_t>(sections.size()));
  appendBytes(bytes, key);
  appendNumber<std::uint64_t>(bytes, total);
  std::uint64_t offset = head;
  for (const BakedFile::Section& section : sections) {
    appendNumber<std::uint32_t>(bytes, section.id);
    appendNumber<std::uint32_t>(bytes, crc32(section.content));
    appendNumber<std::uint64_t>(bytes, offset);
    appendNumber<std::uint64_t>(bytes, section.content.size());
    offset += section.content.size();
  }
  appendNumber<std::uint32_t>(bytes, crc32(bytes));
  for (const BakedFile::Section& section : sections) appendBytes(bytes, section.content);
  return bytes;
}

Result<BakedFile> BakedFile::parse(ByteView bytes, const std::string& name) {
  const auto damaged = [&](std::string what) {
    return Error{ErrorKind::damaged, std::move(what), name};
  };
  if (bytes.size() < headBytes(0) || textOf(bytes.first(kBakedMagic.size())) != kBakedMagic) {
    return damaged("this is not a baked cell");
  }
  const auto format = numberAt<std::uint32_t>(bytes, 8);
  if (format != kFormat) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("the baked cell has format {}, this version reads {}", format, kFormat), name};
  }
  const auto count = numberAt<std::uint32_t>(bytes, 12);
  if (count > kMaxSections || headBytes(count) > bytes.size()) {
    return damaged("the baked cell is cut within its table");
  }
  const std::size_t head = headBytes(count);
  if (crc32(bytes.first(head - kHeadCrcBytes)) !=
      numberAt<std::uint32_t>(bytes, head - kHeadCrcBytes)) {
    return damaged("the baked cell's table fails its checksum");
  }
  BakedFile file;
  file.name_ = name;
  std::memcpy(file.key_.data(), bytes.data() + 16, file.key_.size());
  if (numberAt<std::uint64_t>(bytes, 32) != bytes.size()) {
    return damaged(fmt::format("the baked cell has {} bytes, its table says {}", bytes.size(),
                               numberAt<std::uint64_t>(bytes, 32)));
  }
  std::uint64_t offset = head;
  std::set<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t row = kHeadBytes + i * kRowBytes;
    const auto id = numberAt<std::uint32_t>(bytes, row);
    const auto length = numberAt<std::uint64_t>(bytes, row + 16);
    if (numberAt<std::uint64_t>(bytes, row + 8) != offset || length > bytes.size() - offset ||
        !ids.insert(id).second) {
      return damaged(
          fmt::format("section {} of the baked cell is not where the one before it ends", id));
    }
    const ByteView content =
        bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
    if (crc32(content) != numberAt<std::uint32_t>(bytes, row + 4)) {
      return damaged(fmt::format("section {} of the baked cell fails its checksum", id));
    }
    file.sections_.push_back({id, content});
    offset += length;
  }
  if (offset != bytes.size()) return damaged("something follows the baked cell's sections");
  return file;
}

Result<ByteView> BakedFile::section(std::uint32_t id) const {
  for (const Section& section : sections_) {
    if (section.id == id) return section.content;
  }
  return Error{ErrorKind::damaged, fmt::format("the baked cell has no section {}", id), name_};
}

}  // namespace rocinante
