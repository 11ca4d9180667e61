#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// Range of PictureTerms::scale.
inline constexpr double kLeastScale = 0.5, kLargestScale = 4;

/// The terms on which a picture of a scene is made, whoever makes it: `render`, the window, the
/// case of a suite. Its moment and its camera are said beside them. A plain value.
struct PictureTerms {
  int width = 640, height = 480;            ///< pixels
  double scale = 1;                         ///< of everything sized in pixels: 0.5 to 4
  int samples = 4;                          ///< MSAA; llvmpipe has 1 and 4
  std::vector<std::string> hide{}, show{};  ///< PATHs; override packets and cell (ViewChoice)
  RenderStyle style{};
  /// Empty: the cell's insets, except those with an unknown camera. Cameras of given insets must
  /// exist. An inset that repeats the main camera is left out.
  std::optional<std::vector<CellInset>> insets{};
  bool panel = false;  ///< in a corner: time, devices, joint values, rates (overlay_panel.h)
  bool operator==(const PictureTerms&) const = default;
};

/// What a program's options for a style begin with: "--shadows=on" of `render`, "--style
/// shadows=on" of `golden add`.
enum class StyleOptions { each, one };

/// The options that say these terms, for `render`, and for `golden add`. Those of a scale, insets
/// or a panel only where they are not the default.
std::vector<std::string> pictureWords(const PictureTerms& terms,
                                      StyleOptions options = StyleOptions::each);

/// The insets of `--inset`, in these words, or of `--no-insets`. bad_argument as parseInset().
Result<std::optional<std::vector<CellInset>>> parseInsets(const std::vector<std::string>& words,
                                                          bool none);

}  // namespace rocinante
