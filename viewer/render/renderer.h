#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "viewer/detail/detail_builder.h"
#include "viewer/detail/detail_level.h"
#include "viewer/gl/frame_buffer.h"
#include "viewer/gl/render_context.h"
#include "viewer/gl/renderer_key.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/render/identity_frame.h"
#include "viewer/render/stage_times.h"
#include "viewer/view/camera.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/movable_devices.h"
#include "viewer/view/render_style.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// A window over the main view, with a camera of its own.
struct FrameInset {
  PixelRectangle part;
  CameraView camera;
  std::string title;  ///< empty: none
  std::uint32_t border_rgba = 0x14181CFF;
  int border_px = 1;  ///< drawn inside of `part`
};

/// What one frame shows. Borrowed for the length of the call.
struct SceneFrame {
  const PosedScene* scene = nullptr;
  CameraView camera;
  const ViewChoice* choice = nullptr;
  const RenderStyle* style = nullptr;    ///< null: the default, no look at all
  const FrameExtras* extras = nullptr;   ///< what limits and trails of `style` need; null: neither
  std::span<const FrameInset> insets{};  ///< later ones over earlier ones
  DetailLevel detail{};                  ///< the default draws everything
  /// Times the size in pixels of text, lines, points, gnomon, scale bar and inset frames: 0.5 to 4,
  /// for pictures of more pixels on as much paper or screen.
  double scale = 1;
  /// Gnomon and scale bar of the main view stand so much higher: over a window's time bar.
  int raised_px = 0;
  /// Labels, gnomon, scale bar and the frames of insets with the scene; else by drawOnTop().
  bool on_top = true;
};

/// What of a device a pixel of a frame shows.
struct PickedLink {
  IdentityName name;  ///< device and link
  Vec3 point{};       ///< of its surface, in the world
};

struct DrawCounts {
  std::uint64_t triangles = 0;
  std::uint64_t draws = 0;
  StageTimes times;
};

/// Draws a cell: app -> cull -> draw, in one context. A window draws each frame so:
///
///   renderer.draw({&scene, camera, &choice}, frame_buffer);  // all samples
///   frame_buffer.resolve();   // now bound: draw the user interface here, one sample a pixel
///   frame_buffer.blitTo(0);   // or read()
///
/// One thread, with the context current. Borrows context and cell, which must outlive it.
class Renderer {
 public:
  /// Uploads every mesh and texture of the cell. refused when the context is less than GL 3.3, or
  /// the profile is reproducible and the renderer is not llvmpipe with pinned caps.
  static Result<Renderer> create(RenderContext& context, const Cell& cell, Profile profile);

  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Draws into `target` (its samples: resolve() comes next). refused when GL reports an error.
  Result<DrawCounts> draw(const SceneFrame& frame, const FrameBuffer& target);

  /// What lies over the scene, crisp, for a frame that was drawn without it and then stretched to
  /// `target`, whose resolved pixels are drawn to. `refill_inset`, which may be empty, puts the
  /// stretched pixels of an inset back over what of the main view lies there.
  Status drawOnTop(const SceneFrame& frame, const FrameBuffer& target,
                   const std::function<void(std::size_t)>& refill_inset = {});

  /// Begins to make coarser meshes, in threads of their own, for frames whose detail asks for them.
  void prepareDetail(const DetailCache& cache, int threads);
  /// Takes over those that are ready, or all of them, waiting for them; true when there are new
  /// ones. Never called, detail means nothing but leaving out and filtering.
  bool takeReadyDetail(bool wait_for_all = false);
  /// All that prepareDetail() began is done and taken over.
  bool detailReady() const;

  /// Whose each pixel of that frame is, insets included. `target` must have one sample a pixel.
  Result<IdentityFrame> identity(const SceneFrame& frame, const FrameBuffer& target);
  /// How far each is, in the main view.
  Result<DepthFrame> depth(const SceneFrame& frame, const FrameBuffer& target);
  /// The link that such a frame of that size shows at pixel (x, y) from the top left: what
  /// identity() has there, without the session's drawings. Where nothing is, what is nearest within
  /// two pixels, so that lines can be hit; else empty. Of several insets the last one there counts.
  Result<std::optional<PickedLink>> pick(const SceneFrame& frame, int width, int height, double x,
                                         double y);

  /// A three-quarter view of all that is visible in `scene`.
  CameraView fittedCamera(const PosedScene& scene, const ViewChoice& choice, int width,
                          int height) const;
  /// Corners of the boxes around everything visible in `scene`: what a fitted view must show.
  /// `devices`: of these alone; null: of all.
  std::vector<Vec3> visiblePoints(const PosedScene& scene, const ViewChoice& choice,
                                  const DeviceNames* devices = nullptr) const;
  /// The world box around all of that; empty when nothing is visible.
  Bounds visibleBounds(const PosedScene& scene, const ViewChoice& choice,
                       const DeviceNames* devices = nullptr) const;

  const GlTable& gl() const;
  const RendererKey& key() const;
  /// The glyphs of a picture of that scale.
  const TextAtlas& text(double scale) const;
  /// XXH3 of vertex buffers, decoded textures and glyphs.
  const std::string& inputsHash() const;
  /// Textures that could not be read.
  const std::vector<std::string>& warnings() const;

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
