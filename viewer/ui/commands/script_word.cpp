#include "viewer/ui/commands/script_word.h"

#include <fmt/format.h>

#include <charconv>

#include "core/base/plain_text.h"

namespace rocinante {

std::string scriptWord(std::string_view text) {
  std::string word;
  for (const char one : text) {
    const auto byte = static_cast<unsigned char>(one);
    if (byte <= ' ' || byte == 0x7F || one == '#' || one == '%') {
      word += fmt::format("%{:02X}", byte);
    } else {
      word += one;
    }
  }
  return word;
}

Result<std::string> textOfWord(std::string_view word) {
  const auto fault = [&](std::string_view why) {
    return Error{ErrorKind::bad_argument, fmt::format("`{}` {}", word, why), {}};
  };
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] != '%') {
      text += word[i];
      continue;
    }
    unsigned byte = 0;
    const std::string_view digits = word.substr(i + 1, 2);
    const auto [stop, wrong] =
        std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (digits.size() != 2 || wrong != std::errc{} || stop != digits.data() + 2) {
      return fault("has a % without two hexadecimal digits");
    }
    if (byte == 0) return fault("has a NUL");
    text += static_cast<char>(byte);
    i += 2;
  }
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = utf8Length(rest);
    if (length == 0) return fault("is not UTF-8");
    rest.remove_prefix(length);
  }
  return text;
}

}  // namespace rocinante
