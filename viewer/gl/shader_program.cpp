#include "viewer/gl/shader_program.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace rocinante {
namespace {

constexpr std::string_view kFirstLine = "#version 330 core\n";
/// In its place for OpenGL ES, where precision has no default; the sources are the same.
constexpr std::string_view kEmbeddedFirstLines =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp usampler2D;\n";

Result<GLuint> compile(const GlTable& gl, GLenum stage, std::string_view name,
                       std::string_view source) {
  const GLuint shader = gl.CreateShader(stage);
  std::string embedded;
  if (gl.is_embedded && source.starts_with(kFirstLine)) {
    embedded = std::string(kEmbeddedFirstLines).append(source.substr(kFirstLine.size()));
    source = embedded;
  }
  const GLchar* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader, 1, &text, &length);
  gl.CompileShader(shader);
  GLint done = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return shader;
  std::string log(2048, '\0');
  GLsizei log_length = 0;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &log_length, log.data());
  log.resize(static_cast<std::size_t>(log_length));
  gl.DeleteShader(shader);
  return Error{ErrorKind::refused,
               fmt::format("the GL driver does not compile the {} shader: {}", name, log),
               {}};
}

}  // namespace

Result<ShaderProgram> ShaderProgram::link(const GlTable& gl, std::string_view name,
                                          std::string_view vertex, std::string_view fragment) {
  const Result<GLuint> vertex_shader = compile(gl, GL_VERTEX_SHADER, name, vertex);
  if (!vertex_shader) return vertex_shader.error();
  const Result<GLuint> fragment_shader = compile(gl, GL_FRAGMENT_SHADER, name, fragment);
  if (!fragment_shader) {
    gl.DeleteShader(*vertex_shader);
    return fragment_shader.error();
  }
  ShaderProgram program(gl, gl.CreateProgram());
  gl.AttachShader(program.program_, *vertex_shader);
  gl.AttachShader(program.program_, *fragment_shader);
  gl.LinkProgram(program.program_);
  // The program keeps them alive.
  gl.DeleteShader(*vertex_shader);
  gl.DeleteShader(*fragment_shader);
  GLint done = 0;
  gl.GetProgramiv(program.program_, GL_LINK_STATUS, &done);
  if (done != GL_TRUE) {
    std::string log(2048, '\0');
    GLsizei log_length = 0;
    gl.GetProgramInfoLog(program.program_, static_cast<GLsizei>(log.size()), &log_length,
                         log.data());
    log.resize(static_cast<std::size_t>(log_length));
    return Error{ErrorKind::refused,
                 fmt::format("the GL driver does not link the {} program: {}", name, log),
                 {}};
  }
  return program;
}

ShaderProgram::~ShaderProgram() {
  if (program_ != 0) gl_->DeleteProgram(program_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept
    : gl_(other.gl_), program_(std::exchange(other.program_, 0)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  if (this != &other) {
    if (program_ != 0) gl_->DeleteProgram(program_);
    gl_ = other.gl_;
    program_ = std::exchange(other.program_, 0);
  }
  return *this;
}

}  // namespace rocinante
