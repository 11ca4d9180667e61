#include <imgui.h>

#include <algorithm>

#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr ImU32 kFaint = IM_COL32(255, 255, 255, 110);
constexpr ImU32 kHeld = IM_COL32(255, 168, 64, 255);

/// What is held, else what could be grabbed there.
std::optional<InsetDrag> insetAtMouse(const ViewModel& model) {
  const ImGuiIO& io = ImGui::GetIO();
  if (model.viewer.inset_drag) return model.viewer.inset_drag;
  if (io.WantCaptureMouse || !ImGui::IsMousePosValid() || ImGui::IsAnyMouseDown()) return {};
  return grabInset(model, io.MousePos.x, io.MousePos.y, px(kInsetGripPx));
}

}  // namespace

void drawInsetGrip(const ViewModel& model) {
  const auto at = insetAtMouse(model);
  if (!at || at->number >= model.viewer.insets.size()) return;
  const auto place = std::ranges::find(model.viewer.inset_places, at->number, &InsetPlace::number);
  if (place == model.viewer.inset_places.end()) return;
  const PixelRectangle& part = place->part;
  const ImVec2 low(static_cast<float>(part.x), static_cast<float>(part.y));
  const ImVec2 high(low.x + static_cast<float>(part.width),
                    low.y + static_cast<float>(part.height));
  const bool held = model.viewer.inset_drag.has_value();
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  list->AddRect(low, high, held ? kHeld : kFaint, 0, 0, px(held ? 2 : 1));
  const InsetCorner corner = model.viewer.insets[at->number].inset.corner;
  const bool left = corner == InsetCorner::top_left || corner == InsetCorner::bottom_left;
  const bool top = corner == InsetCorner::top_left || corner == InsetCorner::top_right;
  const ImVec2 inner(left ? high.x : low.x, top ? high.y : low.y);
  const float across = (left ? -1.0F : 1.0F) * px(14);
  const float down = (top ? -1.0F : 1.0F) * px(14);
  list->AddTriangleFilled(inner, ImVec2(inner.x + across, inner.y), ImVec2(inner.x, inner.y + down),
                          at->sizes ? kHeld : kFaint);
}

}  // namespace rocinante
