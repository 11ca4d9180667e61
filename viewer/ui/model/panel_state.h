#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "viewer/shown/short_names.h"
#include "viewer/ui/model/line_start.h"
#include "viewer/ui/model/notice_stack.h"
#include "viewer/ui/model/open_state.h"
#include "viewer/ui/model/panel_places.h"
#include "viewer/ui/model/pose_fields.h"
#include "viewer/ui/model/selection.h"
#include "viewer/view/backdrop_frame.h"

namespace rocinante {

/// The moment of the time line at which the mouse is, and a small picture of it. Plain values.
struct MomentHover {
  std::optional<LogTime> wanted;  ///< of this frame; empty: the mouse is elsewhere
  std::optional<LogTime> drawn;   ///< the moment that the picture shows; empty: there is none
  std::uintptr_t texture = 0;     ///< of GL, top row first
  int width = 0, height = 0;      ///< of the picture, in pixels
};

/// How the pictures of a real camera are shown, and the present one.
struct BackdropChoice {
  std::string camera;  ///< of the cell: its views have them
  bool shown = true;
  double opacity = kBackdropOpacity;                 ///< over the model, 0 to 1
  Nanoseconds offset{0};                             ///< session time of their time zero
  std::shared_ptr<const BackdropPicture> picture{};  ///< null: there is none at this moment
};

/// The command palette: what is typed, and the chosen line of what matches it.
struct PaletteState {
  bool shown = false;
  bool just_opened = false;      ///< takes the keyboard in the coming frame
  std::array<char, 256> text{};  ///< NUL-terminated
  std::size_t chosen = 0;
  LineStart start;

  /// With what is typed already, at most 255 bytes.
  void open(std::string_view begun = {}) {
    *this = PaletteState();
    shown = just_opened = true;
    std::ranges::copy(begun.substr(0, text.size() - 1), text.begin());
    start.begin();
  }
};

/// A short text that is asked for: its field gets the keyboard a few frames later.
struct AskedText {
  bool shown = false;
  bool begun = false;            ///< it has the keyboard
  std::array<char, 256> text{};  ///< NUL-terminated

  void ask() {
    *this = AskedText();
    shown = true;
  }
  bool awaitsKeyboard() const { return shown && !begun; }
};

/// What a terminal was told about the files that are shown or were refused.
struct PictureNote {
  /// What it is about: what is shown, something that could not be, or a layout.
  enum class Of { shown, failure, layout };
  std::string text;
  bool is_error = false;
  Of of = Of::shown;
};

/// What the panels themselves remember between two frames: which are there and where, what is being
/// typed, what they list. Nothing of it is in the scene's picture. Not thread-safe.
struct PanelState {
  bool shown = true;
  bool help_shown = false;
  bool is_light = false;    ///< light panels instead of dark ones
  bool wall_clock = false;  ///< also the time of day, where the session has one
  std::string wanted_tab;   ///< of the left panel, to be opened by the next frame; empty: none
  bool cube_shown = true;   ///< the cube whose sides turn the view
  PanelPlaces places;
  OpenState open;
  PaletteState palette;
  AskedText mark;                        ///< of a mark
  AskedText time;                        ///< an exact time
  std::array<char, 64> device_filter{};  ///< part of the listed names; NUL-terminated
  std::array<char, 64> source_filter{};  ///< the same for sources
  std::array<char, 64> event_filter{};   ///< the same for events
  PoseFields pose_fields;                ///< of the selected device
  std::set<std::string> open_devices;    ///< whose links are listed
  Selection listed_selection;            ///< that the list of devices was scrolled to
  ShortNameLists short_names;            ///< of the lists, as they are shown
  std::vector<std::string> lines;        ///< that the last frame had over the picture
  NoticeStack notices;                   ///< which of them are shown
  std::vector<PictureNote> notes;        ///< over the picture until they are dismissed
  std::string complaint;                 ///< one sentence to show; empty: none
  std::vector<std::string> doubts;       ///< doubts about written files, printed at the end

  /// Away with what is said of that.
  void dropNotes(PictureNote::Of of) {
    std::erase_if(notes, [of](const PictureNote& note) { return note.of == of; });
  }
  /// The left panel with that tab: "Scene", "Look", "Sources", "Events", "Check" or "Frame".
  void openTab(std::string name) {
    shown = true;
    const auto scene = places.places.find("Scene");
    if (scene != places.places.end()) scene->second.collapsed = false;
    places.openEdge("left");
    wanted_tab = std::move(name);
  }
};

}  // namespace rocinante
