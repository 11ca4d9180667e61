#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rocinante {

/// Whether `pattern` matches `text`. One language for names, topics, events and paths alike:
/// - a pattern equal to the text matches it, whatever characters it holds;
/// - `*` is any run of bytes (`/` among them), `?` any one byte;
/// - `[abc]`, `[a-z]` is one byte of the set, `[!a-z]` or `[^a-z]` one outside it; `]` is a member
///   when it comes first, and a `[` without its `]` is itself;
/// - `\x` is the byte x itself; a `\` at the end matches nothing.
/// Bytes are compared, not characters. Takes time in proportion to the product of both lengths at
/// worst; allocates nothing. Any thread.
bool patternMatches(std::string_view pattern, std::string_view text);

/// False for no patterns.
bool anyPatternMatches(std::span<const std::string> patterns, std::string_view text);

}  // namespace rocinante
