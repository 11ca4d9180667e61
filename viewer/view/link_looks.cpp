#include "viewer/view/link_looks.h"

#include <algorithm>

namespace rocinante {
namespace {

constexpr glm::vec4 kNearLimit{0.98F, 0.66F, 0.10F, 1};
constexpr glm::vec4 kBeyondLimit{0.88F, 0.12F, 0.10F, 1};
constexpr glm::vec4 kCollision{0.90F, 0.58F, 0.26F, 1};
constexpr float kOverOpacity = 0.4F;

Status parseAll(const std::vector<std::string>& texts, std::vector<ViewPath>& paths) {
  for (const std::string& text : texts) {
    const auto path = parseViewPath(text);
    if (!path) return path.error();
    paths.push_back(*path);
  }
  return {};
}

bool anyNames(const std::vector<ViewPath>& paths, const PosedDevice& device, std::size_t link) {
  return std::any_of(paths.begin(), paths.end(),
                     [&](const ViewPath& path) { return path.namesLink(device, link); });
}

bool anyNames(const std::vector<ViewPath>& paths, const PosedDevice& device, std::size_t link,
              std::string_view group) {
  return std::any_of(paths.begin(), paths.end(),
                     [&](const ViewPath& path) { return path.namesPart(device, link, group); });
}

}  // namespace

Result<LinkLooks> LinkLooks::make(const RenderStyle& style, const FrameExtras* extras,
                                  const PosedScene* scene) {
  LinkLooks looks;
  for (const auto& [texts, paths] : {std::pair(&style.outlined, &looks.outlined_),
                                     {&style.wireframe, &looks.wireframe_},
                                     {&style.collision, &looks.collision_},
                                     {&style.collision_over, &looks.collision_over_}}) {
    if (Status fit = parseAll(*texts, *paths); !fit) return fit.error();
  }
  for (const TransparentStyle& one : style.transparent) {
    const auto path = parseViewPath(one.path);
    if (!path) return path.error();
    // NaN becomes 0.
    const double opacity = one.opacity > 0 ? std::min(one.opacity, 1.0) : 0.0;
    looks.transparent_.push_back({*path, static_cast<float>(opacity)});
  }
  looks.clear_ghosts_ = style.ghosts == GhostStyle::clear;
  if (style.limits && extras != nullptr && !extras->limits.empty()) looks.limits_ = &extras->limits;
  if (style.layer_looks && scene != nullptr) {
    looks.of_layers_ = scene->has_looks;
    looks.collision_of_layers_ = scene->has_collision;
  }
  looks.any_ = looks.of_layers_ || looks.clear_ghosts_ || looks.limits_ != nullptr ||
               looks.anyCollision() || !looks.wireframe_.empty() || !looks.transparent_.empty();
  return looks;
}

CollisionLook LinkLooks::collisionOf(const PosedDevice& device, std::size_t link) const {
  if (anyNames(collision_, device, link)) return CollisionLook::only;
  if (anyNames(collision_over_, device, link)) return CollisionLook::over;
  if (!collision_of_layers_ || device.link_look.empty()) return CollisionLook::off;
  return device.link_look[link].collision.value_or(CollisionLook::off);
}

bool LinkLooks::draws(DrawnGeometry geometry, const PosedDevice& device, std::size_t link) const {
  const CollisionLook collision = collisionOf(device, link);
  return geometry == DrawnGeometry::visuals ? collision != CollisionLook::only
                                            : collision != CollisionLook::off;
}

PartLook LinkLooks::lookOf(DrawnGeometry geometry, const PosedScene& scene, std::size_t device,
                           std::size_t link, std::string_view group) const {
  const PosedDevice& posed = scene.devices[device];
  PartLook look;
  look.ghost = clear_ghosts_ && posed.ghost;
  look.wireframe = anyNames(wireframe_, posed, link, group);
  if (of_layers_) {
    const LayerLook by_layers = posed.partLook(link, group);
    look.wireframe = look.wireframe || by_layers.wireframe.value_or(false);
    look.opacity = by_layers.opacity.value_or(1.0F);
  }
  for (const Opacity& one : transparent_) {
    // The later entry wins, as in a list of overrides.
    if (one.path.namesPart(posed, link, group)) look.opacity = one.opacity;
  }
  if (geometry == DrawnGeometry::collisions) {
    look.tone = kCollision;
    if (collisionOf(posed, link) == CollisionLook::over) look.tone->a = kOverOpacity;
  }
  if (limits_ != nullptr && device < limits_->size() && link < (*limits_)[device].size()) {
    const LimitLevel level = (*limits_)[device][link];
    const float alpha = look.tone ? look.tone->a : 1;
    if (level != LimitLevel::inside) {
      look.tone = level == LimitLevel::near ? kNearLimit : kBeyondLimit;
      look.tone->a = alpha;
    }
  }
  return look;
}

bool LinkLooks::outlined(const PosedDevice& device, std::size_t link,
                         std::string_view group) const {
  return anyNames(outlined_, device, link, group);
}

}  // namespace rocinante
