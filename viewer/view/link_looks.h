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

/// Which geometry of the models a draw list is made of.
enum class DrawnGeometry { visuals, collisions };

/// How one part is drawn when not as its materials say.
struct PartLook {
  bool wireframe = false;
  bool ghost = false;             ///< in one tone, behind the actual device (GhostStyle::clear)
  float opacity = 1;              ///< times its own
  std::optional<glm::vec4> tone;  ///< in place of its materials and its picture
};

/// What a style, and below it the cell's layers, say of the links of a scene. A plain value;
/// borrows the extras.
class LinkLooks {
 public:
  /// Nothing out of the ordinary.
  LinkLooks() = default;
  /// bad_argument for a PATH that is none. `scene`: for what its cell's layers say; null: nothing.
  static Result<LinkLooks> make(const RenderStyle& style, const FrameExtras* extras,
                                const PosedScene* scene = nullptr);

  /// False when every part is drawn as its materials say.
  bool any() const { return any_; }
  bool anyCollision() const {
    return !collision_.empty() || !collision_over_.empty() || collision_of_layers_;
  }
  bool anyOutlined() const { return !outlined_.empty(); }

  /// Whether this geometry of the link is drawn at all.
  bool draws(DrawnGeometry geometry, const PosedDevice& device, std::size_t link) const;
  /// `device`: a place in scene.devices.
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
  bool of_layers_ = false;  // what the cell has layers drawn like
  bool collision_of_layers_ = false;
  bool clear_ghosts_ = false;
  std::vector<ViewPath> outlined_, wireframe_, collision_, collision_over_;
  std::vector<Opacity> transparent_;
  const std::vector<std::vector<LimitLevel>>* limits_ = nullptr;
};

}  // namespace rocinante
