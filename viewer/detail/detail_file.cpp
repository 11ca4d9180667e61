#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <bit>

#include "core/base/hash.h"
#include "core/base/struct_wire.h"
#include "viewer/detail/detail_cache.h"

namespace rocinante {

template <class Fields>
void fields(Fields& io, Taken<Fields, CoarsePart>& part) {
  auto& [error_m, first_index, two_sided_count, one_sided_count] = part;
  io(error_m, first_index, two_sided_count, one_sided_count);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, MeshDetail>& detail) {
  auto& [indices, parts] = detail;
  io(parts, indices);
}

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint32_t kLayout = 2;
constexpr std::size_t kHashBytes = 16;
constexpr std::size_t kMaxVersionsOfAPart = 64;

/// The start of a file: another layout or another meshoptimizer differs here.
struct DetailHead {
  std::array<char, 8> magic{'R', 'K', 'D', 'E', 'T', 'A', 'I', 'L'};
  std::uint32_t layout = kLayout;
  std::uint32_t meshoptimizer = MESHOPTIMIZER_VERSION;
  bool operator==(const DetailHead&) const = default;
};

template <class Fields>
void fields(Fields& io, Taken<Fields, DetailHead>& head) {
  auto& [magic, layout, meshoptimizer] = head;
  io(magic, layout, meshoptimizer);
}

bool areWithin(const std::vector<CoarsePart>& versions, std::size_t index_count) {
  double last_error = 0;
  for (const CoarsePart& part : versions) {
    const std::uint64_t end =
        std::uint64_t{part.first_index} + part.two_sided_count + part.one_sided_count;
    const bool is_whole = part.two_sided_count % 3 == 0 && part.one_sided_count % 3 == 0;
    const bool is_coarser = part.error_m >= last_error;  // false for NaN
    if (end > index_count || !is_whole || !is_coarser) return false;
    last_error = part.error_m;
  }
  return versions.size() <= kMaxVersionsOfAPart;
}

bool fits(const MeshDetail& detail, const Mesh& mesh) {
  return detail.parts.size() == mesh.parts.size() &&
         std::ranges::all_of(detail.parts,
                             [&](const std::vector<CoarsePart>& versions) {
                               return areWithin(versions, detail.indices.size());
                             }) &&
         std::ranges::all_of(detail.indices,
                             [&](std::uint32_t index) { return index < mesh.vertices.size(); });
}

}  // namespace

Bytes encodeDetail(const MeshDetail& detail, std::string_view key) {
  StructWriter writer;
  writer(DetailHead{}, std::string(key), detail);
  Bytes bytes = writer.take();
  const auto hash = xxh3(bytes);
  bytes.insert(bytes.end(), hash.begin(), hash.end());
  return bytes;
}

std::optional<MeshDetail> decodeDetail(ByteView bytes, std::string_view key,
                                       const DetailInput& input) {
  if (bytes.size() < kHashBytes) return std::nullopt;
  const ByteView content = bytes.first(bytes.size() - kHashBytes);
  if (!std::ranges::equal(xxh3(content), bytes.last(kHashBytes))) return std::nullopt;
  StructReader reader(content);
  DetailHead head{{}, 0, 0};
  std::string its_key;
  reader(head, its_key);
  if (head != DetailHead{} || its_key != key) return std::nullopt;
  MeshDetail detail;
  reader(detail);
  if (!reader.readAll() || !fits(detail, *input.mesh)) return std::nullopt;
  return detail;
}

}  // namespace rocinante
