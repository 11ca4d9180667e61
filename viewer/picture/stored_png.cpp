#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "core/base/hash.h"
#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

constexpr std::size_t kStoredBlock = 65535;

void addBigEndian(Bytes& bytes, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::byte>(number >> shift));
}

void addChunk(Bytes& png, std::string_view type, ByteView content) {
  addBigEndian(png, static_cast<std::uint32_t>(content.size()));
  const std::size_t from = png.size();
  const ByteView name = bytesOf(type);
  png.insert(png.end(), name.begin(), name.end());
  png.insert(png.end(), content.begin(), content.end());
  addBigEndian(png, crc32(ByteView(png).subspan(from)));
}

/// The zlib stream (RFC 1950) of `content` in stored blocks.
Bytes storedStream(ByteView content) {
  Bytes stream;
  stream.reserve(content.size() + (content.size() / kStoredBlock + 1) * 5 + 6);
  stream.push_back(std::byte{0x78});
  stream.push_back(std::byte{0x01});
  for (std::size_t at = 0; at < content.size(); at += kStoredBlock) {
    const std::size_t size = std::min(kStoredBlock, content.size() - at);
    stream.push_back(static_cast<std::byte>(at + size == content.size() ? 1 : 0));
    for (const std::size_t number : {size, ~size}) {
      stream.push_back(static_cast<std::byte>(number & 0xFFU));
      stream.push_back(static_cast<std::byte>(number >> 8U & 0xFFU));
    }
    const ByteView block = content.subspan(at, size);
    stream.insert(stream.end(), block.begin(), block.end());
  }
  addBigEndian(stream, static_cast<std::uint32_t>(adler32_z(
                           adler32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(content.data()),
                           content.size())));
  return stream;
}

bool isOpaque(const Picture& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] != 255) return false;
  }
  return true;
}

}  // namespace

Bytes storedPng(const Picture& picture) {
  if (picture.width < 1 || picture.height < 1) return {};
  const std::size_t components = isOpaque(picture) ? 3 : 4;
  const auto width = static_cast<std::size_t>(picture.width);
  const auto height = static_cast<std::size_t>(picture.height);
  const std::size_t row = 1 + width * components;
  if (row * height >= std::size_t{1} << 31U || picture.rgba.size() != width * height * 4) return {};

  Bytes rows(row * height);
  for (std::size_t y = 0; y < height; ++y) {
    std::byte* to = rows.data() + y * row + 1;  // filter 0: none
    const std::uint8_t* from = picture.rgba.data() + y * width * 4;
    if (components == 4) {
      std::memcpy(to, from, width * 4);
      continue;
    }
    for (std::size_t x = 0; x < width; ++x, to += 3, from += 4) std::memcpy(to, from, 3);
  }
  const Bytes stream = storedStream(rows);
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  Bytes png;
  png.reserve(stream.size() + 64);
  const ByteView signature = bytesOf(kSignature);
  png.insert(png.end(), signature.begin(), signature.end());
  Bytes header;
  addBigEndian(header, static_cast<std::uint32_t>(picture.width));
  addBigEndian(header, static_cast<std::uint32_t>(picture.height));
  // 8 bits; truecolour with or without alpha; deflate, adaptive filtering, not interlaced.
  for (const int byte : {8, components == 4 ? 6 : 2, 0, 0, 0}) {
    header.push_back(static_cast<std::byte>(byte));
  }
  addChunk(png, "IHDR", header);
  addChunk(png, "IDAT", stream);
  addChunk(png, "IEND", {});
  return png;
}

}  // namespace rocinante
