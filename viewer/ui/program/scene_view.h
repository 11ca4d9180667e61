#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "viewer/detail/rest_plan.h"
#include "viewer/render/rest_picture.h"
#include "viewer/render/scaled_view.h"
#include "viewer/view/picture_terms.h"

namespace rocinante {

/// How a window's picture is drawn, as the program decides it for each frame.
struct WindowTerms : PictureTerms {
  int rung = 0;  ///< of kDetailRungs
  /// Leave out the looks that are the window's own choice; the picture at rest has them.
  bool drops_looks = false;
  /// At rest it is drawn with everything, whatever the rung. Its first picture is one of a single
  /// sample without looks, which is there soonest.
  bool refines = false;
  bool operator==(const WindowTerms&) const = default;
};

/// Everything that decides a scene's pixels: while it stays equal, nothing has to be drawn.
struct ShownScene {
  std::uint64_t version = 0;  ///< of poses, drawings and meshes
  CameraView camera;
  WindowTerms terms;
  std::vector<FrameInset> insets;  ///< in their places
  std::uint64_t backdrop = 0;      ///< BackdropPicture::number; 0: none
  double backdrop_opacity = 0;
  bool main_has_backdrop = false;
  bool operator==(const ShownScene&) const = default;
};

/// The scene's picture in a window: drawn on a rung of detail whenever it changes, and once more
/// with everything when it rests. Its context must be current whenever it is used or destroyed.
class SceneView {
 public:
  /// Draws `frame` unless `shown` was drawn last; empty when it was.
  Result<std::optional<DrawCounts>> draw(Renderer& renderer, SceneFrame frame,
                                         const ShownScene& shown, SteadyTime now);

  /// Draws the next slice of the picture with everything, if it is due: `frame` as last drawn. True
  /// when the picture has become whole.
  Result<bool> refine(Renderer& renderer, const SceneFrame& frame, SteadyTime now);
  /// When refine() has something to do; empty: never.
  std::optional<SteadyTime> refinesAt() const { return plan_.nextAt(); }
  /// The picture shows everything, although the rung does not.
  bool refined() const { return plan_.whole(); }
  /// What was drawn last is a plain beginning, as everything is until warmedUp() where rungs are
  /// chosen: at once, with one sample and without dear looks.
  bool isPlain() const { return plain_; }
  /// The rung of the next picture is known to hold.
  void warmedUp() { is_warm_ = true; }

  /// The picture to show, one sample per pixel.
  const FrameBuffer& picture() const { return refined() ? rest_.picture() : view_.picture(); }

 private:
  bool isAsGood(const ShownScene& drawn, const ShownScene& wanted) const;

  ScaledView view_;
  RestPicture rest_;
  RestPlan plan_;
  std::optional<ShownScene> shown_;
  bool is_warm_ = false, plain_ = false;
};

}  // namespace rocinante
