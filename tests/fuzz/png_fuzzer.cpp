// PNGs: of any bytes, or, so that more than checksums is tried, of a header and rows that the input
// says, packed soundly. Decoding for a look and for a judge agree, the fast decoder sees what
// libspng sees, and what a judge takes has nothing behind its end.
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "core/base/hash.h"
#include "viewer/picture/fine_picture.h"
#include "viewer/picture/png_files.h"

using namespace rocinante;

namespace {

constexpr std::int64_t kMaxPixels = 1 << 16;

void require(bool sound) {
  if (!sound) std::abort();
}

std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFFU);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& content) {
  return bigEndian(static_cast<std::uint32_t>(content.size())) + type + content +
         bigEndian(crc32(bytesOf(type + content)));
}

std::string packed(const std::string& content) {
  std::string bytes(::compressBound(content.size()), '\0');
  uLongf length = bytes.size();
  require(::compress2(reinterpret_cast<Bytef*>(bytes.data()), &length,
                      reinterpret_cast<const Bytef*>(content.data()), content.size(), 1) == Z_OK);
  bytes.resize(length);
  return bytes;
}

/// Seven bytes of header, one that chooses chunks, their content, rows. `more`: a chunk that keeps
/// the fast decoder away.
std::string madeOf(const std::string& input, bool more) {
  const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(input[i]); };
  const std::string header =
      bigEndian(at(0)) + bigEndian(at(1)) +
      std::string{static_cast<char>(1U << at(2) % 5), static_cast<char>(at(3) % 7), '\0', '\0',
                  static_cast<char>(at(4) % 2)};
  const std::size_t palette = std::min<std::size_t>(at(5), input.size() - 8);
  const std::size_t behind = std::min<std::size_t>(at(6) % 4, input.size() - 8 - palette);
  std::string file = "\x89PNG\r\n\x1A\n" + chunk("IHDR", header);
  if (more) file += chunk("tEXt", std::string("a\0b", 3)) + chunk("eXIf", input.substr(8, 64));
  const unsigned choice = at(7);
  if ((choice & 1U) != 0) file += chunk("PLTE", input.substr(8, palette));
  if ((choice & 2U) != 0) file += chunk("tRNS", input.substr(8, std::min<std::size_t>(palette, 6)));
  if ((choice & 4U) != 0) file += chunk("acTL", input.substr(8, 8));
  const std::string rows = input.substr(8 + palette);
  // Now and then the bytes are the stream itself.
  const std::string stream = (choice & 8U) != 0 ? rows : packed(rows);
  const std::size_t cut = stream.size() / ((choice >> 4U) + 1);
  file += chunk("IDAT", stream.substr(0, cut)) + chunk("IDAT", stream.substr(cut));
  return file + chunk("IEND", "") + input.substr(8 + palette, behind);
}

void decodeBothWays(const std::string& file) {
  const auto look = decodePng(bytesOf(file), "fuzz.png", kMaxPixels);
  const auto judged = decodeFinePng(bytesOf(file), "fuzz.png", kMaxPixels);
  if (!judged.ok()) return;
  require(look.ok() && *look == judged->picture);
  require(judged->picture.rgba.size() == std::size_t{4} *
                                             static_cast<std::size_t>(judged->picture.width) *
                                             static_cast<std::size_t>(judged->picture.height));
  require(judged->orientation >= 1 && judged->orientation <= 8);
  require(textOf(bytesOf(file).last(8)).starts_with("IEND"));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 9) return 0;
  const std::string input(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0) {
    decodeBothWays(input);
    return 0;
  }
  const std::string file = madeOf(input, false);
  decodeBothWays(file);
  decodeBothWays(madeOf(input, true));
  const auto width = static_cast<std::uint32_t>(data[1]), height = std::uint32_t{data[2]};
  for (const int components : {3, 4}) {
    // Only what the header says is asked of it.
    if (1U << data[3] % 5 != 8 || data[4] % 7 != (components == 3 ? 2 : 6) || data[5] % 2 != 0) {
      continue;
    }
    std::vector<std::uint8_t> rgba(std::size_t{width} * height * 4);
    if (width == 0 || height == 0 ||
        !decodePlainPng(bytesOf(file), width, height, components, rgba)) {
      continue;
    }
    const auto judged = decodeFinePng(bytesOf(madeOf(input, true)), "slow.png", kMaxPixels);
    require(judged.ok() && judged->picture.rgba == rgba);
  }
  return 0;
}
