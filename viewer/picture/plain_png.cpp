#include "viewer/picture/plain_png.h"

#ifdef __SSE2__

#include <emmintrin.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>

namespace rocinante {
namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kPieceBytes = std::size_t{1} << 18U;
constexpr std::size_t kChunkRim = 12;  // length, type and checksum around a chunk's content

std::uint32_t bigEndian(const std::uint8_t* bytes) {
  return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) |
         (std::uint32_t{bytes[2]} << 8U) | bytes[3];
}

/// The content of the IDAT chunks, put together; empty when the file is not a plain one.
std::vector<std::uint8_t> compressedPixels(const std::uint8_t* bytes, std::size_t size) {
  std::vector<std::uint8_t> content;
  content.reserve(size);
  std::size_t at = kSignatureBytes;
  bool first = true;
  while (at + kChunkRim <= size) {
    const std::size_t length = bigEndian(bytes + at);
    if (length > size - at - kChunkRim) return {};
    const std::uint8_t* type = bytes + at + 4;
    const std::uint8_t* data = type + 4;
    if (crc32_gzip_refl(0, type, length + 4) != bigEndian(data + length)) return {};
    const std::string_view name(reinterpret_cast<const char*>(type), 4);
    at += kChunkRim + length;
    if (name == "IEND") return at == size && length == 0 ? content : std::vector<std::uint8_t>{};
    if (name != (first ? "IHDR" : "IDAT")) return {};
    if (!first) content.insert(content.end(), data, data + length);
    first = false;
  }
  return {};
}

/// Inflates a zlib stream piece by piece.
class Inflater {
 public:
  /// `compressed` is at most 4 GiB and stays where it is.
  explicit Inflater(std::vector<std::uint8_t>& compressed)
      : state_(std::make_unique<inflate_state>()) {  // 85 kB
    isal_inflate_init(state_.get());
    state_->crc_flag = ISAL_ZLIB;
    state_->next_in = compressed.data();
    state_->avail_in = static_cast<std::uint32_t>(compressed.size());
  }

  /// The next `size` bytes; false when there are not so many.
  bool next(std::uint8_t* to, std::size_t size) {
    state_->next_out = to;
    state_->avail_out = static_cast<std::uint32_t>(size);
    return isal_inflate(state_.get()) == ISAL_DECOMP_OK && state_->avail_out == 0;
  }

  /// True when all has been given out, nothing follows and the checksum was right.
  bool atEnd() {
    // The checksum may still have to be read.
    std::uint8_t more = 0;
    state_->next_out = &more;
    state_->avail_out = 1;
    return isal_inflate(state_.get()) == ISAL_DECOMP_OK && state_->avail_out == 1 &&
           state_->block_state == ISAL_BLOCK_FINISH && state_->avail_in == 0;
  }

 private:
  std::unique_ptr<inflate_state> state_;
};

__m128i widened(std::uint32_t pixel) {
  return _mm_unpacklo_epi8(_mm_cvtsi32_si128(static_cast<int>(pixel)), _mm_setzero_si128());
}

std::uint32_t narrowed(__m128i pixel) {
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_packus_epi16(pixel, pixel)));
}

__m128i magnitude(__m128i value) {
  return _mm_max_epi16(value, _mm_sub_epi16(_mm_setzero_si128(), value));
}

__m128i chosen(__m128i condition, __m128i yes, __m128i no) {
  return _mm_or_si128(_mm_and_si128(condition, yes), _mm_andnot_si128(condition, no));
}

/// The neighbour that lies nearest to left + above - corner; left before above before corner.
__m128i paeth(__m128i left, __m128i above, __m128i corner) {
  const __m128i to_left = _mm_sub_epi16(above, corner);
  const __m128i to_above = _mm_sub_epi16(left, corner);
  const __m128i far_left = magnitude(to_left);
  const __m128i far_above = magnitude(to_above);
  const __m128i far_corner = magnitude(_mm_add_epi16(to_left, to_above));
  const __m128i least = _mm_min_epi16(far_corner, _mm_min_epi16(far_left, far_above));
  return chosen(_mm_cmpeq_epi16(least, far_left), left,
                chosen(_mm_cmpeq_epi16(least, far_above), above, corner));
}

enum Filter : std::uint8_t { none, sub, up, average, paeth_filter };

/// One row of `raw` without its filter byte to `out`; `above` is the row before it, or zeros. Four
/// bytes are read for each pixel: one beyond the row when there are three components.
template <int kComponents, int kFilter>
void unfilterRow(const std::uint8_t* raw, const std::uint8_t* above, std::size_t width,
                 std::uint8_t* out) {
  constexpr std::uint32_t kOpaque = kComponents == 3 ? 0xFF000000U : 0U;
  const __m128i low_bytes = _mm_set1_epi16(0xFF);
  __m128i left = _mm_setzero_si128();
  __m128i corner = _mm_setzero_si128();
  for (std::size_t x = 0; x < width; ++x) {
    std::uint32_t pixel = 0;
    std::uint32_t above_pixel = 0;
    std::memcpy(&pixel, raw + x * kComponents, 4);
    std::memcpy(&above_pixel, above + x * 4, 4);
    const __m128i over = widened(above_pixel);
    __m128i value = widened(pixel);
    if constexpr (kFilter == sub) value = _mm_add_epi16(value, left);
    if constexpr (kFilter == up) value = _mm_add_epi16(value, over);
    if constexpr (kFilter == average) {
      value = _mm_add_epi16(value, _mm_srli_epi16(_mm_add_epi16(left, over), 1));
    }
    if constexpr (kFilter == paeth_filter) value = _mm_add_epi16(value, paeth(left, over, corner));
    left = _mm_and_si128(value, low_bytes);
    corner = over;
    const std::uint32_t done = narrowed(left) | kOpaque;
    std::memcpy(out + x * 4, &done, 4);
  }
}

/// One row with its filter byte in front; false when there is no such filter.
template <int kComponents>
bool unfilterRow(const std::uint8_t* raw, const std::uint8_t* above, std::size_t width,
                 std::uint8_t* rgba) {
  switch (raw[0]) {
    case none:
      unfilterRow<kComponents, none>(raw + 1, above, width, rgba);
      return true;
    case sub:
      unfilterRow<kComponents, sub>(raw + 1, above, width, rgba);
      return true;
    case up:
      unfilterRow<kComponents, up>(raw + 1, above, width, rgba);
      return true;
    case average:
      unfilterRow<kComponents, average>(raw + 1, above, width, rgba);
      return true;
    case paeth_filter:
      unfilterRow<kComponents, paeth_filter>(raw + 1, above, width, rgba);
      return true;
    default:
      return false;
  }
}

template <int kComponents>
bool decodeRows(Inflater& inflater, std::size_t width, std::size_t height, std::uint8_t* rgba) {
  const std::size_t row_bytes = width * kComponents + 1;
  // Some rows at a time, which stay in the cache until they are unfiltered.
  const std::size_t rows_at_once = std::max<std::size_t>(1, kPieceBytes / row_bytes);
  // One byte more: the last pixel of RGB is read as four.
  std::vector<std::uint8_t> piece(std::min(rows_at_once, height) * row_bytes + 1);
  const std::vector<std::uint8_t> before_first(width * 4);
  const std::uint8_t* above = before_first.data();
  for (std::size_t y = 0; y < height;) {
    const std::size_t rows = std::min(rows_at_once, height - y);
    if (!inflater.next(piece.data(), rows * row_bytes)) return false;
    for (std::size_t row = 0; row < rows; ++row, ++y) {
      if (!unfilterRow<kComponents>(piece.data() + row * row_bytes, above, width, rgba)) {
        return false;
      }
      above = rgba;
      rgba += width * 4;
    }
  }
  return inflater.atEnd();
}

}  // namespace

bool decodePlainPng(ByteView bytes, std::uint32_t width, std::uint32_t height, int components,
                    std::vector<std::uint8_t>& rgba) {
  assert(components == 3 || components == 4);
  assert(rgba.size() == std::size_t{width} * height * 4);
  std::vector<std::uint8_t> compressed =
      compressedPixels(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  if (compressed.empty() || compressed.size() > std::numeric_limits<std::uint32_t>::max()) {
    return false;
  }
  Inflater inflater(compressed);
  return components == 3 ? decodeRows<3>(inflater, width, height, rgba.data())
                         : decodeRows<4>(inflater, width, height, rgba.data());
}

}  // namespace rocinante

#else

namespace rocinante {

bool decodePlainPng(ByteView, std::uint32_t, std::uint32_t, int, std::vector<std::uint8_t>&) {
  return false;
}

}  // namespace rocinante

#endif
