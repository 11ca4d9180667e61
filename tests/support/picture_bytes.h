#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/hash.h"

// Picture files written by hand, byte by byte.

namespace rocinante::test {

inline void appendBigEndian(std::string& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to += static_cast<char>(value >> shift & 0xFFU);
}

inline std::string pngChunk(const std::string& type, const std::string& content) {
  std::string bytes;
  appendBigEndian(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += type + content;
  appendBigEndian(bytes, crc32(bytesOf(type + content)));
  return bytes;
}

inline std::string pngHeader(std::uint32_t width, std::uint32_t height, int depth, int color_type) {
  std::string header;
  appendBigEndian(header, width);
  appendBigEndian(header, height);
  header += {static_cast<char>(depth), static_cast<char>(color_type), 0, 0, 0};
  return pngChunk("IHDR", header);
}

inline std::string zlibStream(const std::string& content) {
  std::string packed(::compressBound(content.size()), '\0');
  uLongf length = packed.size();
  EXPECT_EQ(::compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                       reinterpret_cast<const Bytef*>(content.data()), content.size()),
            Z_OK);
  packed.resize(length);
  return packed;
}

inline const std::string kPngSignature = "\x89PNG\r\n\x1A\n";

/// `rows` are the filtered rows, each behind its filter byte.
inline std::string pngFile(std::uint32_t width, std::uint32_t height, int depth, int color_type,
                           const std::string& rows, const std::string& more_chunks = "") {
  return kPngSignature + pngHeader(width, height, depth, color_type) + more_chunks +
         pngChunk("IDAT", zlibStream(rows)) + pngChunk("IEND", "");
}

/// OpenEXR 2.0, scan lines, not compressed, 32-bit floating point. `channels` are the names in
/// alphabetical order; `values` are rows top to bottom, in each row channel by channel.
inline std::string exrFile(std::int32_t width, std::int32_t height, const std::string& channels,
                           const std::vector<float>& values) {
  std::string bytes;
  const auto u32 = [&](std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFFU);
  };
  const auto text = [&](const std::string& value) { bytes += value + '\0'; };
  const auto attribute = [&](const std::string& name, const std::string& type, std::uint32_t size) {
    text(name);
    text(type);
    u32(size);
  };
  const auto window = [&](const std::string& name) {
    attribute(name, "box2i", 16);
    for (const std::int32_t value : {0, 0, width - 1, height - 1}) {
      u32(static_cast<std::uint32_t>(value));
    }
  };
  const auto number = [&](const std::string& name, float value) {
    attribute(name, "float", 4);
    u32(std::bit_cast<std::uint32_t>(value));
  };
  u32(20000630);
  u32(2);
  attribute("channels", "chlist", static_cast<std::uint32_t>(channels.size() * 18 + 1));
  for (const char channel : channels) {
    text(std::string(1, channel));
    u32(2);  // 32-bit floating point
    u32(0);  // not linear for perception
    u32(1);
    u32(1);  // every pixel
  }
  bytes += '\0';
  attribute("compression", "compression", 1);
  bytes += '\0';
  window("dataWindow");
  window("displayWindow");
  attribute("lineOrder", "lineOrder", 1);
  bytes += '\0';
  number("pixelAspectRatio", 1);
  attribute("screenWindowCenter", "v2f", 8);
  u32(0);
  u32(0);
  number("screenWindowWidth", 1);
  bytes += '\0';
  const std::size_t row_values = static_cast<std::size_t>(width) * channels.size();
  const std::size_t first = bytes.size() + 8 * static_cast<std::size_t>(height);
  for (std::int32_t y = 0; y < height; ++y) {
    u32(static_cast<std::uint32_t>(first + static_cast<std::size_t>(y) * (8 + row_values * 4)));
    u32(0);
  }
  for (std::int32_t y = 0; y < height; ++y) {
    u32(static_cast<std::uint32_t>(y));
    u32(static_cast<std::uint32_t>(row_values * 4));
    for (std::size_t i = 0; i < row_values; ++i) {
      u32(std::bit_cast<std::uint32_t>(values[static_cast<std::size_t>(y) * row_values + i]));
    }
  }
  return bytes;
}

}  // namespace rocinante::test
