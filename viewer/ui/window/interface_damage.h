#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// Finds what an interface changes from one frame to the next, by the triangles of its panels.
class InterfaceDamage {
 public:
  /// The part, in pixels from the top left, in which `data` differs from that of the last call:
  /// without extent when it does not, everything in the first call and after forget().
  PixelRectangle since(const ImDrawData& data, int width, int height);
  void forget() { known_ = false; }

 private:
  struct Command {
    float left, top, right, bottom;
    std::uintptr_t texture;
    unsigned int first_vertex, first_index, count;
    bool operator==(const Command&) const = default;
  };
  /// What a panel draws.
  struct List {
    std::vector<std::byte> vertices, indices;
    std::vector<Command> commands;
    float left = 0, top = 0, right = 0, bottom = 0;
    bool operator==(const List&) const = default;
  };
  static List listOf(const ImDrawList& drawn);

  std::vector<List> lists_;
  int width_ = 0, height_ = 0;
  bool known_ = false;
};

}  // namespace rocinante
