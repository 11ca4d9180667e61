#include "viewer/picture/png_files.h"

#ifdef __SSE2__

#include <emmintrin.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <initializer_list>
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

/// The concatenated content of the IDAT chunks; empty when the file is not a plain PNG.
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
  /// `compressed` is at most 4 GiB and is borrowed.
  explicit Inflater(std::vector<std::uint8_t>& compressed)
      : state_(std::make_unique<inflate_state>()) {  // 85 kB
    isal_inflate_init(state_.get());
    state_->crc_flag = ISAL_ZLIB;
    state_->next_in = compressed.data();
    state_->avail_in = static_cast<std::uint32_t>(compressed.size());
  }

  /// Reads the next `size` bytes; false when there are fewer.
  bool next(std::uint8_t* to, std::size_t size) {
    state_->next_out = to;
    state_->avail_out = static_cast<std::uint32_t>(size);
    return isal_inflate(state_.get()) == ISAL_DECOMP_OK && state_->avail_out == 0;
  }

  /// True when everything was read, nothing follows and the checksum was right.
  bool atEnd() {
    // The checksum may not have been read yet.
    std::uint8_t more = 0;
    state_->next_out = &more;
    state_->avail_out = 1;
    return isal_inflate(state_.get()) == ISAL_DECOMP_OK && state_->avail_out == 1 &&
           state_->block_state == ISAL_BLOCK_FINISH && state_->avail_in == 0 &&
           state_->read_in_length == 0;  // whole bytes read ahead
  }

 private:
  std::unique_ptr<inflate_state> state_;
};

/// Number of rows unfiltered in parallel. Each pixel depends on the one to its left; four rows,
/// each one pixel behind the row above, hide that latency.
constexpr std::size_t kRowsAtOnce = 4;

__m128i chosen(__m128i condition, __m128i yes, __m128i no) {
  return _mm_or_si128(_mm_and_si128(condition, yes), _mm_andnot_si128(condition, no));
}

/// The neighbour nearest to left + above - corner; ties prefer left, then above. In bytes: a corner
/// outside the range of the other two is never the nearest; between them its distance is the
/// difference of theirs.
__m128i paeth(__m128i left, __m128i above, __m128i corner) {
  const __m128i above_higher = _mm_subs_epu8(above, corner);
  const __m128i above_lower = _mm_subs_epu8(corner, above);
  const __m128i left_higher = _mm_subs_epu8(left, corner);
  const __m128i left_lower = _mm_subs_epu8(corner, left);
  const __m128i far_left = _mm_or_si128(above_higher, above_lower);
  const __m128i far_above = _mm_or_si128(left_higher, left_lower);
  const __m128i between = _mm_cmpeq_epi8(
      _mm_or_si128(_mm_min_epu8(above_higher, left_higher), _mm_min_epu8(above_lower, left_lower)),
      _mm_setzero_si128());
  const __m128i far_corner =
      _mm_or_si128(_mm_subs_epu8(far_left, far_above), _mm_subs_epu8(far_above, far_left));
  const __m128i nearer = _mm_min_epu8(far_left, far_above);
  const __m128i is_corner =
      _mm_andnot_si128(_mm_cmpeq_epi8(_mm_min_epu8(nearer, far_corner), nearer), between);
  const __m128i side = chosen(_mm_cmpeq_epi8(nearer, far_left), left, above);
  return chosen(is_corner, corner, side);
}

/// The first byte of a filtered row.
enum Filter : std::uint8_t { none, sub, up, average, paeth_filter };

/// Four rows unfiltered from left to right, each one pixel behind the row above: one pixel per row,
/// the uppermost in the lowest four bytes.
class FourPixels {
 public:
  explicit FourPixels(const std::array<std::uint8_t, kRowsAtOnce>& filters)
      : use_left_(where(filters, {sub, average, paeth_filter})),
        use_above_(where(filters, {up, average, paeth_filter})),
        use_corner_(where(filters, {paeth_filter})),
        use_average_(where(filters, {average})) {}

  /// Makes the next pixel of each row. `over` is the pixel above the first row's; above the others
  /// are the last made pixels.
  template <bool kAverages>
  __m128i next(__m128i filtered, std::uint32_t over) {
    const __m128i above =
        _mm_or_si128(_mm_slli_si128(made_, 4), _mm_cvtsi32_si128(static_cast<int>(over)));
    // Paeth's rule gives `left` if above and corner are zero, and `above` if left and corner are:
    // every filter except the average is Paeth's with some neighbours zero.
    __m128i guess = paeth(_mm_and_si128(made_, use_left_), _mm_and_si128(above, use_above_),
                          _mm_and_si128(corner_, use_corner_));
    if constexpr (kAverages) {
      const __m128i half_up = _mm_and_si128(_mm_xor_si128(made_, above), _mm_set1_epi8(1));
      const __m128i average_down = _mm_sub_epi8(_mm_avg_epu8(made_, above), half_up);
      guess = chosen(use_average_, average_down, guess);
    }
    corner_ = above;
    made_ = _mm_add_epi8(filtered, guess);
    return made_;
  }

 private:
  /// Mask of the rows that have one of these filters.
  static __m128i where(const std::array<std::uint8_t, kRowsAtOnce>& filters,
                       std::initializer_list<Filter> ones) {
    const auto bits = [&](std::size_t row) {
      return std::ranges::count(ones, filters[row]) > 0 ? -1 : 0;
    };
    return _mm_set_epi32(bits(3), bits(2), bits(1), bits(0));
  }

  __m128i use_left_, use_above_, use_corner_, use_average_;
  __m128i made_ = _mm_setzero_si128();    ///< the pixels made last
  __m128i corner_ = _mm_setzero_si128();  ///< the pixels above them
};

/// Four rows of one picture: source and destination.
struct FourRows {
  std::array<const std::uint8_t*, kRowsAtOnce> raw{};  ///< each with its filter byte
  const std::uint8_t* above = nullptr;                 ///< RGBA, or zeros
  std::array<std::uint8_t*, kRowsAtOnce> rgba{};
};

/// Reads four bytes per pixel: one beyond the row for three components.
template <int kComponents, bool kAverages>
void unfilter(const FourRows& rows, std::size_t width) {
  constexpr std::uint32_t kOpaque = kComponents == 3 ? 0xFF000000U : 0U;
  FourPixels pixels({rows.raw[0][0], rows.raw[1][0], rows.raw[2][0], rows.raw[3][0]});
  // Row r makes its pixel x in step x + r; pixels outside of the row are zero, like the first
  // pixel's neighbours.
  const auto step = [&]<bool kInside>(std::size_t at) {
    const auto isInside = [&](std::size_t row) { return kInside || at - row < width; };
    const auto filtered = [&](std::size_t row) {
      std::uint32_t pixel = 0;
      if (isInside(row)) std::memcpy(&pixel, rows.raw[row] + 1 + (at - row) * kComponents, 4);
      return _mm_cvtsi32_si128(static_cast<int>(pixel));
    };
    std::uint32_t over = 0;
    if (isInside(0)) std::memcpy(&over, rows.above + at * 4, 4);
    const __m128i upper = _mm_unpacklo_epi32(filtered(0), filtered(1));
    const __m128i lower = _mm_unpacklo_epi32(filtered(2), filtered(3));
    const __m128i made = pixels.next<kAverages>(_mm_unpacklo_epi64(upper, lower), over);
    const auto keep = [&](std::size_t row, __m128i in_lowest) {
      const auto pixel = static_cast<std::uint32_t>(_mm_cvtsi128_si32(in_lowest)) | kOpaque;
      if (isInside(row)) std::memcpy(rows.rgba[row] + (at - row) * 4, &pixel, 4);
    };
    keep(0, made);
    keep(1, _mm_srli_si128(made, 4));
    keep(2, _mm_srli_si128(made, 8));
    keep(3, _mm_srli_si128(made, 12));
  };
  constexpr std::size_t kBehind = kRowsAtOnce - 1;
  const std::size_t steps = width + kBehind;
  std::size_t at = 0;
  while (at < std::min(kBehind, steps)) step.template operator()<false>(at++);
  while (at < width) step.template operator()<true>(at++);
  while (at < steps) step.template operator()<false>(at++);
}

template <int kComponents>
bool decodeRows(Inflater& inflater, std::size_t width, std::size_t height, std::uint8_t* rgba) {
  const std::size_t row_bytes = width * kComponents + 1;
  // A few rows at a time, so that they stay cached until unfiltered.
  const std::size_t rows_at_once =
      kRowsAtOnce * std::max<std::size_t>(1, kPieceBytes / (row_bytes * kRowsAtOnce));
  // One more byte: the last RGB pixel is read as four bytes.
  std::vector<std::uint8_t> piece(std::min(rows_at_once, height) * row_bytes + 1);
  // The row above the first one, and the missing rows of the last four.
  const std::vector<std::uint8_t> zeros(width * 4 + 1);
  std::vector<std::uint8_t> nowhere(width * 4);
  FourRows four{.above = zeros.data()};
  for (std::size_t y = 0; y < height;) {
    const std::size_t rows = std::min(rows_at_once, height - y);
    if (!inflater.next(piece.data(), rows * row_bytes)) return false;
    for (std::size_t first = 0; first < rows; first += kRowsAtOnce) {
      bool averages = false;
      for (std::size_t i = 0; i < kRowsAtOnce; ++i) {
        const bool exists = first + i < rows;
        four.raw[i] = exists ? piece.data() + (first + i) * row_bytes : zeros.data();
        four.rgba[i] = exists ? rgba + (y + first + i) * width * 4 : nowhere.data();
        if (four.raw[i][0] > paeth_filter) return false;
        averages = averages || four.raw[i][0] == average;
      }
      averages ? unfilter<kComponents, true>(four, width)
               : unfilter<kComponents, false>(four, width);
      four.above = four.rgba.back();
    }
    y += rows;
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
