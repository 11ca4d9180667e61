#pragma once

#include <array>
#include <cstddef>

namespace rocinante {

/// The command palette: what is typed, and the chosen line of what matches it.
struct PaletteState {
  bool shown = false;
  bool just_opened = false;      ///< takes the keyboard in the coming frame
  std::array<char, 256> text{};  ///< NUL-terminated
  std::size_t chosen = 0;
  /// Letters are collected here until the line that is typed in has the keyboard.
  bool collects = false;
  int to_end = 0;  ///< frames for which the cursor is kept behind the text

  void open() {
    *this = PaletteState();
    shown = just_opened = true;
    collects = true;
    to_end = 2;
  }
  /// Appends a typed letter; what does not fit is dropped.
  void type(char letter) {
    std::size_t end = 0;
    while (end < text.size() && text[end] != 0) ++end;
    if (end + 1 < text.size()) text[end] = letter;
  }
};

}  // namespace rocinante
