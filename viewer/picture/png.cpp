#include <fmt/format.h>
#include <spng.h>
#include <sys/mman.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <limits>
#include <memory>

#include "core/base/atomic_file.h"
#include "viewer/picture/exif_orientation.h"
#include "viewer/picture/fine_picture.h"
#include "viewer/picture/picture.h"
#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

/// Larger text and profile chunks are refused: they hold nothing that we use.
constexpr std::size_t kChunkBytes = std::size_t{64} << 20U;
/// A compromise: goldens are kept for long, and videos have many frames.
constexpr int kCompressionLevel = 5;

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, FreeContext>;

Bytes encode(const spng_ihdr& header, const void* pixels, std::size_t bytes) {
  const Context context(spng_ctx_new(SPNG_CTX_ENCODER));
  spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel);
  spng_ihdr written = header;
  spng_set_ihdr(context.get(), &written);
  int code = spng_encode_image(context.get(), pixels, bytes, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t length = 0;
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  const std::unique_ptr<void, Free> png(
      code == 0 ? spng_get_png_buffer(context.get(), &length, &code) : nullptr);
  // Encoding a complete picture can only fail without memory.
  if (!png) return {};
  const auto* first = static_cast<const std::byte*>(png.get());
  return Bytes(first, first + length);
}

spng_ihdr headerOf(int width, int height, std::uint8_t bit_depth, std::uint8_t color_type) {
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(width);
  header.height = static_cast<std::uint32_t>(height);
  header.bit_depth = bit_depth;
  header.color_type = color_type;
  return header;
}

/// The number of components by header and tRNS; call it after decoding.
int componentsOf(spng_ctx* context, const spng_ihdr& header) {
  spng_trns transparent{};
  const bool has_alpha = (header.color_type & SPNG_COLOR_TYPE_GRAYSCALE_ALPHA) != 0 ||
                         spng_get_trns(context, &transparent) == 0;
  const bool has_color = (header.color_type & SPNG_COLOR_TYPE_TRUECOLOR) != 0;
  return (has_color ? 3 : 1) + (has_alpha ? 1 : 0);
}

/// Lets the kernel use 2 MiB pages for large untouched memory: faults per 4 KiB take a tenth of the
/// time of a large picture. Failure is harmless.
void adviseHugePages(void* memory, std::size_t bytes) {
  constexpr std::size_t kHugePage = std::size_t{2} << 20U;
  std::size_t space = bytes;
  if (std::align(kHugePage, kHugePage, memory, space) == nullptr) return;
  ::madvise(memory, space - space % kHugePage, MADV_HUGEPAGE);
}

/// Stores 16-bit RGBA in native byte order as samples, and truncated to 8 bits.
void takeSixteenBits(const std::vector<std::uint16_t>& rgba, FinePicture& fine) {
  fine.samples.assign(rgba.begin(), rgba.end());
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    fine.picture.rgba[i] = static_cast<std::uint8_t>(rgba[i] >> 8U);
  }
}

/// libspng reads colours outside the palette as black; only judging refuses them.
Status checkPalette(ByteView bytes, const std::string& name) {
  const Context context(spng_ctx_new(0));
  spng_set_png_buffer(context.get(), bytes.data(), bytes.size());
  spng_ihdr header{};
  spng_plte palette{};
  std::size_t size = 0;
  int code = spng_get_ihdr(context.get(), &header);
  if (code == 0) code = spng_get_plte(context.get(), &palette);
  if (code == 0) code = spng_decoded_image_size(context.get(), SPNG_FMT_RAW, &size);
  std::vector<std::uint8_t> places(code == 0 ? size : 0);
  if (code == 0) {
    code = spng_decode_image(context.get(), places.data(), places.size(), SPNG_FMT_RAW, 0);
  }
  if (code != 0) {
    return Error{ErrorKind::damaged, std::string("is not a valid PNG: ") + spng_strerror(code),
                 name};
  }
  // Rows begin at a byte; smaller pixels are packed from the highest bits.
  const std::size_t depth = header.bit_depth, row_bytes = size / header.height;
  for (std::size_t i = 0; i < std::size_t{header.width} * header.height; ++i) {
    const std::size_t x = i % header.width, y = i / header.width;
    const std::size_t shift = 8 - depth - x * depth % 8;
    const std::uint32_t place =
        (std::uint32_t{places[y * row_bytes + x * depth / 8]} >> shift) & ((1U << depth) - 1);
    if (place < palette.n_entries) continue;
    return Error{ErrorKind::damaged,
                 fmt::format("is not a valid PNG: pixel ({}, {}) is colour {} of a palette of {}",
                             x, y, place, palette.n_entries),
                 name};
  }
  return {};
}

/// For judging, 16-bit pictures include their samples, and faults that decoders ignore are refused.
int orientationOf(spng_ctx* context) {
  spng_exif exif{};
  if (spng_get_exif(context, &exif) != 0) return 1;
  return exifOrientation({reinterpret_cast<const std::byte*>(exif.data), exif.length});
}

Result<FinePicture> decode(ByteView bytes, const std::string& name, std::int64_t max_pixels,
                           bool to_judge) {
  const auto refusal = [&](ErrorKind kind, std::string what) {
    return Error{kind, std::move(what), name};
  };
  const auto damaged = [&](int code) {
    return refusal(ErrorKind::damaged, std::string("is not a valid PNG: ") + spng_strerror(code));
  };
  const Context context(spng_ctx_new(0));
  if (!context) return refusal(ErrorKind::refused, "not enough memory to decode");
  spng_set_chunk_limits(context.get(), kChunkBytes, kChunkBytes);
  spng_set_png_buffer(context.get(), bytes.data(), bytes.size());
  spng_ihdr header{};
  if (const int code = spng_get_ihdr(context.get(), &header); code != 0) return damaged(code);
  constexpr std::uint32_t kLargestSide = std::numeric_limits<int>::max();
  const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
  const bool deep = to_judge && header.bit_depth == 16;
  if (deep) max_pixels = std::min(max_pixels, kMaxDeepPixels);
  if (header.width > kLargestSide || header.height > kLargestSide || max_pixels < 0 ||
      pixels > static_cast<std::uint64_t>(max_pixels)) {
    return refusal(ErrorKind::unsupported, "is " + std::to_string(header.width) + " x " +
                                               std::to_string(header.height) + " pixels; at most " +
                                               std::to_string(max_pixels) + " are read");
  }
  // Checked before allocating pixels: deflate compresses a thousandfold at most.
  if (pixels / 1100 / 8 > bytes.size()) {
    return refusal(ErrorKind::damaged, "is not a valid PNG: too short for its size");
  }
  FinePicture fine;
  fine.picture = {static_cast<int>(header.width), static_cast<int>(header.height), {}};
  fine.picture.rgba.reserve(pixels * 4);
  adviseHugePages(fine.picture.rgba.data(), pixels * 4);
  fine.picture.rgba.resize(pixels * 4);
  const bool plain = header.bit_depth == 8 && header.interlace_method == 0 &&
                     (header.color_type == SPNG_COLOR_TYPE_TRUECOLOR ||
                      header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA);
  fine.encoding = {header.color_type == SPNG_COLOR_TYPE_TRUECOLOR ? 3 : 4, 8, false};
  if (plain && decodePlainPng(bytes, header.width, header.height, fine.encoding.components,
                              fine.picture.rgba)) {
    if (to_judge) fine.orientation = orientationOf(context.get());
    return fine;
  }
  std::vector<std::uint16_t> wide(deep ? pixels * 4 : 0);
  const int code =
      deep ? spng_decode_image(context.get(), wide.data(), wide.size() * 2, SPNG_FMT_RGBA16,
                               SPNG_DECODE_TRNS)
           : spng_decode_image(context.get(), fine.picture.rgba.data(), fine.picture.rgba.size(),
                               SPNG_FMT_RGBA8, SPNG_DECODE_TRNS);
  if (code != 0) return damaged(code);
  // Read to the end, so that the last checksums are checked too.
  if (const int end = spng_decode_chunks(context.get()); end != 0) return damaged(end);
  if (to_judge) {
    fine.orientation = orientationOf(context.get());
    if (Status whole = checkWholePng(bytes, name); !whole) return whole.error();
    if (header.color_type == SPNG_COLOR_TYPE_INDEXED) {
      if (Status known = checkPalette(bytes, name); !known) return known.error();
    }
  }
  if (deep) takeSixteenBits(wide, fine);
  fine.encoding = {componentsOf(context.get(), header), header.bit_depth == 16 ? 16 : 8, false};
  return fine;
}

}  // namespace

Result<Picture> decodePng(ByteView bytes, std::string name, std::int64_t max_pixels) {
  auto fine = decode(bytes, name, max_pixels, false);
  if (!fine.ok()) return fine.error();
  return std::move(fine->picture);
}

Result<FinePicture> decodeFinePng(ByteView bytes, const std::string& name,
                                  std::int64_t max_pixels) {
  return decode(bytes, name, max_pixels, true);
}

Result<Picture> readPng(const std::filesystem::path& path, std::int64_t max_pixels) {
  const Result<std::string> content = readFile(path);
  if (!content) return content.error();
  return decodePng(bytesOf(*content), path.string(), max_pixels);
}

Bytes encodePng(const Picture& picture) {
  assert(picture.width > 0 && picture.height > 0);
  assert(picture.rgba.size() == std::size_t{4} * static_cast<std::size_t>(picture.width) *
                                    static_cast<std::size_t>(picture.height));
  return encode(headerOf(picture.width, picture.height, 8, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA),
                picture.rgba.data(), picture.rgba.size());
}

Bytes encodeGreyPng(int width, int height, std::span<const std::uint16_t> grey) {
  assert(width > 0 && height > 0);
  assert(grey.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return encode(headerOf(width, height, 16, SPNG_COLOR_TYPE_GRAYSCALE), grey.data(),
                grey.size_bytes());
}

Status writePng(const std::filesystem::path& path, const Picture& picture, bool overwrite) {
  const Bytes png = encodePng(picture);
  if (png.empty()) return Error{ErrorKind::refused, "not enough memory to encode", path.string()};
  return writeFileWhole(path, png, overwrite);
}

}  // namespace rocinante
