#pragma once

#include <string>
#include <vector>

#include "viewer/picture/pixel_rectangle.h"
#include "viewer/ui/window/panel_colors.h"

struct ImDrawData;

namespace rocinante {

/// What panels write in one colour on one line, and how it can be read.
struct PanelText {
  std::string panel;     ///< of which window; empty: of none
  std::string text;      ///< its letters that are drawn
  PixelRectangle place;  ///< of these, from the window's top left
  double contrast = 21;  ///< by WCAG 2.1, where it is the least
  float cut_px = 0;      ///< what the edge of its place takes of a letter, at most

  bool isFaint() const { return contrast < ColorPair::kTextContrast; }
  bool isCut() const { return cut_px > 1; }
};

/// The texts that are seen of a frame of the current Dear ImGui context; measured in its triangles,
/// so no renderer has a part in it. Main thread.
///
/// The contrast is that of the letters' colour, with its opacity, to what is behind each pixel of
/// their rectangles, over a black picture and over a white one; images that panels show count as
/// picture. WCAG exempts what is disabled; here that is as readable as all else. What something
/// opaque, or the soft edge of something, lies on is not seen. A list with a scroll bar may cut a
/// row. A text that is cut just between two letters cannot be told from a shorter one.
std::vector<PanelText> panelTexts(const ImDrawData& data);

}  // namespace rocinante
