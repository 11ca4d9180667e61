#pragma once

#include <map>
#include <span>

#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/caster_draw.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Data for a shader that reads how open the places of a view are.
struct ContactLookup {
  GLuint map = 0;          ///< openness and depth along the view, of every second pixel
  glm::vec2 origin{0.0F};  ///< of the view in the framebuffer, pixels from its bottom left
  glm::vec2 texels_a_pixel{0.5F};
};

/// Binds a map at texture unit 2 for a program made with withContact(), which must be in use.
void bindContact(const GlTable& gl, const ShaderProgram& program, const ContactLookup& contact);

/// How much of its surroundings a place sees, from the depths of the view at half its resolution:
/// what is near in front of a surface keeps light from it. In our own float textures, with + - * /
/// and roots alone, so that it is as reproducible as the rest. docs/rendering.md, section "Looks".
/// Its context must be current whenever it is used or destroyed.
class ContactMap {
 public:
  static Result<ContactMap> create(const GlTable& gl);

  /// Draws the mostly opaque items of `sets` as `camera` sees them, and the ground up to `ground_m`
  /// from the origin (0: no ground). `view`: number of the view in its picture, whose map stays
  /// valid until it is drawn again. Restores the framebuffer binding, not the viewport. `origin`:
  /// see ContactLookup. refused when the driver cannot create the textures.
  Result<ContactLookup> draw(std::size_t view, std::span<const DrawnSet> sets, const Camera& camera,
                             double ground_m, const glm::vec2& origin);

 private:
  /// The textures of a view.
  struct Target {
    int width = 0, height = 0;
    GlTexture depth, first, second;
    GlFramebuffer depth_frame, first_frame, second_frame;
  };
  ContactMap(const GlTable& gl, CasterDraw items, ShaderProgram ground, ShaderProgram openness,
             ShaderProgram evened);
  Result<const Target*> targetOf(std::size_t view, int width, int height);
  void drawDepths(const Target& target, std::span<const DrawnSet> sets, const Camera& camera,
                  double ground_m) const;
  void drawOpenness(const Target& target, const Camera& camera) const;
  void even(const Target& target) const;

  const GlTable& gl_;
  CasterDraw items_;
  ShaderProgram ground_, openness_, evened_;
  GlVertexArray empty_array_{gl_};
  std::map<std::size_t, Target> targets_;
};

}  // namespace rocinante
