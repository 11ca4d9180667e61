#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "viewer/view/measure_style.h"
#include "viewer/view/units.h"

namespace rocinante {

enum class Shading {
  standard,  ///< sky and ground, the key light, a fill, highlights
  plain,     ///< one light and even ambient light
};

enum class EdgeStyle {
  none,
  over,  ///< on the shaded surfaces
  only,  ///< without them: a line drawing, hidden lines hidden
};

enum class LabelStyle {
  beside,  ///< up and right of their points; they may cover each other
  apart,   ///< moved apart; labels without room become dots
};

enum class GhostStyle {
  plain,  ///< a translucent colour, lit normally
  clear,  ///< one tone with bright rims, behind the actual device
};

/// A link's path over the last `window`: a PATH of a device (its base) or a link.
struct TrailStyle {
  std::string path;
  Nanoseconds window = std::chrono::seconds(5);
  bool operator==(const TrailStyle&) const = default;
};

struct TransparentStyle {
  std::string path;
  double opacity = 0.3;  ///< 0 to 1, multiplies the surfaces' own
  bool operator==(const TransparentStyle&) const = default;
};

/// All optional looks of a frame; the default has none. A plain value. PATHs as in view_path.h; an
/// unknown one has no effect. docs/rendering.md, section "Looks", describes each look and its cost.
struct RenderStyle {
  Shading shading = Shading::standard;
  bool shadows = false;  ///< of the key light
  bool contact = false;  ///< darker where surfaces are near each other
  EdgeStyle edges = EdgeStyle::none;
  LabelStyle labels = LabelStyle::beside;
  GhostStyle ghosts = GhostStyle::plain;
  bool limits = false;  ///< links whose joint is near a limit amber, beyond it red
  bool clearance =
      false;  ///< lines between the nearest points of links whose distance `check` judges
  bool scale_bar = false;    ///< true at the camera's target
  bool camera_cone = false;  ///< what the picture shows, drawn in insets without perspective
  /// Use the looks of the cell's layers (LayerLook), which this style overrides.
  bool layer_looks = true;
  std::vector<std::string> outlined;
  std::vector<std::string> wireframe;
  std::vector<TransparentStyle> transparent;
  std::vector<std::string> collision;       ///< collision geometry instead of visuals
  std::vector<std::string> collision_over;  ///< both, the collision geometry translucent
  std::vector<TrailStyle> trails;
  std::vector<std::string> frames;               ///< links whose axes are drawn
  std::vector<MeasureStyle> measures;            ///< distances drawn with their lengths
  LengthUnit lengths = LengthUnit::millimetres;  ///< of `measures`

  bool operator==(const RenderStyle&) const = default;
};

/// One style key, shared by programs, suites and reports.
struct StyleKey {
  std::string_view key;     ///< "edges"
  std::string_view values;  ///< "off|on|only", or "PATH@SECONDS"
  std::string_view means;   ///< for a help text
  bool repeats = false;     ///< one setStyle() per PATH
};

/// All keys in the order of styleWords().
std::span<const StyleKey> styleKeys();

/// Sets or, where the key repeats, adds one value. `-` and `_` in a key are the same; `on` and
/// `true`, `off` and `false` too. bad_argument for an unknown key, an invalid value, and shadows or
/// contact with plain shading; the style is then unchanged.
Status setStyle(RenderStyle& style, std::string_view key, std::string_view value);

/// The same for one word, "KEY=VALUE", or "KEY" for "KEY=on".
Status setStyle(RenderStyle& style, std::string_view word);

/// Differences from the default, for setStyle(); equal styles give equal words.
std::vector<std::pair<std::string, std::string>> styleWords(const RenderStyle& style);

}  // namespace rocinante
