#include "core/packet/text_name.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/base/hex_digit.h"
#include "core/base/plain_text.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

constexpr std::array<bool, 256> kNameBytes = [] {
  std::array<bool, 256> table{};
  for (std::size_t byte = 0; byte < table.size(); ++byte) {
    table[byte] = (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z') ||
                  (byte >= '0' && byte <= '9') || byte == '_' || byte == '.' || byte == '-' ||
                  byte == ':';
  }
  return table;
}();

std::uint32_t byteOf(char character) { return static_cast<unsigned char>(character); }

/// isNameByte() where the compiler can inline it: it cannot inline an exported function.
bool isPlain(char byte) { return kNameBytes[byteOf(byte)]; }

}  // namespace

bool isNameByte(char byte) { return isPlain(byte); }

std::optional<std::string_view> decodeName(std::string_view raw, TextArena& arena) {
  std::size_t plain = 0;
  while (plain < raw.size() && isPlain(raw[plain])) ++plain;
  if (plain == raw.size()) {
    if (raw.empty() || raw.size() > limits::kNameBytes) return std::nullopt;
    return raw;
  }
  if (raw.size() > 3 * limits::kNameBytes) return std::nullopt;
  const std::size_t mark = arena.mark();
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (isNameByte(raw[i])) {
      arena.append(raw[i]);
      continue;
    }
    const std::optional<char> byte = percentByte(raw, i);
    if (!byte || isControl(*byte)) return std::nullopt;
    arena.append(*byte);
    i += 2;
  }
  const std::string_view name = arena.since(mark);
  if (name.size() > limits::kNameBytes || !isUtf8(bytesOf(name))) return std::nullopt;
  return name;
}

std::optional<std::string_view> decodeString(const char*& at, const char* end, TextArena& arena) {
  if (at == end || *at != '"') return std::nullopt;
  const std::size_t mark = arena.mark();
  for (const char* next = at + 1; next != end; ++next) {
    char byte = *next;
    if (byte == '"') {
      const std::string_view string = arena.since(mark);
      if (string.size() > limits::kStringBytes || !isUtf8(bytesOf(string))) return std::nullopt;
      at = next + 1;
      return string;
    }
    if (isControl(byte) && byte != '\t') return std::nullopt;
    if (byte == '\\') {
      if (++next == end) return std::nullopt;
      if (*next == 'n') {
        byte = '\n';
      } else if (*next == '"' || *next == '\\') {
        byte = *next;
      } else {
        return std::nullopt;
      }
    }
    arena.append(byte);
  }
  return std::nullopt;
}

void appendName(std::string& text, std::string_view name) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  for (;;) {
    std::size_t plain = 0;
    while (plain < name.size() && isPlain(name[plain])) ++plain;
    text.append(name.substr(0, plain));
    if (plain == name.size()) return;
    const std::uint32_t byte = byteOf(name[plain]);
    text += '%';
    text += kHex[byte >> 4U];
    text += kHex[byte & 15U];
    name.remove_prefix(plain + 1);
  }
}

void appendString(std::string& text, std::string_view string) {
  text += '"';
  while (!string.empty()) {
    const std::size_t length = utf8Length(string);
    const char byte = string.front();
    if (byte == '"' || byte == '\\') {
      text += '\\';
      text += byte;
    } else if (byte == '\n') {
      text += "\\n";
    } else if (length == 0 || (isControl(byte) && byte != '\t')) {
      text += "\xEF\xBF\xBD";
    } else {
      text += string.substr(0, length);
    }
    string.remove_prefix(length == 0 ? 1 : length);
  }
  text += '"';
}

bool isName(std::string_view name) {
  return !name.empty() && name.size() <= limits::kNameBytes && isUtf8(bytesOf(name)) &&
         std::ranges::none_of(name, isControl);
}

bool isUnit(std::string_view unit) {
  return !unit.empty() && unit.size() <= limits::kUnitBytes &&
         std::ranges::all_of(unit,
                             [](char byte) { return byte > ' ' && byte <= '~' && byte != '"'; });
}

std::string unitHint(std::string_view unit) {
  using Spelling = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Spelling, 11> kSpellings = {{{"\u00B0", "deg"},
                                                    {"\u00B5", "u"},
                                                    {"\u03BC", "u"},
                                                    {"\u03A9", "Ohm"},
                                                    {"\u2126", "Ohm"},
                                                    {"\u00B2", "2"},
                                                    {"\u00B3", "3"},
                                                    {"\u00B7", "."},
                                                    {"\u22C5", "."},
                                                    {"\"", ""},
                                                    {" ", "."}}};
  std::string meant;
  while (!unit.empty()) {
    const auto* const spelling = std::ranges::find_if(
        kSpellings, [&](const Spelling& each) { return unit.starts_with(each.first); });
    const bool is_known = spelling != kSpellings.end();
    meant += is_known ? spelling->second : unit.substr(0, 1);
    unit.remove_prefix(is_known ? spelling->first.size() : 1);
  }
  return isUnit(meant) ? "did you mean `" + meant + "`?" : "such as degC, N.m or m/s2";
}

std::string encodeName(std::string_view name) {
  std::string text;
  appendName(text, name);
  return text;
}

}  // namespace rocinante
