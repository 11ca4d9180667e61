#include "core/foreign/table/npy_header.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {

std::string pythonText(std::string_view text) {
  std::string literal = "'";
  for (const char byte : text) {
    // Names hold no control characters.
    if (byte == '\'' || byte == '\\') literal += '\\';
    literal += byte;
  }
  return literal + "'";
}

std::string npyHeader(std::string_view descr, std::uint64_t rows) {
  constexpr std::size_t kMaxDigits = 20;
  constexpr std::size_t kAlignment = 64;
  const std::string count = std::to_string(rows);
  std::string text =
      fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({},), }}", descr, count);
  text.append(kMaxDigits - count.size(), ' ');
  const bool is_ascii = std::all_of(descr.begin(), descr.end(), [](char byte) {
    return static_cast<unsigned char>(byte) < 0x80;
  });
  // The length has two bytes in version 1.0, four in 2.0 (Latin-1) and 3.0 (UTF-8).
  const bool is_short = is_ascii && text.size() + kAlignment < 65536;
  const std::size_t before = is_short ? 10 : 12;
  text.append(kAlignment - 1 - (before + text.size()) % kAlignment, ' ');
  text += '\n';
  std::string header = "\x93NUMPY";
  header += is_short ? '\1' : (is_ascii ? '\2' : '\3');
  header += '\0';
  for (std::size_t i = 0; i < before - 8; ++i) {
    header += static_cast<char>(text.size() >> (8 * i) & 0xFF);
  }
  return header + text;
}

}  // namespace rocinante
