#include "viewer/ui/window/imgui_painter.h"

#include <imgui.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"

namespace rocinante {
namespace {

constexpr char kVertexShader[] = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 color;
uniform vec4 scale_and_shift;
out vec2 at;
out vec4 tint;
void main() {
  at = texture_position;
  tint = color;
  gl_Position = vec4(position * scale_and_shift.xy + scale_and_shift.zw, 0.0, 1.0);
}
)";

constexpr char kFragmentShader[] = R"(#version 330 core
in vec2 at;
in vec4 tint;
uniform sampler2D glyphs;
out vec4 color;
void main() { color = tint * texture(glyphs, at); }
)";

}  // namespace

struct ImguiPainter::Impl {
  explicit Impl(const GlTable& table) : gl(table) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void makeBuffers();
  void makeFontTexture();
  void setState(const ImDrawData& data, int width, int height) const;
  void drawList(const ImDrawList& list, ImVec2 origin, int height,
                const PixelRectangle& within) const;

  const GlTable gl;
  std::optional<ShaderProgram> program;
  GlTexture texture;
  GlBuffer vertices{gl}, indices{gl};
  GlVertexArray array{gl};
};

void ImguiPainter::Impl::makeBuffers() {
  gl.BindVertexArray(array);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  for (const GLuint attribute : {0U, 1U, 2U}) gl.EnableVertexAttribArray(attribute);
  constexpr GLsizei kStride = sizeof(ImDrawVert);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                         offset(offsetof(ImDrawVert, col)));
  gl.BindVertexArray(0);
}

void ImguiPainter::Impl::makeFontTexture() {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  texture = GlTexture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  // A pointer before ImGui 1.91.4, a 64-bit integer since.
  ImGui::GetIO().Fonts->SetTexID((ImTextureID)(static_cast<std::uintptr_t>(texture)));
}

void ImguiPainter::Impl::setState(const ImDrawData& data, int width, int height) const {
  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.Enable(GL_BLEND);
  gl.Enable(GL_SCISSOR_TEST);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  program->use();
  const float scale_x = 2.0F / data.DisplaySize.x;
  const float scale_y = -2.0F / data.DisplaySize.y;
  gl.Uniform4f(program->uniform("scale_and_shift"), scale_x, scale_y,
               -1.0F - data.DisplayPos.x * scale_x, 1.0F - data.DisplayPos.y * scale_y);
  gl.Uniform1i(program->uniform("glyphs"), 0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindVertexArray(array);
}

void ImguiPainter::Impl::drawList(const ImDrawList& list, ImVec2 origin, int height,
                                  const PixelRectangle& within) const {
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices);
  gl.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                GL_STREAM_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                GL_STREAM_DRAW);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const int left = static_cast<int>(command.ClipRect.x - origin.x);
    const int top = static_cast<int>(command.ClipRect.y - origin.y);
    const int right = static_cast<int>(command.ClipRect.z - origin.x);
    const int bottom = static_cast<int>(command.ClipRect.w - origin.y);
    const PixelRectangle clip = overlapOf({left, top, right - left, bottom - top}, within);
    if (clip.width <= 0 || clip.height <= 0 || command.ElemCount == 0) continue;
    gl.Scissor(clip.x, height - clip.y - clip.height, clip.width, clip.height);
    gl.BindTexture(GL_TEXTURE_2D, (GLuint)(std::uintptr_t)(command.GetTexID()));
    gl.DrawElementsBaseVertex(
        GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
        sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(command.IdxOffset) *
                                      sizeof(ImDrawIdx)),
        static_cast<GLint>(command.VtxOffset));
  }
}

ImguiPainter::ImguiPainter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ImguiPainter::~ImguiPainter() = default;
ImguiPainter::ImguiPainter(ImguiPainter&&) noexcept = default;
ImguiPainter& ImguiPainter::operator=(ImguiPainter&&) noexcept = default;

Result<ImguiPainter> ImguiPainter::create(const GlTable& gl) {
  auto impl = std::make_unique<Impl>(gl);
  auto program = ShaderProgram::link(impl->gl, "interface", kVertexShader, kFragmentShader);
  if (!program.ok()) return program.error();
  impl->program = std::move(*program);
  impl->makeBuffers();
  impl->makeFontTexture();
  return ImguiPainter(std::move(impl));
}

void ImguiPainter::refreshFont() {
  impl_->texture = {};
  impl_->makeFontTexture();
}

void ImguiPainter::draw(const ImDrawData& data, int width, int height,
                        const std::optional<PixelRectangle>& only) {
  if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
  impl_->setState(data, width, height);
  const PixelRectangle within = only.value_or(PixelRectangle{0, 0, width, height});
  for (int i = 0; i < data.CmdListsCount; ++i) {
    impl_->drawList(*data.CmdLists[i], data.DisplayPos, height, within);
  }
  impl_->gl.Disable(GL_SCISSOR_TEST);
  impl_->gl.Disable(GL_BLEND);
  impl_->gl.BindVertexArray(0);
}

}  // namespace rocinante
