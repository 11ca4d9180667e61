#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/session/timeline.h"
#include "viewer/gl/renderer_key.h"
#include "viewer/picture/picture.h"
#include "viewer/render/identity_frame.h"
#include "viewer/view/camera.h"
#include "viewer/view/pictured_view.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// Of FrameRequest::scale.
inline constexpr double kLeastScale = 0.5, kLargestScale = 4;

/// What to draw besides time and place.
struct FrameRequest {
  LogTime time{};
  /// Of the cell, a `view` of the session, or "map", "fit" or "fit:DEVICE" (docs/cell-format.md,
  /// "Built in").
  /// Empty: the cell's first, or "fit".
  std::string camera;
  int width = 640;
  int height = 480;
  double scale = 1;               ///< of what has its size in pixels: 0.5 to 4
  int samples = 4;                ///< MSAA; llvmpipe has 1 and 4
  int detail = 0;                 ///< a rung of kDetailRungs: how much is drawn; 0 is everything
  std::vector<std::string> hide;  ///< PATHs: outrank packets and the cell (see ViewChoice)
  std::vector<std::string> show;
  RenderStyle style;
  /// Empty: the cell's, but for those whose camera is not there. Given ones must be there. One that
  /// repeats the main camera is left out.
  std::optional<std::vector<CellInset>> insets;
  bool panel = false;  ///< in a corner: time, devices, joint values, rates (overlay_panel.h)
};

/// frame = render(cell, log, t, camera, options, size): a pure function behind one object that
/// holds the context, the uploaded geometry and the session. One thread.
class FrameMaker {
 public:
  /// Makes its context by makeOffscreenContext(). `session` empty: the cell alone, as nothing was
  /// ever said, and the time of a request means nothing.
  /// Reproducible profile: refused when the renderer is not llvmpipe, pinned.
  static Result<FrameMaker> open(Cell cell, std::optional<Timeline> session, Profile profile);

  ~FrameMaker();
  FrameMaker(FrameMaker&&) noexcept;
  FrameMaker& operator=(FrameMaker&&) noexcept;

  /// bad_argument for a time outside the log or a size or samples that cannot be drawn; not_found
  /// for an unknown camera or what PATHs name (KnownNames). Where the log is damaged so that the
  /// picture may be older than its time says: an error of kind `damaged`, or with `damage` the
  /// picture all the same, and what it may lack is added there. That counts every state which the
  /// picture depends on, those of trails and fitted cameras too, and is the same in whatever order
  /// frames are asked for. The same of identity(), depth() and camera().
  Result<Picture> frame(const FrameRequest& request, StateDamage* damage = nullptr);
  /// Whose its pixels are, insets included; the request's samples and panel mean nothing, and of
  /// its detail geometry alone counts.
  Result<IdentityFrame> identity(const FrameRequest& request, StateDamage* damage = nullptr);
  /// How far they are; of the main view alone.
  Result<DepthFrame> depth(const FrameRequest& request, StateDamage* damage = nullptr);
  /// Where it is seen from.
  Result<CameraView> camera(const FrameRequest& request);
  /// The main view, then the insets that are drawn, in their order.
  Result<std::vector<PicturedView>> views(const FrameRequest& request);

  /// Whether "fit" or "map" draws any of it.
  bool asksFit(const FrameRequest& request) const;
  /// From here on "fit" and "map" are fitted to what `other` draws, insets' too: pictures of two
  /// sessions are comparable when one camera draws both. `other` must outlive this.
  void fitLike(FrameMaker& other);

  const RendererKey& key() const;
  /// XXH3 of decoded textures, glyphs and vertex buffers: tells "the inputs differ" from "the
  /// renderer differs".
  const std::string& inputsHash() const;
  /// Textures that could not be read. The cell's own faults are in cell().faults.
  const std::vector<std::string>& warnings() const;
  const Cell& cell() const;
  Timeline* session();  ///< null without one

 private:
  struct Impl;
  explicit FrameMaker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
