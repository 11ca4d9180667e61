#include "golden/compare/changed_blocks.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace rocinante {
namespace {

/// A block's float planes fit into the L2 cache; larger blocks would share more of their borders.
constexpr int kBlock = 128;

bool differsWithin(const Picture& a, const Picture& b, const PixelBlock& block) {
  const auto bytes = static_cast<std::size_t>(block.width()) * 4;
  for (int y = block.top; y < block.bottom; ++y) {
    const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                               static_cast<std::size_t>(block.left)) *
                              4;
    if (std::memcmp(a.rgba.data() + first, b.rgba.data() + first, bytes) != 0) return true;
  }
  return false;
}

}  // namespace

void forEachChangedBlock(const Picture& a, const Picture& b, const PixelBlock& area, int reach,
                         const std::function<void(const PixelBlock&)>& visit) {
  assert(a.width == b.width && a.height == b.height);
  for (int top = area.top; top < area.bottom; top += kBlock) {
    for (int left = area.left; left < area.right; left += kBlock) {
      const PixelBlock block{left, top, std::min(left + kBlock, area.right),
                             std::min(top + kBlock, area.bottom)};
      const PixelBlock around{std::max(0, block.left - reach), std::max(0, block.top - reach),
                              std::min(a.width, block.right + reach),
                              std::min(a.height, block.bottom + reach)};
      if (differsWithin(a, b, around)) visit(block);
    }
  }
}

}  // namespace rocinante
