#include "viewer/render/inset_frame.h"

#include <algorithm>

#include "viewer/view/backdrop_frame.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

FrameInset frameInset(const CellInset& inset, const PixelRectangle& part, const CameraView& camera,
                      std::string_view backdrop_camera) {
  return {part,
          camera,
          insetTitle(inset),
          inset.border_rgba,
          inset.border_px,
          hasBackdrop(inset.camera, backdrop_camera)};
}

void addInsetFrame(Overlay& overlay, const FrameInset& inset, const TextAtlas& atlas) {
  constexpr std::uint32_t kTitlePlate = 0x14181CC8;
  constexpr std::uint32_t kTitleInk = 0xF2F4F6FF;
  constexpr int kPadding = 6;
  const double unit = overlay.scale();
  const double left = inset.part.x / unit, top = inset.part.y / unit;
  const double right = (inset.part.x + inset.part.width) / unit;
  const double bottom = (inset.part.y + inset.part.height) / unit;
  const double least_half = std::min(inset.part.width, inset.part.height) / 2 / unit;
  const double wide = std::min<double>(inset.border_px, least_half);
  if (!inset.title.empty()) {
    const TextSize size = overlay.measure(atlas, inset.title);
    const Vec2 corner(left + wide, top + wide);
    overlay.addScreenRectangle(corner, corner + Vec2(size.width + 2 * kPadding, size.height + 2),
                               kTitlePlate);
    overlay.addScreenText(atlas, static_cast<int>(corner.x) + kPadding,
                          static_cast<int>(corner.y) + 1, kTitleInk, inset.title);
  }
  if (wide <= 0) return;
  // The sides must not overlap: a translucent border would show its corners.
  overlay.addScreenRectangle({left, top}, {right, top + wide}, inset.border_rgba);
  overlay.addScreenRectangle({left, bottom - wide}, {right, bottom}, inset.border_rgba);
  overlay.addScreenRectangle({left, top + wide}, {left + wide, bottom - wide}, inset.border_rgba);
  overlay.addScreenRectangle({right - wide, top + wide}, {right, bottom - wide}, inset.border_rgba);
}

}  // namespace rocinante
