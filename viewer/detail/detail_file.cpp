#include <meshoptimizer.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>

#include "core/base/hash.h"
#include "viewer/detail/detail_cache.h"

namespace rocinante {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kMagic = "RKDETAIL";
constexpr std::uint32_t kLayout = 1;
constexpr std::size_t kKeyBytes = 32;
constexpr std::size_t kHashBytes = 16;
constexpr std::uint32_t kMaxVersionsOfAPart = 64;

void append(Bytes& bytes, ByteView more) {
  const std::size_t before = bytes.size();
  bytes.resize(before + more.size());
  if (!more.empty()) std::memcpy(bytes.data() + before, more.data(), more.size());
}

template <class Number>
void put(Bytes& bytes, Number number) {
  append(bytes, std::as_bytes(std::span(&number, 1)));
}

/// Reads numbers from the front; returns zeros after the end, and ok() becomes false.
class NumberReader {
 public:
  explicit NumberReader(ByteView bytes) : left_(bytes) {}

  template <class Number>
  Number take() {
    Number number{};
    if (left_.size() < sizeof number) {
      ok_ = false;
      return number;
    }
    std::memcpy(&number, left_.data(), sizeof number);
    left_ = left_.subspan(sizeof number);
    return number;
  }
  bool ok() const { return ok_; }
  ByteView left() const { return left_; }

 private:
  ByteView left_;
  bool ok_ = true;
};

bool withinIndices(const CoarsePart& part, std::size_t index_count) {
  const std::uint64_t end =
      std::uint64_t{part.first_index} + part.two_sided_count + part.one_sided_count;
  return end <= index_count && part.two_sided_count % 3 == 0 && part.one_sided_count % 3 == 0;
}

}  // namespace

Bytes encodeDetail(const MeshDetail& detail, std::string_view key) {
  Bytes bytes;
  append(bytes, bytesOf(kMagic));
  put<std::uint32_t>(bytes, kLayout);
  put<std::uint32_t>(bytes, MESHOPTIMIZER_VERSION);
  append(bytes, bytesOf(key));
  put<std::uint64_t>(bytes, detail.parts.size());
  put<std::uint64_t>(bytes, detail.indices.size());
  for (const auto& versions : detail.parts) {
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(versions.size()));
    for (const CoarsePart& part : versions) {
      put<double>(bytes, part.error_m);
      put<std::uint32_t>(bytes, part.first_index);
      put<std::uint32_t>(bytes, part.two_sided_count);
      put<std::uint32_t>(bytes, part.one_sided_count);
    }
  }
  append(bytes, std::as_bytes(std::span(detail.indices)));
  append(bytes, xxh3(bytes));
  return bytes;
}

std::optional<MeshDetail> decodeDetail(ByteView bytes, std::string_view key,
                                       const DetailInput& input) {
  if (bytes.size() < kMagic.size() + kKeyBytes + kHashBytes) return std::nullopt;
  const ByteView content = bytes.first(bytes.size() - kHashBytes);
  if (!std::ranges::equal(xxh3(content), bytes.last(kHashBytes))) return std::nullopt;
  if (textOf(content.first(kMagic.size())) != kMagic) return std::nullopt;
  NumberReader versions(content.subspan(kMagic.size()));
  if (versions.take<std::uint32_t>() != kLayout) return std::nullopt;
  if (versions.take<std::uint32_t>() != MESHOPTIMIZER_VERSION) return std::nullopt;
  if (versions.left().size() < kKeyBytes || textOf(versions.left().first(kKeyBytes)) != key) {
    return std::nullopt;
  }
  NumberReader reader(versions.left().subspan(kKeyBytes));
  const auto part_count = reader.take<std::uint64_t>();
  const auto index_count = reader.take<std::uint64_t>();
  if (!reader.ok() || part_count != input.mesh->parts.size() ||
      index_count > reader.left().size() / sizeof(std::uint32_t)) {
    return std::nullopt;
  }
  MeshDetail detail;
  detail.parts.resize(static_cast<std::size_t>(part_count));
  for (auto& coarser : detail.parts) {
    const auto count = reader.take<std::uint32_t>();
    if (!reader.ok() || count > kMaxVersionsOfAPart) return std::nullopt;
    double last_error = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      CoarsePart part;
      part.error_m = reader.take<double>();
      part.first_index = reader.take<std::uint32_t>();
      part.two_sided_count = reader.take<std::uint32_t>();
      part.one_sided_count = reader.take<std::uint32_t>();
      if (!reader.ok() || !withinIndices(part, index_count) || !(part.error_m >= last_error)) {
        return std::nullopt;
      }
      last_error = part.error_m;
      coarser.push_back(part);
    }
  }
  if (reader.left().size() != index_count * sizeof(std::uint32_t)) return std::nullopt;
  detail.indices.resize(static_cast<std::size_t>(index_count));
  if (index_count > 0) {
    std::memcpy(detail.indices.data(), reader.left().data(), reader.left().size());
  }
  const std::size_t vertices = input.mesh->vertices.size();
  if (std::ranges::any_of(detail.indices, [&](std::uint32_t i) { return i >= vertices; })) {
    return std::nullopt;
  }
  return detail;
}

}  // namespace rocinante
