#include "viewer/gl/gl_table.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "viewer/gl/shader_program.h"

namespace rocinante {
namespace {

// A context of OpenGL ES, as far as a table and a shader ask it.
std::string shader_text;
void nothing() {}
const GLubyte* APIENTRY versionOf(GLenum) {
  return reinterpret_cast<const GLubyte*>("OpenGL ES 3.0 (WebGL 2.0)");
}
void APIENTRY integerOf(GLenum name, GLint* value) { *value = name == GL_MAJOR_VERSION ? 3 : 0; }
void APIENTRY takeSource(GLuint, GLsizei, const GLchar* const* text, const GLint* length) {
  shader_text.assign(text[0], static_cast<std::size_t>(length[0]));
}
GLuint APIENTRY oneName(GLenum) { return 1; }
void APIENTRY notCompiled(GLuint, GLenum, GLint* value) { *value = GL_FALSE; }
void APIENTRY noText(GLuint, GLsizei, GLsizei* length, GLchar*) { *length = 0; }
void APIENTRY ofOne(GLuint) {}

GlProc embeddedProc(const char* name) {
  const auto is = [&](const char* other) { return std::strcmp(name, other) == 0; };
  if (is("glClipControl")) return nullptr;
  if (is("glGetString")) return reinterpret_cast<GlProc>(&versionOf);
  if (is("glGetIntegerv")) return reinterpret_cast<GlProc>(&integerOf);
  if (is("glShaderSource")) return reinterpret_cast<GlProc>(&takeSource);
  if (is("glCreateShader")) return reinterpret_cast<GlProc>(&oneName);
  if (is("glGetShaderiv")) return reinterpret_cast<GlProc>(&notCompiled);
  if (is("glGetShaderInfoLog")) return reinterpret_cast<GlProc>(&noText);
  if (is("glCompileShader") || is("glDeleteShader")) return reinterpret_cast<GlProc>(&ofOne);
  return &nothing;
}

TEST(GlTable, KnowsAContextOfOpenGlEs) {
  const auto gl = fillGlTable(embeddedProc);
  ASSERT_TRUE(gl.has_value()) << gl.error().text();
  EXPECT_TRUE(gl->is_embedded);
  EXPECT_FALSE(gl->clamps_depth);
  EXPECT_EQ(gl->ClipControl, nullptr);
}

TEST(GlTable, KnowsARendererThatDrawsOnTheProcessor) {
  for (const char* name :
       {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Mesa DRI swrast", "Software Rasterizer",
        "zink Vulkan 1.3(llvmpipe (LLVM 19.1.7, 256 bits) (MESA_LLVMPIPE))",
        "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)",
        "D3D12 (Microsoft Basic Render Driver)"}) {
    EXPECT_TRUE(isSoftwareRenderer(name)) << name;
  }
  for (const char* name : {"Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "AMD Radeon RX 6800",
                           "NVIDIA GeForce RTX 3060/PCIe/SSE2", "D3D12 (NVIDIA RTX A2000)", ""}) {
    EXPECT_FALSE(isSoftwareRenderer(name)) << name;
  }
}

TEST(ShaderProgram, HasTheFirstLinesOfItsContext) {
  const auto gl = fillGlTable(embeddedProc);
  ASSERT_TRUE(gl.has_value());
  constexpr const char* kSource = "#version 330 core\nvoid main() {}\n";
  const auto program = ShaderProgram::link(*gl, "test", kSource, kSource);
  EXPECT_FALSE(program.has_value());
  EXPECT_TRUE(shader_text.starts_with("#version 300 es\nprecision highp float;\n")) << shader_text;
  EXPECT_TRUE(shader_text.ends_with("\nvoid main() {}\n")) << shader_text;
}

}  // namespace
}  // namespace rocinante
