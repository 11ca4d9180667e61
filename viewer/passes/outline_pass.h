#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/drawn_set.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// The line around what is covered: by pixel how much of it the line covers, 0 to 255, from what is
/// covered by the thing itself (non-zero), row by row. Two and a half pixels wide, times `scale`,
/// 0.5 to 4; none of them on the thing. On the CPU: a shader that looks around each pixel took
/// fifteen times as long in software, and these are whole numbers.
std::vector<std::uint8_t> outlineOf(const std::vector<std::uint8_t>& covered, int width, int height,
                                    double scale = 1);

/// Draws a line around all outlined items together (DrawItem::outlined), also where they are
/// hidden. First find() what they cover, before a frame's own passes; then draw() the line over
/// them. Its context must be current whenever it is used or destroyed.
class OutlinePass {
 public:
  static Result<OutlinePass> create(const GlTable& gl);
  ~OutlinePass();
  OutlinePass(OutlinePass&& other) noexcept;
  OutlinePass& operator=(OutlinePass&&) = delete;

  /// Draws into a picture of its own, of the camera's size; what was bound for drawing is bound
  /// again after, the viewport is not.
  Status find(std::span<const DrawnSet> sets, const Camera& camera, double scale);
  /// Into whatever framebuffer is bound. Nothing when find() found nothing.
  void draw() const;

 private:
  OutlinePass(const GlTable& gl, ShaderProgram mask, ShaderProgram line);
  Status resize(int width, int height);
  void makeLine(double scale);

  const GlTable& gl_;
  ShaderProgram mask_, line_;
  GLuint empty_array_ = 0, frame_ = 0, covered_ = 0, cover_ = 0;
  int width_ = 0, height_ = 0;
  bool found_ = false;
  /// Of what is covered, with room for the line: pixels from the bottom left.
  int left_ = 0, bottom_ = 0, right_ = 0, top_ = 0;
};

}  // namespace rocinante
