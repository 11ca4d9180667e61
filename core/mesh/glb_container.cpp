#include "core/mesh/glb_container.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace rocinante {
namespace {

constexpr std::size_t kDeepestJson = 100;  // brackets in brackets
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

// The format is little-endian, and so is every machine that we run on.
std::uint32_t numberAt(ByteView bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, 4);
  return number;
}

void addNumber(Bytes& bytes, std::size_t number) {
  const auto narrow = static_cast<std::uint32_t>(number);
  const auto* from = reinterpret_cast<const std::byte*>(&narrow);
  bytes.insert(bytes.end(), from, from + 4);
}

bool isTooDeep(std::string_view text) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepestJson) return true;
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return false;
}

Result<GltfParts> chunksOf(ByteView bytes) {
  if (!isGlb(bytes)) return GltfParts{textOf(bytes), {}};
  if (bytes.size() < 20 || numberAt(bytes, 12) > bytes.size() - 20) {
    return Error{ErrorKind::damaged, "ends inside its first chunk", {}};
  }
  if (numberAt(bytes, 4) != 2) {
    return Error{ErrorKind::unsupported,
                 fmt::format("is binary glTF {}; only 2 is read", numberAt(bytes, 4)),
                 {}};
  }
  if (numberAt(bytes, 16) != kJsonChunk) {
    return Error{ErrorKind::damaged, "its first chunk is not JSON", {}};
  }
  const std::size_t text_bytes = numberAt(bytes, 12);
  GltfParts parts{textOf(bytes.subspan(20, text_bytes)), {}};
  // Chunks begin at multiples of four.
  const std::size_t next = 20 + (text_bytes + 3) / 4 * 4;
  if (next + 8 <= bytes.size() && numberAt(bytes, next + 4) == kBinaryChunk) {
    const std::size_t binary_bytes = numberAt(bytes, next);
    if (binary_bytes > bytes.size() - next - 8) {
      return Error{ErrorKind::damaged, "ends inside its binary chunk", {}};
    }
    parts.binary = bytes.subspan(next + 8, binary_bytes);
  }
  return parts;
}

}  // namespace

bool isGlb(ByteView bytes) { return textOf(bytes).starts_with("glTF"); }

Result<GltfParts> gltfParts(ByteView bytes) {
  Result<GltfParts> parts = chunksOf(bytes);
  if (!parts) return parts;
  if (parts->text.starts_with("\xEF\xBB\xBF")) parts->text.remove_prefix(3);
  if (isTooDeep(parts->text)) {
    return Error{ErrorKind::damaged, "the JSON is nested deeper than 100", {}};
  }
  return parts;
}

Bytes glbHead(std::string_view text, std::uint64_t binary_bytes) {
  const std::size_t text_bytes = (text.size() + 3) / 4 * 4;
  const std::uint64_t binary_whole = binary_bytes > 0 ? 8 + binary_bytes : 0;
  Bytes head;
  head.reserve(28 + text_bytes);
  addNumber(head, kMagic);
  addNumber(head, 2);
  addNumber(head, 20 + text_bytes + binary_whole);
  addNumber(head, text_bytes);
  addNumber(head, kJsonChunk);
  const ByteView content = bytesOf(text);
  head.insert(head.end(), content.begin(), content.end());
  head.resize(20 + text_bytes, std::byte{' '});
  if (binary_bytes == 0) return head;
  addNumber(head, binary_bytes);
  addNumber(head, kBinaryChunk);
  return head;
}

Bytes glbOf(const GltfParts& parts) {
  const std::size_t binary_bytes = (parts.binary.size() + 3) / 4 * 4;
  Bytes whole = glbHead(parts.text, binary_bytes);
  const std::size_t size = whole.size() + binary_bytes;
  whole.insert(whole.end(), parts.binary.begin(), parts.binary.end());
  whole.resize(size);
  return whole;
}

}  // namespace rocinante
