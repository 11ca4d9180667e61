#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "viewer/cull/draw_list.h"
#include "viewer/gl/frame_buffer.h"
#include "viewer/gl/inputs_hash.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/background_pass.h"
#include "viewer/passes/mesh_buffers.h"
#include "viewer/passes/texture_store.h"
#include "viewer/view/render_style.h"

namespace rocinante::bench {

enum class DrawOrder {
  ours,      ///< of the renderer's list, sorted by state
  of_model,  ///< device after device, link after link, part after part
};

/// The floor of a frame: the GL calls that draw a list which was made once, and nothing else. The
/// same buffers, shaders and draws as the renderer's; every value was computed beforehand, and only
/// what differs from one draw to the next is set. Its context must be current.
class BareLoop {
 public:
  static Result<BareLoop> create(const GlTable& gl, const Cell& cell, const PosedScene& scene,
                                 const CameraView& view, int width, int height, Shading shading,
                                 DrawOrder order = DrawOrder::ours);

  void draw(const FrameBuffer& target) const;

 private:
  struct Scene;
  struct Run {
    std::uint32_t first = 0, count = 0;
    bool one_sided = false, mirrored = false;
  };
  struct Command {
    std::size_t program = 0, mesh = 0;
    bool sets_program = false, sets_mesh = false, sets_world = false, sets_material = false;
    bool sets_lift = false;
    bool translucent = false;
    glm::mat4 clip{}, relative{};
    glm::mat3 normal{};
    glm::vec4 diffuse{};
    glm::vec3 specular{}, emission{};
    MapPlacing placing{Material{}};
    float shininess = 0;
    GLuint texture = 0;
    bool tinted = false;
    std::uint32_t rank = 0;
    std::vector<Run> runs;
  };
  BareLoop(const GlTable& gl, std::shared_ptr<Scene> scene);
  void set(const Command& command) const;
  void drawRuns(const Command& command) const;
  void useProgram(std::size_t number) const;

  const GlTable& gl_;
  std::shared_ptr<Scene> scene_;
  std::vector<Command> commands_;
  glm::vec3 key_{}, fill_{}, forward_{};
  bool orthographic_ = false;
};

}  // namespace rocinante::bench
