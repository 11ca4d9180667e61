#include "viewer/ui/model/view_insets.h"

#include <algorithm>

#include "viewer/view/camera_choice.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

const char* nameOfCorner(InsetCorner corner) {
  switch (corner) {
    case InsetCorner::top_left:
      return "top-left";
    case InsetCorner::bottom_left:
      return "bottom-left";
    case InsetCorner::bottom_right:
      return "bottom-right";
    case InsetCorner::top_right:
      break;
  }
  return "top-right";
}

std::vector<CellInset> shownInsets(const ViewModel& model) {
  std::vector<CellInset> shown;
  for (const InsetChoice& choice : model.insets) {
    if (choice.shown) shown.push_back(choice.inset);
  }
  return shown;
}

}  // namespace

std::vector<FrameInset> frameInsets(ViewModel& model, FittedCameras& fitted, int width, int height,
                                    double scale, const CoveredEdges& covered) {
  std::vector<CellInset> insets = shownInsets(model);
  const CameraView main = model.cameraView();
  std::erase_if(insets, [&](const CellInset& inset) {
    return repeatsMainView(inset, model.cameraName(), main, model.scene());
  });
  const std::vector<PixelRectangle> parts = placeInsets(insets, width, height, scale, covered);
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
    shown.push_back({parts[i], *camera, inset.title.value_or(inset.camera), inset.border_rgba,
                     inset.border_px});
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
