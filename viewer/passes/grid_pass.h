#pragma once

#include <map>
#include <utility>

#include "core/cell/cell.h"
#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/contact_map.h"
#include "viewer/passes/shadow_map.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Draws the ground grid into the bound framebuffer, between DrawPasses::begin() and end(). Its
/// context must be current whenever it is used or destroyed.
class GridPass {
 public:
  explicit GridPass(const GlTable& gl);

  /// Draws nothing when the cell's grid has no size or no step. `shadows` and `contact`, if not
  /// null, darken the ground that the grid covers.
  Status draw(const Camera& camera, const CellScene& look, double scale,
              const ShadowLookup* shadows, const ContactLookup* contact);

 private:
  Result<const ShaderProgram*> program(bool by_shadows, bool by_contact);

  const GlTable& gl_;
  std::map<std::pair<bool, bool>, ShaderProgram> programs_;  // made on first use
  GlVertexArray array_{gl_};
  GlBuffer vertices_{gl_};
};

}  // namespace rocinante
