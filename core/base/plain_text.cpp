#include "core/base/plain_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

constexpr std::size_t kLineBytes = 160;

unsigned byteAt(ByteView bytes, std::size_t at) { return std::to_integer<unsigned>(bytes[at]); }

char32_t characterAt(ByteView bytes, std::size_t at, std::size_t length) {
  if (length == 1) return byteAt(bytes, at);
  char32_t character = byteAt(bytes, at) & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    character = (character << 6U) | (byteAt(bytes, at + i) & 0x3FU);
  }
  return character;
}

/// Characters that a terminal executes or does not show: controls (C0, DEL, C1), and those that
/// change the direction of text around them (bidi), end lines, or take no room, so that two names
/// look alike. Joiners (U+200C, U+200D) belong to some scripts and stay.
bool isUnseen(char32_t c) {
  struct Range {
    char32_t first, last;
  };
  static constexpr Range kUnseen[] = {{0x00, 0x1F},     {0x7F, 0x9F},      {0x061C, 0x061C},
                                      {0x180E, 0x180E}, {0x200B, 0x200B},  {0x200E, 0x200F},
                                      {0x2028, 0x202E}, {0x2060, 0x206F},  {0xFEFF, 0xFEFF},
                                      {0xFFF9, 0xFFFB}, {0xE0000, 0xE0FFF}};
  return std::ranges::any_of(
      kUnseen, [c](const Range& range) { return c >= range.first && c <= range.last; });
}

}  // namespace

std::string shellWord(std::string_view word) {
  constexpr std::string_view kSafe =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=@%+,-";
  if (!word.empty() && word.find_first_not_of(kSafe) == std::string_view::npos) {
    return std::string(word);
  }
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// Unicode 15, table 3-7: no overlong forms, no surrogates, nothing past U+10FFFF.
std::size_t utf8Length(std::string_view text) {
  const auto byteIn = [&](std::size_t at) {
    return std::uint32_t{static_cast<unsigned char>(text[at])};
  };
  if (text.empty()) return 0;
  const std::uint32_t first = byteIn(0);
  if (first < 0x80) return 1;
  std::size_t length = 0;
  std::uint32_t low = 0x80;
  std::uint32_t high = 0xBF;
  if (first >= 0xC2 && first <= 0xDF) {
    length = 2;
  } else if (first >= 0xE0 && first <= 0xEF) {
    length = 3;
    if (first == 0xE0) low = 0xA0;
    if (first == 0xED) high = 0x9F;
  } else if (first >= 0xF0 && first <= 0xF4) {
    length = 4;
    if (first == 0xF0) low = 0x90;
    if (first == 0xF4) high = 0x8F;
  }
  if (length == 0 || text.size() < length) return 0;
  if (byteIn(1) < low || byteIn(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if ((byteIn(i) & 0xC0U) != 0x80) return 0;
  }
  return length;
}

bool isUtf8(ByteView bytes) {
  std::string_view rest = textOf(bytes);
  while (!rest.empty()) {
    const std::size_t length = utf8Length(rest);
    if (length == 0) return false;
    rest.remove_prefix(length);
  }
  return true;
}

std::string plainText(std::string_view text) {
  const ByteView bytes = bytesOf(text);
  std::string out;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = utf8Length(text.substr(at));
    if (length == 0 || isUnseen(characterAt(bytes, at, length))) {
      for (std::size_t i = 0; i < std::max<std::size_t>(length, 1); ++i) {
        out += fmt::format("\\x{:02x}", byteAt(bytes, at + i));
      }
    } else {
      out += text.substr(at, length);
    }
    at += std::max<std::size_t>(length, 1);
  }
  return out;
}

std::string plainLine(ByteView datagram, std::uint32_t number) {
  std::string_view text = textOf(datagram);
  for (std::uint32_t line = 1; line < number; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  std::string_view part = text.substr(0, kLineBytes);
  if (part.size() < text.size()) {
    // Characters are not split: continuation bytes begin with 10.
    while (!part.empty() && (static_cast<unsigned char>(text[part.size()]) & 0xC0U) == 0x80) {
      part.remove_suffix(1);
    }
  }
  std::string shown(part);
  std::ranges::replace(shown, '\t', ' ');
  shown = plainText(shown);
  return part.size() < text.size() ? shown + "..." : shown;
}

std::string xmlText(std::string_view text) {
  std::string escaped;
  // Bytes that are not UTF-8, and control characters, which XML cannot hold at all, become \xNN.
  std::string line;
  const auto flush = [&] {
    for (const char c : plainText(line)) {
      switch (c) {
        case '&':
          escaped += "&amp;";
          break;
        case '<':
          escaped += "&lt;";
          break;
        case '>':
          escaped += "&gt;";
          break;
        case '"':
          escaped += "&quot;";
          break;
        default:
          escaped += c;
      }
    }
    line.clear();
  };
  for (const char c : text) {
    if (c != '\n') {
      line += c;
      continue;
    }
    flush();
    escaped += "&#10;";
  }
  flush();
  return escaped;
}

std::string placeIn(std::string_view text, std::size_t number) {
  const std::string_view before = text.substr(0, number > 0 ? number - 1 : 0);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return ":" + std::to_string(lines + 1) + ":" + std::to_string(before.size() - line_start + 1);
}

}  // namespace rocinante
