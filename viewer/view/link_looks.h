#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/posed_scene.h"
#include "core/cell/view_path.h"
#include "core/math/vector.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// The geometry of a draw list.
enum class DrawnGeometry { visuals, collisions };

/// How one part is drawn, beyond its materials.
struct PartLook {
  bool wireframe = false;
  bool ghost = false;             ///< in one tone, behind the actual device (GhostStyle::clear)
  float opacity = 1;              ///< multiplies its own
  std::optional<glm::vec4> tone;  ///< replaces its materials and texture
};

/// The looks of a scene's links by a style and, below it, the cell's layers. A plain value; borrows
/// the extras.
class LinkLooks {
 public:
  /// Everything as by the materials.
  LinkLooks() = default;
  /// bad_argument for an invalid PATH. `scene`: for the looks of its cell's layers; may be null.
  static Result<LinkLooks> make(const RenderStyle& style, const FrameExtras* extras,
                                const PosedScene* scene = nullptr);

  /// False when every part is drawn by its materials.
  bool any() const { return any_; }
  bool anyCollision() const {
    return !collision_.empty() || !collision_over_.empty() || collision_of_layers_;
  }
  bool anyOutlined() const { return !outlined_.empty(); }

  /// Whether this geometry of the link is drawn at all.
  bool draws(DrawnGeometry geometry, const PosedDevice& device, std::size_t link) const;
  /// `device`: an index into scene.devices.
  PartLook lookOf(DrawnGeometry geometry, const PosedScene& scene, std::size_t device,
                  std::size_t link, std::string_view group) const;
  bool outlined(const PosedDevice& device, std::size_t link, std::string_view group) const;

 private:
  struct Opacity {
    ViewPath path;
    float opacity = 1;
  };
  CollisionLook collisionOf(const PosedDevice& device, std::size_t link) const;

  bool any_ = false;
  bool of_layers_ = false;  // the cell's layers have looks
  bool collision_of_layers_ = false;
  bool clear_ghosts_ = false;
  std::vector<ViewPath> outlined_, wireframe_, collision_, collision_over_;
  std::vector<Opacity> transparent_;
  const std::vector<std::vector<LimitLevel>>* limits_ = nullptr;
};

}  // namespace rocinante
