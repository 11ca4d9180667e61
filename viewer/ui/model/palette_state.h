#pragma once

#include <array>
#include <cstddef>

#include "viewer/ui/model/line_start.h"

namespace rocinante {

/// The command palette: what is typed, and the chosen line of what matches it.
struct PaletteState {
  bool shown = false;
  bool just_opened = false;      ///< takes the keyboard in the coming frame
  std::array<char, 256> text{};  ///< NUL-terminated
  std::size_t chosen = 0;
  LineStart start;

  void open() {
    *this = PaletteState();
    shown = just_opened = true;
    start.begin();
  }
};

}  // namespace rocinante
