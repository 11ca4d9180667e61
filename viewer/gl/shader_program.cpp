#include "viewer/gl/shader_program.h"

#include <fmt/format.h>

#include <string>

namespace rocinante {
namespace {

constexpr std::string_view kFirstLine = "#version 330 core\n";
/// In its place for OpenGL ES, where precision has no default; the sources are the same.
constexpr std::string_view kEmbeddedFirstLines =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp usampler2D;\n";

/// What the driver says about a shader or a program.
template <class Ask>
std::string logOf(Ask ask, GLuint name) {
  std::string log(2048, '\0');
  GLsizei length = 0;
  ask(name, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log;
}

GlShader compile(const GlTable& gl, GLenum stage, std::string_view source) {
  GlShader shader(gl, stage);
  std::string embedded;
  if (gl.is_embedded && source.starts_with(kFirstLine)) {
    embedded = std::string(kEmbeddedFirstLines).append(source.substr(kFirstLine.size()));
    source = embedded;
  }
  const GLchar* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader, 1, &text, &length);
  gl.CompileShader(shader);
  return shader;
}

}  // namespace

ShaderProgram ShaderProgram::begin(const GlTable& gl, std::string_view name,
                                   std::string_view vertex, std::string_view fragment) {
  ShaderProgram program(gl, name);
  program.vertex_ = compile(gl, GL_VERTEX_SHADER, vertex);
  program.fragment_ = compile(gl, GL_FRAGMENT_SHADER, fragment);
  gl.AttachShader(program.program_, program.vertex_);
  gl.AttachShader(program.program_, program.fragment_);
  gl.LinkProgram(program.program_);
  return program;
}

Status ShaderProgram::compiled(GLuint shader, std::string_view stage) const {
  GLint done = 0;
  gl_->GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return {};
  return Error{ErrorKind::refused,
               fmt::format("the GL driver does not compile the {} shader ({}): {}", name_, stage,
                           logOf(gl_->GetShaderInfoLog, shader)),
               {}};
}

Status ShaderProgram::finish() {
  GLint done = 0;
  gl_->GetProgramiv(program_, GL_LINK_STATUS, &done);
  Status fine;
  if (done != GL_TRUE) {
    fine = compiled(vertex_, "vertex");
    if (fine) fine = compiled(fragment_, "fragment");
    if (fine) {
      fine = Error{ErrorKind::refused,
                   fmt::format("the GL driver does not link the {} program: {}", name_,
                               logOf(gl_->GetProgramInfoLog, program_)),
                   {}};
    }
  }
  // The program keeps them alive.
  vertex_ = {};
  fragment_ = {};
  return fine;
}

Result<ShaderProgram> ShaderProgram::link(const GlTable& gl, std::string_view name,
                                          std::string_view vertex, std::string_view fragment) {
  ShaderProgram program = begin(gl, name, vertex, fragment);
  if (Status linked = program.finish(); !linked) return linked.error();
  return program;
}

}  // namespace rocinante
