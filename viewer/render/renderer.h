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
#include "viewer/view/backdrop_frame.h"
#include "viewer/view/camera.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/movable_devices.h"
#include "viewer/view/render_style.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// A rectangle over the main view with its own camera.
struct FrameInset {
  PixelRectangle part;
  CameraView camera;
  std::string title;  ///< empty: none
  std::uint32_t border_rgba = 0x14181CFF;
  int border_px = 1;  ///< drawn inside of `part`
  bool has_backdrop = false;
  bool operator==(const FrameInset&) const = default;
};

/// The content of one frame. Borrowed during the call.
struct SceneFrame {
  const PosedScene* scene = nullptr;
  CameraView camera;
  const ViewChoice* choice = nullptr;
  const RenderStyle* style = nullptr;    ///< null: the default, without looks
  const FrameExtras* extras = nullptr;   ///< data for limits and trails of `style`; may be null
  std::span<const FrameInset> insets{};  ///< later ones over earlier ones
  DetailLevel detail{};                  ///< the default draws everything
  /// Scale of text, lines, points, gnomon, scale bar and inset frames: 0.5 to 4, for pictures of
  /// higher resolution.
  double scale = 1;
  /// Draw labels, gnomon, scale bar and the frames of insets with the scene; else by drawOnTop().
  bool on_top = true;
  /// Draw these pixels alone, the same as with the others, and leave the others as they are: a
  /// frame may be drawn in slices.
  std::optional<PixelRectangle> only{};
  /// Behind the views that say so, of calibrated cameras, and over them by `backdrop_opacity`;
  /// null: none.
  const BackdropPicture* backdrop = nullptr;
  double backdrop_opacity = kBackdropOpacity;
  bool main_has_backdrop = false;
  /// A further slice of the frame that was drawn last (Renderer::framesDrawn): its shadows and
  /// contact are known.
  bool goes_on = false;
};

/// The link shown by a pixel of a frame.
struct PickedLink {
  IdentityName name;  ///< device and link
  Vec3 point{};       ///< on its surface, in world space
};

struct DrawCounts {
  std::uint64_t triangles = 0;
  std::uint64_t draws = 0;
  StageTimes times;
};

/// Draws a cell: app -> cull -> draw, in one context. A window draws each frame so:
///
///   renderer.draw({&scene, camera, &choice}, frame_buffer);  // all samples
///   frame_buffer.resolve();   // now bound: draw the user interface here, one sample per pixel
///   frame_buffer.blitTo(0);   // or read()
///
/// Not thread-safe; its context must be current. Borrows context and cell, which must outlive it.
class Renderer {
 public:
  /// Uploads every mesh and texture of the cell. refused when the context is older than GL 3.3, or
  /// the profile is reproducible and the renderer is not llvmpipe with pinned caps.
  static Result<Renderer> create(RenderContext& context, const Cell& cell, Profile profile);

  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Draws into the samples of `target`; call resolve() next. refused when GL reports an error.
  Result<DrawCounts> draw(const SceneFrame& frame, const FrameBuffer& target);

  /// Draws labels, gnomon, scale bar and inset frames sharply for a frame that was drawn without
  /// them and then stretched to `target`. Draws to the resolved pixels. `refill_inset`, which may
  /// be empty, restores the stretched pixels of an inset over the main view's labels.
  Status drawOnTop(const SceneFrame& frame, const FrameBuffer& target,
                   const std::function<void(std::size_t)>& refill_inset = {});

  /// Starts to make coarser meshes in background threads, for frames whose detail uses them.
  void prepareDetail(const DetailCache& cache, int threads);
  /// Takes over the ready ones, or waits for all; true when there are new ones. Without this call,
  /// detail only affects culling and filtering.
  bool takeReadyDetail(bool wait_for_all = false);
  /// True when everything started by prepareDetail() is finished and taken over.
  bool detailReady() const;

  /// The device and link of each pixel of the frame, insets included. `target` must have one sample
  /// per pixel.
  Result<IdentityFrame> identity(const SceneFrame& frame, const FrameBuffer& target);
  /// The depth of each pixel of the main view.
  Result<DepthFrame> depth(const SceneFrame& frame, const FrameBuffer& target);
  /// The link that the frame shows at pixel (x, y) from the top left: the result of identity()
  /// there, without the session's drawings. Without a link there, the nearest one within two
  /// pixels, so that lines can be hit; else empty. The topmost inset counts.
  Result<std::optional<PickedLink>> pick(const SceneFrame& frame, int width, int height, double x,
                                         double y);

  /// A three-quarter view of all that is visible in `scene`.
  CameraView fittedCamera(const PosedScene& scene, const ViewChoice& choice, int width,
                          int height) const;
  /// Corners of the bounding boxes of everything visible in `scene`, for fitted views. `devices`:
  /// only these; null: all.
  std::vector<Vec3> visiblePoints(const PosedScene& scene, const ViewChoice& choice,
                                  const DeviceNames* devices = nullptr) const;
  /// The bounding box of everything visible in world space; empty when nothing is visible.
  Bounds visibleBounds(const PosedScene& scene, const ViewChoice& choice,
                       const DeviceNames* devices = nullptr) const;

  /// Calls of draw() so far.
  std::uint64_t framesDrawn() const;

  const GlTable& gl() const;
  const RendererKey& key() const;
  /// The glyphs for pictures of that scale.
  const TextAtlas& text(double scale) const;
  /// Makes the coarser versions of one more mesh, the largest first, in this thread and without a
  /// cache: for a browser, which has neither. Meshes of over 100,000 triangles stay as they are.
  /// False when none is left. Not after prepareDetail().
  bool makeNextDetail();
  /// Decodes the surfaces' pictures, which in a browser creating leaves to this: frames drawn
  /// before show none.
  void finishPictures();
  /// The next of them; false when none is left.
  bool readNextPicture();
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
