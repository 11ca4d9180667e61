#include "core/foreign/table/stored_zip.h"

#include <algorithm>
#include <cassert>

#include "core/base/hash.h"
#include "core/foreign/bytes/little_endian.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kUnknown32 = 0xFFFFFFFF;  // "see the ZIP64 field"
constexpr std::uint16_t kZip64Version = 45;
constexpr std::uint16_t kUtf8Names = 1U << 11U;
constexpr std::uint16_t kDosDate = 0x21;  // 1980-01-01: no clock is read
constexpr std::uint64_t kCrcInHeader = 14;

void appendText(Bytes& out, std::string_view text) { appendBytes(out, bytesOf(text)); }

}  // namespace

Status StoredZip::put(ByteView bytes) {
  written_ += bytes.size();
  return out_.append(bytes);
}

Status StoredZip::beginEntry(std::string name, std::uint64_t size) {
  entries_.push_back({std::move(name), size, written_, 0});
  const std::string& shown = entries_.back().name;
  Bytes head;
  appendText(head, "PK\3\4");
  appendLittle(head, kZip64Version);
  appendLittle(head, kUtf8Names);
  appendLittle(head, std::uint16_t{0});  // stored
  appendLittle(head, std::uint16_t{0});  // 00:00
  appendLittle(head, kDosDate);
  appendLittle(head, std::uint32_t{0});  // the checksum, by endEntry()
  appendLittle(head, kUnknown32);
  appendLittle(head, kUnknown32);
  appendLittle(head, static_cast<std::uint16_t>(shown.size()));
  appendLittle(head, std::uint16_t{20});
  appendText(head, shown);
  appendLittle(head, std::uint16_t{1});  // ZIP64
  appendLittle(head, std::uint16_t{16});
  appendLittle(head, size);
  appendLittle(head, size);
  return put(head);
}

Status StoredZip::append(ByteView bytes) {
  entries_.back().crc = crc32(bytes, entries_.back().crc);
  return put(bytes);
}

Status StoredZip::endEntry() {
  Bytes crc;
  appendLittle(crc, entries_.back().crc);
  return out_.overwriteAt(entries_.back().offset + kCrcInHeader, crc);
}

Status StoredZip::end() {
  const std::uint64_t directory = written_;
  for (const Entry& entry : entries_) {
    Bytes head;
    appendText(head, "PK\1\2");
    appendLittle(head, kZip64Version);
    appendLittle(head, kZip64Version);
    appendLittle(head, kUtf8Names);
    appendLittle(head, std::uint16_t{0});
    appendLittle(head, std::uint16_t{0});
    appendLittle(head, kDosDate);
    appendLittle(head, entry.crc);
    appendLittle(head, kUnknown32);
    appendLittle(head, kUnknown32);
    appendLittle(head, static_cast<std::uint16_t>(entry.name.size()));
    appendLittle(head, std::uint16_t{28});
    appendLittle(head, std::uint16_t{0});  // no comment
    appendLittle(head, std::uint16_t{0});  // the first disk
    appendLittle(head, std::uint16_t{0});
    appendLittle(head, std::uint32_t{0});
    appendLittle(head, kUnknown32);
    appendText(head, entry.name);
    appendLittle(head, std::uint16_t{1});
    appendLittle(head, std::uint16_t{24});
    appendLittle(head, entry.size);
    appendLittle(head, entry.size);
    appendLittle(head, entry.offset);
    if (Status written = put(head); !written) return written;
  }
  const std::uint64_t end = written_;
  const std::uint64_t count = entries_.size();
  Bytes tail;
  appendText(tail, "PK\6\6");
  appendLittle(tail, std::uint64_t{44});
  appendLittle(tail, kZip64Version);
  appendLittle(tail, kZip64Version);
  appendLittle(tail, std::uint32_t{0});
  appendLittle(tail, std::uint32_t{0});
  appendLittle(tail, count);
  appendLittle(tail, count);
  appendLittle(tail, end - directory);
  appendLittle(tail, directory);
  appendText(tail, "PK\6\7");
  appendLittle(tail, std::uint32_t{0});
  appendLittle(tail, end);
  appendLittle(tail, std::uint32_t{1});
  appendText(tail, "PK\5\6");
  appendLittle(tail, std::uint16_t{0});
  appendLittle(tail, std::uint16_t{0});
  const auto shown = static_cast<std::uint16_t>(std::min<std::uint64_t>(count, 0xFFFF));
  appendLittle(tail, shown);
  appendLittle(tail, shown);
  appendLittle(tail,
               static_cast<std::uint32_t>(std::min<std::uint64_t>(end - directory, kUnknown32)));
  appendLittle(tail, static_cast<std::uint32_t>(std::min<std::uint64_t>(directory, kUnknown32)));
  appendLittle(tail, std::uint16_t{0});
  return put(tail);
}

}  // namespace rocinante
