#pragma once

#include <type_traits>
#include <utility>

#include "viewer/gl/gl_table.h"

namespace rocinante {

/// Owns an object of GL, and is its name: 0 for none. Borrows the table. Its context must be
/// current whenever it is made, replaced or destroyed.
template <auto Make, auto Delete>
class GlName {
 public:
  GlName() = default;  ///< none
  /// Makes one; `stage`: of a shader.
  template <class... Stage>
  explicit GlName(const GlTable& gl, Stage... stage) : gl_(&gl) {
    if constexpr (kIsPlural) {
      (gl.*Make)(1, &name_);
    } else {
      name_ = (gl.*Make)(stage...);
    }
  }
  ~GlName() { release(); }
  GlName(GlName&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    if (this == &other) return *this;
    release();
    gl_ = other.gl_;
    name_ = std::exchange(other.name_, 0);
    return *this;
  }

  operator GLuint() const { return name_; }

 private:
  /// Most are made and deleted by arrays of names.
  static constexpr bool kIsPlural =
      std::is_invocable_v<decltype(std::declval<GlTable>().*Delete), GLsizei, const GLuint*>;

  void release() {
    if (name_ == 0) return;
    if constexpr (kIsPlural) {
      (gl_->*Delete)(1, &name_);
    } else {
      (gl_->*Delete)(name_);
    }
  }

  const GlTable* gl_ = nullptr;
  GLuint name_ = 0;
};

using GlBuffer = GlName<&GlTable::GenBuffers, &GlTable::DeleteBuffers>;
using GlFramebuffer = GlName<&GlTable::GenFramebuffers, &GlTable::DeleteFramebuffers>;
using GlProgram = GlName<&GlTable::CreateProgram, &GlTable::DeleteProgram>;
using GlRenderbuffer = GlName<&GlTable::GenRenderbuffers, &GlTable::DeleteRenderbuffers>;
using GlSampler = GlName<&GlTable::GenSamplers, &GlTable::DeleteSamplers>;
using GlShader = GlName<&GlTable::CreateShader, &GlTable::DeleteShader>;
using GlTexture = GlName<&GlTable::GenTextures, &GlTable::DeleteTextures>;
using GlVertexArray = GlName<&GlTable::GenVertexArrays, &GlTable::DeleteVertexArrays>;

}  // namespace rocinante
