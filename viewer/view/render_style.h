#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

enum class Shading {
  standard,  ///< sky and ground, the key light, a fill, highlights
  plain,     ///< one light and an even rest: the least that shows a shape
};

enum class EdgeStyle {
  none,
  over,  ///< on the shaded surfaces
  only,  ///< in place of them: a line drawing, hidden lines hidden
};

enum class LabelStyle {
  beside,  ///< up and right of their points; they may cover each other
  apart,   ///< moved so that none covers another; what finds no place is a dot
};

enum class GhostStyle {
  plain,  ///< a translucent colour, lit as everything is
  clear,  ///< one tone with bright rims, behind the actual device wherever both are in one place
};

/// A link's way over the last `window`: a PATH naming a device (its base) or a link.
struct TrailStyle {
  std::string path;
  Nanoseconds window = std::chrono::seconds(5);
  bool operator==(const TrailStyle&) const = default;
};

struct TransparentStyle {
  std::string path;
  double opacity = 0.3;  ///< 0 to 1, times the surfaces' own
  bool operator==(const TransparentStyle&) const = default;
};

/// Every optional look of a frame; the default is the frame without any. A plain value, part of
/// what a picture is a function of. PATHs are those of view_path.h; one that names nothing there
/// does nothing. docs/rendering.md, section "Looks", says what each draws, and what it costs.
struct RenderStyle {
  Shading shading = Shading::standard;
  bool shadows = false;  ///< of the key light
  EdgeStyle edges = EdgeStyle::none;
  LabelStyle labels = LabelStyle::beside;
  GhostStyle ghosts = GhostStyle::plain;
  bool limits = false;     ///< links whose joint is near a limit amber, beyond it red
  bool scale_bar = false;  ///< true at the camera's target
  /// What the cell has its layers drawn like (LayerLook), below what is said here.
  bool layer_looks = true;
  std::vector<std::string> outlined;
  std::vector<std::string> wireframe;
  std::vector<TransparentStyle> transparent;
  std::vector<std::string> collision;       ///< collision geometry in place of visuals
  std::vector<std::string> collision_over;  ///< both, the collision geometry translucent
  std::vector<TrailStyle> trails;

  bool operator==(const RenderStyle&) const = default;
};

/// One word of the vocabulary that programs, suites and reports share.
struct StyleKey {
  std::string_view key;     ///< "edges"
  std::string_view values;  ///< "off|on|only", or "PATH@SECONDS"
  std::string_view means;   ///< for a help text
  bool repeats = false;     ///< each PATH is a setStyle() of its own
};

/// All keys, in the order in which styleWords() says them.
std::span<const StyleKey> styleKeys();

/// Sets or, where the key repeats, adds one value. `-` and `_` in a key are the same; `on` and
/// `true`, `off` and `false` too. bad_argument for an unknown key, a value that it does not take,
/// and shadows with the plain shading, which has none; the style is then unchanged.
Status setStyle(RenderStyle& style, std::string_view key, std::string_view value);

/// The same of one word, "KEY=VALUE", or "KEY" alone for "KEY=on".
Status setStyle(RenderStyle& style, std::string_view word);

/// What differs from the default, as setStyle() takes it: equal styles give equal words.
std::vector<std::pair<std::string, std::string>> styleWords(const RenderStyle& style);

}  // namespace rocinante
