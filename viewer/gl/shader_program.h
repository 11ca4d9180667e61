#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "viewer/gl/gl_name.h"

namespace rocinante {

/// A linked GLSL program. Its context must be current whenever it is used or destroyed.
class ShaderProgram {
 public:
  /// The sources begin with "#version 330 core" and a line end, also for contexts of OpenGL ES.
  /// Waits for nothing: several programs that are begun before the first is finished are compiled
  /// beside each other where the driver can. `name` is used in messages.
  static ShaderProgram begin(const GlTable& gl, std::string_view name, std::string_view vertex,
                             std::string_view fragment);
  /// Required once before use. refused with the compiler's message.
  Status finish();
  /// Both.
  static Result<ShaderProgram> link(const GlTable& gl, std::string_view name,
                                    std::string_view vertex, std::string_view fragment);

  void use() const { gl_->UseProgram(program_); }
  /// -1 when the program has no such uniform (setting it then does nothing).
  GLint uniform(const char* name) const { return gl_->GetUniformLocation(program_, name); }

 private:
  ShaderProgram(const GlTable& gl, std::string_view name) : gl_(&gl), name_(name), program_(gl) {}
  Status compiled(GLuint shader, std::string_view stage) const;

  const GlTable* gl_;
  std::string name_;
  GlProgram program_;
  GlShader vertex_, fragment_;  // until it is finished
};

}  // namespace rocinante
