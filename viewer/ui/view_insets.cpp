#include "viewer/ui/view_insets.h"

#include <algorithm>

#include "viewer/render/camera_choice.h"
#include "viewer/render/inset_layout.h"

namespace rocinante {
namespace {

bool isLeft(InsetCorner corner) {
  return corner == InsetCorner::top_left || corner == InsetCorner::bottom_left;
}

bool isTop(InsetCorner corner) {
  return corner == InsetCorner::top_left || corner == InsetCorner::top_right;
}

const char* nameOfCorner(InsetCorner corner) {
  if (isTop(corner)) return isLeft(corner) ? "top-left" : "top-right";
  return isLeft(corner) ? "bottom-left" : "bottom-right";
}

std::vector<CellInset> shownInsets(const ViewModel& model) {
  std::vector<CellInset> shown;
  for (const InsetChoice& choice : model.insets) {
    if (choice.shown) shown.push_back(choice.inset);
  }
  return shown;
}

PixelRectangle movedOff(PixelRectangle part, InsetCorner corner, int width, int height,
                        const CoveredEdges& covered) {
  // Where they would meet those on the right, the panel lies over them instead.
  const bool meets = 2 * (part.x + part.width) + covered.left > width;
  if (isLeft(corner) && !meets) part.x += covered.left;
  if (!isTop(corner)) part.y -= covered.bottom;
  if (corner == InsetCorner::top_right) part.y += covered.right_top;
  part.x = std::clamp(part.x, 0, std::max(0, width - part.width));
  part.y = std::clamp(part.y, 0, std::max(0, height - part.height));
  return part;
}

}  // namespace

std::vector<FrameInset> frameInsets(const ViewModel& model, FittedCameras& fitted, int width,
                                    int height, double scale, const CoveredEdges& covered) {
  const std::vector<CellInset> insets = shownInsets(model);
  const std::vector<PixelRectangle> parts = placeInsets(insets, width, height, scale);
  std::vector<FrameInset> shown;
  for (std::size_t i = 0; i < insets.size(); ++i) {
    if (parts[i].width == 0 || parts[i].height == 0) continue;
    const CellInset& inset = insets[i];
    Result<CameraView> camera = chooseCamera(inset.camera, model.scene());
    if (!camera.ok() && FittedCameras::knows(inset.camera)) {
      camera = fitted.view(inset.camera, model.choice(), model.hiddenPaths(), model.shownPaths(),
                           parts[i].width, parts[i].height);
    }
    if (!camera.ok()) continue;
    shown.push_back({movedOff(parts[i], inset.corner, width, height, covered), *camera,
                     inset.title.value_or(inset.camera), inset.border_rgba, inset.border_px});
  }
  return shown;
}

std::vector<std::string> insetWords(const ViewModel& model) {
  std::vector<std::string> words;
  for (const CellInset& inset : shownInsets(model)) {
    words.push_back(inset.camera + ":" + nameOfCorner(inset.corner));
  }
  return words;
}

}  // namespace rocinante
