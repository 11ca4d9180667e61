#include <imgui.h>

#include <algorithm>
#include <string>

#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

/// The upper left corner of a part of the picture, in the window.
ImVec2 inWindow(const ViewModel& model, const PixelRectangle& part) {
  const PixelRectangle& picture = model.viewer.picture_part;
  return {static_cast<float>(picture.x + part.x), static_cast<float>(picture.y + part.y)};
}

/// What is held, else what could be grabbed there.
std::optional<InsetDrag> insetAtMouse(const ViewModel& model) {
  const ImGuiIO& io = ImGui::GetIO();
  if (model.viewer.inset_drag) return model.viewer.inset_drag;
  if (io.WantCaptureMouse || !ImGui::IsMousePosValid() || ImGui::IsAnyMouseDown()) return {};
  const PixelRectangle& picture = model.viewer.picture_part;
  return grabInset(model, io.MousePos.x - static_cast<float>(picture.x),
                   io.MousePos.y - static_cast<float>(picture.y), px(kInsetGripPx));
}

}  // namespace

void drawInsetGrip(const ViewModel& model) {
  const auto at = insetAtMouse(model);
  if (!at || at->number >= model.viewer.insets.size()) return;
  const auto place = std::ranges::find(model.viewer.inset_places, at->number, &InsetPlace::number);
  if (place == model.viewer.inset_places.end()) return;
  const PixelRectangle& part = place->part;
  const ImVec2 low = inWindow(model, part);
  const ImVec2 high(low.x + static_cast<float>(part.width),
                    low.y + static_cast<float>(part.height));
  const ImU32 faint = panelColor(PanelColor::grip), bright = panelColor(PanelColor::grip_held);
  const bool held = model.viewer.inset_drag.has_value();
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  list->AddRect(low, high, held ? bright : faint, 0, 0, px(held ? 2 : 1));
  const InsetCorner corner = model.viewer.insets[at->number].inset.corner;
  const bool left = corner == InsetCorner::top_left || corner == InsetCorner::bottom_left;
  const bool top = corner == InsetCorner::top_left || corner == InsetCorner::top_right;
  const ImVec2 inner(left ? high.x : low.x, top ? high.y : low.y);
  const float across = (left ? -1.0F : 1.0F) * px(14);
  const float down = (top ? -1.0F : 1.0F) * px(14);
  list->AddTriangleFilled(inner, ImVec2(inner.x + across, inner.y), ImVec2(inner.x, inner.y + down),
                          at->sizes ? bright : faint);
}

void drawInsetTabs(ViewModel& model) {
  const PixelRectangle& picture = model.viewer.picture_part;
  for (const InsetTab& tab : insetTabs(model, picture.width, picture.height, px(1))) {
    const ImVec2 size(static_cast<float>(tab.place.width), static_cast<float>(tab.place.height));
    ImGui::SetNextWindowPos(inWindow(model, tab.place));
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::SetNextWindowBgAlpha(1);
    const std::string name = "inset " + std::to_string(tab.number);
    ImGui::Begin(name.c_str(), nullptr,
                 (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    const std::string title = insetTitle(model.viewer.insets[tab.number].inset);
    const std::string shown = cutInMiddle(title, size.x - px(12), drawnWidth);
    if (ImGui::Button((shown + "##open").c_str(), size)) openInset(model, tab.number);
    explain(
        (title + ": there is no room for this inset; a click gives it that of another").c_str());
    ImGui::End();
  }
}

}  // namespace rocinante
