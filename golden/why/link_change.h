#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/picture/picture.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// The change of a link between the golden and the frame.
enum class ChangeKind : std::uint8_t {
  moved,     ///< its pixels are found elsewhere
  appeared,  ///< the golden shows nothing of it
  vanished,  ///< the frame shows nothing of it
  shape,     ///< its outline changed, wherever it is placed
  color,     ///< same outline, different colours
  drawing,   ///< a label, line or points of the session, or the text in it
  camera     ///< of a whole inset: its camera or its place changed
};
std::string_view nameOf(ChangeKind kind);

/// A link or drawing with the differing pixels attributed to it.
struct LinkChange {
  /// `device` empty: what belongs to no device (sky, ground, grid).
  IdentityName name;
  ChangeKind kind = ChangeKind::color;
  std::int64_t pixels = 0;                        ///< attributed differing pixels
  std::optional<std::array<double, 2>> moved_px;  ///< from golden to frame: right, down
  std::array<double, 3>
      color_shift{};     ///< frame minus golden, mean R G B where it differs in place
  std::string inset{};   ///< the camera of the inset that shows it; empty: the main view
  std::string camera{};  ///< of kind `camera`: "its camera moved by 20 mm"
};

/// Differing pixels by link (docs/golden-suites.md, "Why").
struct Blame {
  static constexpr std::size_t kMaxRows = 254;

  std::int64_t differing = 0;
  std::vector<LinkChange> changes;  ///< the main view's, most pixels first, then inset by inset
  /// Of the picture's size. Each byte is 1 + an index into `changes`, 255 for one beyond kMaxRows,
  /// 0 for none: red, the owner of a differing pixel; green, the surface that the frame shows;
  /// blue, the surface that the golden showed.
  Picture mask;
};

/// "puma/link4", "drawing planner/goal", "background".
std::string nameText(const IdentityName& name);
/// The same of a change: "inset wrist" of a camera, "inset wrist, puma/link4" of what it shows.
std::string nameText(const LinkChange& change);
/// "moved by (3.1, -0.4) px", "colour changed by (+12, +0, -3)".
std::string whatText(const LinkChange& change);
/// "puma/link4: 6,900 of 7,213 differing pixels, moved by (3.1, -0.4) px".
std::string changeText(const LinkChange& change, std::int64_t differing);

}  // namespace rocinante
