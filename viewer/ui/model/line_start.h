#pragma once

#include <cstdint>
#include <string>

namespace rocinante {

/// What is typed for a line of text before it has the keyboard, which takes it a few frames: slow
/// ones must not lose it.
struct LineStart {
  bool collects = false;  ///< it has not got the keyboard yet
  std::string letters;    ///< that it has not taken yet
  bool enter = false;     ///< Enter came after them
  int to_end = 0;         ///< frames for which the cursor is kept behind the text

  void begin() {
    *this = LineStart();
    collects = true;
    to_end = 2;
  }
  /// A character of the Unicode planes that keyboards have; others and control characters are left
  /// out.
  void type(std::uint32_t letter) {
    constexpr std::size_t kMost = 1024;
    if (!collects || enter || letters.size() > kMost) return;
    if (letter < ' ' || (letter >= 0x7F && letter < 0xA0) || letter > 0xFFFF) return;
    const auto put = [this](std::uint32_t byte) { letters += static_cast<char>(byte); };
    if (letter < 0x80) return put(letter);
    if (letter < 0x800) {
      put(0xC0U | letter >> 6U);
    } else {
      put(0xE0U | letter >> 12U);
      put(0x80U | (letter >> 6U & 0x3FU));
    }
    put(0x80U | (letter & 0x3FU));
  }
};

}  // namespace rocinante
