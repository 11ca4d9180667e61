#include "viewer/passes/caster_draw.h"

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "core/mesh/mesh.h"
#include "viewer/passes/draw_triangles.h"
#include "viewer/passes/look_shaders.h"
#include "viewer/passes/shader_source.h"

namespace rocinante {

bool keepsLight(const DrawItem& item) {
  return !item.translucent || (item.texture < 0 && item.diffuse.a >= 0.5F);
}

Result<CasterDraw> CasterDraw::create(const GlTable& gl) {
  using namespace shader;
  auto whole = ShaderProgram::link(gl, "depths", kFlatVertex, kFlatFragment);
  if (!whole) return whole.error();
  auto cut = ShaderProgram::link(gl, "depths of cut pictures", kMappedVertex, kHolesFragment);
  if (!cut) return cut.error();
  return CasterDraw(gl, std::move(*whole), std::move(*cut));
}

CasterDraw::CasterDraw(const GlTable& gl, ShaderProgram whole, ShaderProgram cut)
    : gl_(&gl),
      whole_(std::move(whole)),
      cut_(std::move(cut)),
      clip_from_model_(whole_.uniform("clip_from_model")),
      cut_clip_from_model_(cut_.uniform("clip_from_model")),
      map_along_(cut_.uniform("map_along")),
      map_offset_(cut_.uniform("map_offset")),
      cutoff_(cut_.uniform("cutoff")) {}

void CasterDraw::useCutout(const DrawItem& item, const TextureStore& textures) const {
  cut_.use();
  textures.bind(static_cast<std::size_t>(item.texture));
  const MapPlacing placing(*item.material);
  gl_->Uniform4f(map_along_, placing.along_u.x, placing.along_u.y, placing.along_v.x,
                 placing.along_v.y);
  gl_->Uniform2f(map_offset_, placing.offset.x, placing.offset.y);
  gl_->Uniform1f(cutoff_, item.cutoff);
}

void CasterDraw::draw(std::span<const DrawnSet> sets, const Camera& camera) const {
  whole_.use();
  bool is_whole = true;
  for (const DrawnSet& set : sets) {
    for (const auto* items : {&set.list->opaque, &set.list->translucent}) {
      for (const DrawItem& item : *items) {
        if (!keepsLight(item)) continue;
        const bool cuts = item.is_cut && set.textures != nullptr &&
                          set.textures->name(static_cast<std::size_t>(item.texture)) != 0;
        if (cuts)
          useCutout(item, *set.textures);
        else if (!is_whole)
          whole_.use();
        is_whole = !cuts;
        const glm::mat4 clip_from_model(camera.clipFromRelative() * camera.relative(item.world));
        gl_->UniformMatrix4fv(cuts ? cut_clip_from_model_ : clip_from_model_, 1, GL_FALSE,
                              glm::value_ptr(clip_from_model));
        set.meshes->bind(item.mesh);
        drawTriangles(*gl_, item, *set.catalog);
      }
    }
  }
}

}  // namespace rocinante
