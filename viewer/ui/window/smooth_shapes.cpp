#include <imgui.h>

#include <algorithm>
#include <cmath>

// Replacements of the two functions that draw every smooth edge of Dear ImGui. The originals use
// the approximate reciprocal root (rsqrtss), whose last bits depend on the CPU vendor; these use a
// root and a division, which are the same everywhere. The look is the same: an edge fades over one
// pixel. viewer/ui/CMakeLists.txt links these instead
// (docs/decisions/010-panels-without-approximate-roots.md).
namespace {

constexpr float kFringe = 1;  // pixels over which an edge fades

/// Unit vector perpendicular to the line between two points; 0 if they are equal.
ImVec2 sideOf(const ImVec2& from, const ImVec2& to) {
  const ImVec2 way(to.x - from.x, to.y - from.y);
  const float square = way.x * way.x + way.y * way.y;
  if (!(square > 0)) return {0, 0};
  const float length = std::sqrt(square);
  return {way.y / length, -way.x / length};
}

/// Intersection of the sides of two adjacent segments, limited at sharp corners.
ImVec2 cornerOf(const ImVec2& before, const ImVec2& after) {
  const ImVec2 middle((before.x + after.x) / 2, (before.y + after.y) / 2);
  const float square = middle.x * middle.x + middle.y * middle.y;
  if (square <= 1e-6F) return middle;
  const float stretch = std::min(1 / square, 100.0F);
  return {middle.x * stretch, middle.y * stretch};
}

ImVec2 shifted(const ImVec2& point, const ImVec2& side, float by) {
  return {point.x + side.x * by, point.y + side.y * by};
}

}  // namespace

void ImDrawList::AddPolyline(const ImVec2* points, int count, ImU32 color, ImDrawFlags flags,
                             float thickness) {
  if (count < 2 || (color & IM_COL32_A_MASK) == 0) return;
  const bool closed = (flags & ImDrawFlags_Closed) != 0;
  const int segments = closed ? count : count - 1;
  const float core = (std::max(thickness, kFringe) - kFringe) / 2;
  const ImU32 clear = color & ~IM_COL32_A_MASK;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();

  PrimReserve(segments * 18, count * 4);
  const unsigned int first = _VtxCurrentIdx;
  ImVec2 before = closed ? sideOf(points[count - 1], points[0]) : sideOf(points[0], points[1]);
  for (int i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const ImVec2 after = last && !closed ? before : sideOf(points[i], points[last ? 0 : i + 1]);
    const ImVec2 side = cornerOf(before, after);
    before = after;
    PrimWriteVtx(shifted(points[i], side, core + kFringe), white, clear);
    PrimWriteVtx(shifted(points[i], side, core), white, color);
    PrimWriteVtx(shifted(points[i], side, -core), white, color);
    PrimWriteVtx(shifted(points[i], side, -core - kFringe), white, clear);
  }
  for (int i = 0; i < segments; ++i) {
    const unsigned int here = first + 4 * static_cast<unsigned int>(i);
    const unsigned int next = i + 1 == count ? first : here + 4;
    for (const unsigned int strip : {1U, 0U, 2U}) {  // the core first
      for (const unsigned int corner : {next + strip, here + strip, here + strip + 1,
                                        here + strip + 1, next + strip + 1, next + strip}) {
        PrimWriteIdx(static_cast<ImDrawIdx>(corner));
      }
    }
  }
}

void ImDrawList::AddConvexPolyFilled(const ImVec2* points, int count, ImU32 color) {
  if (count < 3 || (color & IM_COL32_A_MASK) == 0) return;
  const ImU32 clear = color & ~IM_COL32_A_MASK;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();

  PrimReserve((count - 2) * 3 + count * 6, count * 2);
  const unsigned int first = _VtxCurrentIdx;
  ImVec2 before = sideOf(points[count - 1], points[0]);
  for (int i = 0; i < count; ++i) {
    const ImVec2 after = sideOf(points[i], points[i + 1 == count ? 0 : i + 1]);
    const ImVec2 side = cornerOf(before, after);
    before = after;
    PrimWriteVtx(shifted(points[i], side, -kFringe / 2), white, color);
    PrimWriteVtx(shifted(points[i], side, kFringe / 2), white, clear);
  }
  const auto inner = [first](int point) { return first + 2 * static_cast<unsigned int>(point); };
  for (int i = 2; i < count; ++i) {
    for (const unsigned int corner : {first, inner(i - 1), inner(i)}) {
      PrimWriteIdx(static_cast<ImDrawIdx>(corner));
    }
  }
  for (int i = 0, back = count - 1; i < count; back = i++) {
    for (const unsigned int corner :
         {inner(i), inner(back), inner(back) + 1, inner(back) + 1, inner(i) + 1, inner(i)}) {
      PrimWriteIdx(static_cast<ImDrawIdx>(corner));
    }
  }
}
