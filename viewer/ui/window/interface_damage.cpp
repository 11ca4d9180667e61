#include "viewer/ui/window/interface_damage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace rocinante {
namespace {

template <class T>
std::vector<std::byte> bytesOfAll(const ImVector<T>& items) {
  std::vector<std::byte> bytes(static_cast<std::size_t>(items.size_in_bytes()));
  if (!bytes.empty()) std::memcpy(bytes.data(), items.Data, bytes.size());
  return bytes;
}

}  // namespace

InterfaceDamage::List InterfaceDamage::listOf(const ImDrawList& drawn) {
  List list;
  list.vertices = bytesOfAll(drawn.VtxBuffer);
  list.indices = bytesOfAll(drawn.IdxBuffer);
  for (const ImDrawCmd& command : drawn.CmdBuffer) {
    const ImVec4& clip = command.ClipRect;
    list.commands.push_back({clip.x, clip.y, clip.z, clip.w, (std::uintptr_t)(command.GetTexID()),
                             command.VtxOffset, command.IdxOffset, command.ElemCount});
  }
  if (drawn.VtxBuffer.empty()) return list;
  list.left = list.right = drawn.VtxBuffer.front().pos.x;
  list.top = list.bottom = drawn.VtxBuffer.front().pos.y;
  for (const ImDrawVert& vertex : drawn.VtxBuffer) {
    list.left = std::min(list.left, vertex.pos.x);
    list.right = std::max(list.right, vertex.pos.x);
    list.top = std::min(list.top, vertex.pos.y);
    list.bottom = std::max(list.bottom, vertex.pos.y);
  }
  return list;
}

PixelRectangle InterfaceDamage::since(const ImDrawData& data, int width, int height) {
  std::vector<List> lists;
  for (int i = 0; i < data.CmdListsCount; ++i) lists.push_back(listOf(*data.CmdLists[i]));
  const bool comparable =
      known_ && lists.size() == lists_.size() && width == width_ && height == height_;
  float left = 0, top = 0, right = 0, bottom = 0;
  bool any = false;
  const auto add = [&](const List& list) {
    if (list.vertices.empty()) return;
    left = any ? std::min(left, list.left) : list.left;
    top = any ? std::min(top, list.top) : list.top;
    right = any ? std::max(right, list.right) : list.right;
    bottom = any ? std::max(bottom, list.bottom) : list.bottom;
    any = true;
  };
  for (std::size_t i = 0; comparable && i < lists.size(); ++i) {
    if (lists[i] == lists_[i]) continue;
    add(lists_[i]);
    add(lists[i]);
  }
  lists_ = std::move(lists);
  width_ = width;
  height_ = height;
  if (!std::exchange(known_, true) || !comparable) return {0, 0, width, height};
  if (!any) return {0, 0, 0, 0};
  const auto pixel = [](float place, int most) {
    return static_cast<int>(std::clamp(place, 0.0F, static_cast<float>(most)));
  };
  // A triangle's edge may touch the pixel beside it.
  PixelRectangle part;
  part.x = pixel(std::floor(left) - 1, width);
  part.y = pixel(std::floor(top) - 1, height);
  part.width = pixel(std::ceil(right) + 1, width) - part.x;
  part.height = pixel(std::ceil(bottom) + 1, height) - part.y;
  return part;
}

}  // namespace rocinante
