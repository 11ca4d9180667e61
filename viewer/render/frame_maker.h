#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/session/timeline.h"
#include "viewer/gl/render_context.h"
#include "viewer/gl/renderer_key.h"
#include "viewer/picture/picture.h"
#include "viewer/render/identity_frame.h"
#include "viewer/view/backdrop_frame.h"
#include "viewer/view/beside_session.h"
#include "viewer/view/camera.h"
#include "viewer/view/hand_joints.h"
#include "viewer/view/inset_layout.h"
#include "viewer/view/picture_terms.h"

namespace rocinante {

struct PickedLink;

/// Describes a frame to draw.
struct FrameRequest : PictureTerms {
  LogTime time{};
  /// A camera of the cell, a `view` of the session, or "map", "fit" or "fit:DEVICE"
  /// (docs/cell-format.md, "Built in"). Empty: the cell's first, or "fit".
  std::string camera;
  /// A rung of kDetailRungs; 0 draws everything. In a browser makeNextDetail() comes first.
  int detail = 0;
  /// Joint values over those of the cell at rest; bad_argument with a session, which says them.
  HandJoints joints;
};

/// frame = render(cell, log, t, camera, options, size): a pure function behind one object that
/// holds the context, the uploaded geometry and the session. One thread.
class FrameMaker {
 public:
  /// Makes its context by makeOffscreenContext(). `session` empty: the cell at rest, and the time
  /// of requests is ignored. Reproducible profile: refused when the renderer is not llvmpipe,
  /// pinned.
  static Result<FrameMaker> open(Cell cell, std::optional<Timeline> session, Profile profile);

  /// The same with a context of the caller's own, current in this thread.
  static Result<FrameMaker> open(Cell cell, std::optional<Timeline> session, Profile profile,
                                 std::unique_ptr<RenderContext> context);

  ~FrameMaker();
  FrameMaker(FrameMaker&&) noexcept;
  FrameMaker& operator=(FrameMaker&&) noexcept;

  /// Without a session: shows this state, which is borrowed, in place of the cell at rest.
  void showState(const SessionState* state);

  /// Shows this one in place of the session that it was opened with: more of the same.
  void showSession(Timeline session);

  /// Shows another session of the same cell beside the first, as clear ghosts; the cell's own
  /// ghosts are clear then, too. Only with a session.
  void showBeside(Timeline beside, EventAlignment alignment);

  /// Puts pictures behind every view of this calibrated camera of the cell, and over it by
  /// `opacity`. Without a session, that of LogTime{}.
  void showBackdrop(std::string camera, double opacity, BackdropAt pictures);

  /// bad_argument for a time outside the log or an unsupported size or sample count; not_found for
  /// an unknown camera or PATH (KnownNames). When a damaged log may make the picture stale: an
  /// error of kind `damaged`, or, with `damage`, the picture with the damage added there. This
  /// includes every state that the picture depends on, also of trails and fitted cameras, and does
  /// not depend on the order of requests. The same holds for identity(), depth() and camera().
  Result<Picture> frame(const FrameRequest& request, StateDamage* damage = nullptr);
  /// The same frame in the context's default framebuffer (a window's), from its bottom left, in
  /// place of a picture in memory. The request's panel is ignored.
  Status show(const FrameRequest& request, StateDamage* damage = nullptr);
  /// The device and link of each pixel, insets included. Ignores the request's samples and panel;
  /// only the geometry of its detail counts.
  Result<IdentityFrame> identity(const FrameRequest& request, StateDamage* damage = nullptr);
  /// The depth of each pixel of the main view.
  Result<DepthFrame> depth(const FrameRequest& request, StateDamage* damage = nullptr);
  /// The link at a pixel from the top left, as Renderer::pick() finds it; in a browser without the
  /// point.
  Result<std::optional<PickedLink>> pick(const FrameRequest& request, double x, double y,
                                         StateDamage* damage = nullptr);
  /// The main view's camera.
  Result<CameraView> camera(const FrameRequest& request);
  /// The main view, then the drawn insets in order.
  Result<std::vector<PicturedView>> views(const FrameRequest& request);

  /// Whether the main view or an inset uses "fit" or "map".
  bool asksFit(const FrameRequest& request) const;
  /// Fits "fit" and "map", also of insets, to the session of `other`, so that pictures of two
  /// sessions have the same camera. `other` must outlive this.
  void fitLike(FrameMaker& other);

  /// As Renderer::makeNextDetail(), for a browser.
  bool makeNextDetail();
  /// As Renderer::finishPictures(): nothing is left to do but in a browser.
  void finishPictures();
  /// As Renderer::readNextPicture().
  bool readNextPicture();

  const RendererKey& key() const;
  /// XXH3 of decoded textures, glyphs and vertex buffers: distinguishes different inputs from a
  /// different renderer.
  const std::string& inputsHash() const;
  /// Textures that could not be read. The cell's own faults are in cell().faults.
  const std::vector<std::string>& warnings() const;
  const Cell& cell() const;
  Timeline* session();  ///< null without a log

 private:
  struct Impl;
  explicit FrameMaker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
