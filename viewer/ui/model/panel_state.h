#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "viewer/ui/model/open_state.h"
#include "viewer/ui/model/palette_state.h"
#include "viewer/ui/model/panel_places.h"

namespace rocinante {

/// What a terminal was told about the files that are shown or were refused.
struct PictureNote {
  std::string text;
  bool is_error = false;
};

/// What the panels themselves remember between two frames: which are there and where, what is being
/// typed, what they list. Nothing of it is in the scene's picture. Not thread-safe.
struct PanelState {
  bool shown = true;
  bool help_shown = false;
  bool is_light = false;  ///< light panels instead of dark ones
  PanelPlaces places;
  OpenState open;
  PaletteState palette;
  bool asks_mark = false;                ///< the text of a mark is being typed
  std::array<char, 256> mark_text{};     ///< being typed; NUL-terminated
  bool asks_time = false;                ///< an exact time is being typed
  std::array<char, 64> time_text{};      ///< that; NUL-terminated
  std::array<char, 64> device_filter{};  ///< part of the listed names; NUL-terminated
  std::array<char, 64> source_filter{};  ///< the same for sources
  std::array<char, 64> event_filter{};   ///< the same for events
  std::set<std::string> open_devices;    ///< whose links are listed
  std::vector<std::string> lines;        ///< that the last frame had over the picture
  std::vector<PictureNote> notes;        ///< over the picture until they are dismissed
  std::string complaint;                 ///< one sentence to show; empty: none
  std::vector<std::string> doubts;       ///< doubts about written files, printed at the end
};

}  // namespace rocinante
