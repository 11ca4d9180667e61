#pragma once

#include <string_view>

#include "core/base/result.h"
#include "viewer/gl/gl_table.h"

namespace rocinante {

/// A linked GLSL program. Its context must be current whenever it is used or destroyed.
class ShaderProgram {
 public:
  /// The sources begin with "#version 330 core" and a line end, also for contexts of OpenGL ES.
  /// refused with the compiler's message. `name` is used in messages.
  static Result<ShaderProgram> link(const GlTable& gl, std::string_view name,
                                    std::string_view vertex, std::string_view fragment);

  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;

  void use() const { gl_->UseProgram(program_); }
  /// -1 when the program has no such uniform (setting it then does nothing).
  GLint uniform(const char* name) const { return gl_->GetUniformLocation(program_, name); }

 private:
  ShaderProgram(const GlTable& gl, GLuint program) : gl_(&gl), program_(program) {}

  const GlTable* gl_;
  GLuint program_ = 0;
};

}  // namespace rocinante
