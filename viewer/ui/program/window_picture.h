#pragma once

#include <cstdint>
#include <optional>

#include "viewer/render/fitted_cameras.h"
#include "viewer/render/renderer.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/program/scene_view.h"

namespace rocinante {

/// The scene in a window: what of the model it shows, drawn when it changes, refined at rest, and
/// clicked on. Main thread; its context must be current. Borrows the model.
class WindowPicture {
 public:
  WindowPicture(ViewModel& model, Renderer renderer, int samples)
      : model_(model),
        samples_(samples),
        renderer_(std::move(renderer)),
        fitted_(model.cell(), renderer_) {}

  /// Prepares fitted cameras. Before the first state is queried, which is only valid until the next
  /// query.
  Status prepare() { return fitted_.prepare(model_.session(), fit_damage_); }

  Renderer& renderer() { return renderer_; }
  const FittedCameras& fitted() const { return fitted_; }
  const FrameBuffer& pixels() const { return view_.picture(); }
  bool refined() const { return view_.refined(); }
  bool isPlain() const { return view_.isPlain(); }
  void warmedUp() { view_.warmedUp(); }

  /// Poses, drawings or meshes changed.
  void changed() { ++version_; }
  /// Draws the picture unless the same was drawn last; empty when it was. The model's terms and the
  /// samples are set here.
  Result<std::optional<DrawCounts>> draw(WindowTerms terms, SteadyTime now);
  /// Draws the next slice of the picture at rest, if it is due; true when it has become whole.
  Result<bool> refine(SteadyTime now);
  /// A slice is due.
  bool refinesAt(SteadyTime now) const {
    return view_.refinesAt().value_or(SteadyTime::max()) <= now;
  }

  /// Selects what the last picture shows there, aims the camera at it, or picks it for a distance.
  Status click(const PictureClick& click);
  /// Shows others the place of a surface that the last picture has there, or that there is none.
  Status point(const PictureClick& at);
  /// The view of a built-in camera, fitted to a picture of that size.
  Result<CameraView> builtIn(std::string_view name, int width, int height) {
    return fitted_.view(name, model_.choice(), model_.hiddenPaths(), model_.shownPaths(), width,
                        height);
  }
  /// Draws the last frame on that rung beside the shown picture; its cost in ms, which contains all
  /// that the driver had to compile.
  Result<double> tryFrame(int rung, bool drops_looks);
  /// Looks for what a click in the picture's middle would meet, and outlines it on that rung beside
  /// the picture.
  Status tryClick(int rung);

  /// Points for fitted views: everything, or the selection.
  std::vector<Vec3> corners(bool of_selection) const;

 private:
  Result<std::optional<PickedLink>> pick(const PictureClick& at);
  SceneFrame frame(const RenderStyle& style) const;
  Result<double> drawAside(const RenderStyle& style, int rung);
  /// With the session beside, whose ghosts are clear.
  RenderStyle style() const;

  ViewModel& model_;
  int samples_;
  Renderer renderer_;
  FittedCameras fitted_;
  StateDamage fit_damage_;  ///< until reported
  SceneView view_;
  WindowTerms terms_;  ///< of the last frame
  std::uint64_t version_ = 0;
  std::vector<FrameInset> insets_;  ///< of the last frame, in the window's pixels
};

}  // namespace rocinante
