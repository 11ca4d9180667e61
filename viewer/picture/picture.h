#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// 8-bit RGBA, straight alpha, rows top to bottom, no padding.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< width * height * 4

  ByteView bytes() const { return std::as_bytes(std::span(rgba)); }
  bool operator==(const Picture&) const = default;
};

/// PNG through libspng: any colour type and depth in, 8-bit RGBA out. The size is checked against
/// `max_pixels` before anything is allocated.
Result<Picture> readPng(const std::filesystem::path& path, std::int64_t max_pixels = 1 << 28);
Result<Picture> decodePng(ByteView bytes, std::string name, std::int64_t max_pixels = 1 << 28);
/// Encodes as PNG. The same picture (and version of zlib) gives the same bytes.
Bytes encodePng(const Picture& picture);
/// Encodes one 16-bit component per pixel, rows top to bottom, for measured values.
Bytes encodeGreyPng(int width, int height, std::span<const std::uint16_t> grey);
/// Writes a temporary file and renames it: the file appears whole or not at all. refused when it
/// exists and `overwrite` is false.
Status writePng(const std::filesystem::path& path, const Picture& picture, bool overwrite = true);

/// Any picture: PNG by libspng, all else by the OpenImageIO module (librocinante_openimageio.so),
/// which is loaded on first use because linking it costs 0.3 s before main. The content decides the
/// format, not the name. unsupported when the module is missing. Grey becomes equal components, 16
/// bits are truncated to the upper eight, linear floating point gets the sRGB curve. The same bytes
/// on every CPU. Any thread.
Result<Picture> readPicture(const std::filesystem::path& path, std::int64_t max_pixels = 1 << 28);
/// The same from bytes; `name` is used in messages.
Result<Picture> decodePicture(ByteView bytes, const std::string& name,
                              std::int64_t max_pixels = 1 << 28);

/// SHA-256 of the RGBA rows, top to bottom, in hexadecimal: what `render --hash` prints.
std::string pictureSha256(const Picture& picture);
/// XXH3-128 over width, height (u32, little-endian) and the RGBA rows: the manifest's pixel hash.
std::string pictureXxh3(const Picture& picture);

}  // namespace rocinante
