#pragma once

#include <optional>

#include "core/cell/cell.h"
#include "viewer/passes/backdrop_pass.h"
#include "viewer/passes/contact_map.h"
#include "viewer/passes/edge_pass.h"
#include "viewer/passes/ghost_pass.h"
#include "viewer/passes/mesh_buffers.h"
#include "viewer/passes/outline_pass.h"
#include "viewer/passes/shadow_map.h"

namespace rocinante {

/// The passes of optional looks, each made on first use, so that unused ones cost nothing. Its
/// context must be current whenever it is used or destroyed.
class LookPasses {
 public:
  explicit LookPasses(const GlTable& gl) : gl_(gl) {}

  /// refused with the driver's message when its shader or framebuffer cannot be created.
  Result<BackdropPass*> backdrops() { return made<BackdropPass>(backdrops_); }
  Result<EdgePass*> edges() { return made<EdgePass>(edges_); }
  Result<GhostPass*> ghosts() { return made<GhostPass>(ghosts_); }
  Result<OutlinePass*> outlines() { return made<OutlinePass>(outlines_); }
  Result<ShadowMap*> shadows() { return made<ShadowMap>(shadows_); }
  Result<ContactMap*> contact() { return made<ContactMap>(contact_); }

 private:
  template <class Pass>
  Result<Pass*> made(std::optional<Pass>& place) {
    if (!place) {
      auto pass = Pass::create(gl_);
      if (!pass) return pass.error();
      place.emplace(std::move(*pass));
    }
    return &*place;
  }

  const GlTable& gl_;
  std::optional<BackdropPass> backdrops_;
  std::optional<EdgePass> edges_;
  std::optional<GhostPass> ghosts_;
  std::optional<OutlinePass> outlines_;
  std::optional<ShadowMap> shadows_;
  std::optional<ContactMap> contact_;
};

}  // namespace rocinante
