#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/bytes.h"

namespace rocinante {

/// `word` written so that a POSIX shell takes it for one argument: as it is where that is safe, in
/// single quotes otherwise. Any bytes but NUL.
std::string shellWord(std::string_view word);

constexpr bool isDigit(char byte) { return byte >= '0' && byte <= '9'; }
/// True for ASCII's control characters.
constexpr bool isControl(char byte) {
  return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F;
}

/// The length of the UTF-8 sequence at the start of `text` in bytes, or 0 when it is not valid.
std::size_t utf8Length(std::string_view text);

/// True when the bytes are UTF-8 (RFC 3629: no overlong forms, no surrogates).
bool isUtf8(ByteView bytes);

/// Untrusted text as a terminal may show it: control characters, characters that change the
/// direction of text or take no room, and bytes that are not UTF-8 become \xNN per byte, so that a
/// datagram can neither move the cursor, end a line, nor look like another.
std::string plainText(std::string_view text);

/// Line `number` (from 1) of a datagram for a report: plainText with tabs as spaces, cut when it is
/// very long. Empty when there is no such line.
std::string plainLine(ByteView datagram, std::uint32_t number);

/// Text as XML 1.0 can hold it, in an attribute or between tags: markup escaped, line ends as
/// &#10;, and everything else as plainText, since XML cannot hold control characters at all.
std::string xmlText(std::string_view text);

/// ":LINE:COLUMN" of byte `number` of a text, all from 1: the suffix of a file's name.
std::string placeIn(std::string_view text, std::size_t number);

}  // namespace rocinante
