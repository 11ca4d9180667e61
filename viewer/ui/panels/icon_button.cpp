#include "viewer/ui/panels/icon_button.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <initializer_list>

#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kSide = 22;

/// Draws in a square of 16 interface units. Points are numbers, not sines of a library: pictures of
/// the window are the same on every machine.
class IconPen {
 public:
  IconPen(const ImVec2& corner, ImU32 color)
      : list_(ImGui::GetWindowDrawList()), corner_(corner), color_(color) {}

  void line(std::initializer_list<ImVec2> points) {
    std::array<ImVec2, 16> placed;
    int count = 0;
    for (const ImVec2& point : points) placed.at(static_cast<std::size_t>(count++)) = at(point);
    list_->AddPolyline(placed.data(), count, color_, 0, px(1.4F));
  }
  void box(const ImVec2& low, const ImVec2& high, float rounding) {
    list_->AddRect(at(low), at(high), color_, px(rounding), 0, px(1.4F));
  }
  void filledBox(const ImVec2& low, const ImVec2& high) {
    list_->AddRectFilled(at(low), at(high), color_, px(1));
  }
  void triangle(const ImVec2& a, const ImVec2& b, const ImVec2& c) {
    list_->AddTriangleFilled(at(a), at(b), at(c), color_);
  }

 private:
  ImVec2 at(const ImVec2& point) const {
    return {corner_.x + px(point.x), corner_.y + px(point.y)};
  }

  ImDrawList* list_;
  ImVec2 corner_;
  ImU32 color_;
};

void drawIcon(Icon icon, const ImVec2& corner, ImU32 color) {
  IconPen pen(corner, color);
  switch (icon) {
    case Icon::reset:  // round and back to where it began
      pen.line({{5.06F, 4.46F},
                {6.83F, 3.64F},
                {8.77F, 3.56F},
                {10.60F, 4.23F},
                {12.04F, 5.55F},
                {12.86F, 7.32F},
                {12.94F, 9.27F},
                {12.27F, 11.10F},
                {10.96F, 12.53F},
                {9.19F, 13.36F},
                {7.24F, 13.44F},
                {5.41F, 12.78F},
                {3.97F, 11.46F},
                {3.15F, 9.70F}});
      pen.triangle({2.2F, 2.2F}, {7.6F, 2.8F}, {3.4F, 7.4F});
      return;
    case Icon::copy:  // a sheet in front of another
      pen.line({{5, 4.5F}, {5, 2.5F}, {13, 2.5F}, {13, 10.5F}, {11.5F, 10.5F}});
      pen.box({3, 5.5F}, {10.5F, 13.5F}, 1);
      return;
    case Icon::drive:  // out of here
      pen.line({{7, 3}, {3, 3}, {3, 13}, {7, 13}});
      pen.line({{6, 8}, {11, 8}});
      pen.triangle({10, 4.5F}, {14.5F, 8}, {10, 11.5F});
      return;
    case Icon::stop:
      pen.filledBox({4, 4}, {12, 12});
      return;
    case Icon::packet:  // a letter
      pen.box({2, 4}, {14, 12.5F}, 1);
      pen.line({{2.5F, 4.5F}, {8, 9}, {13.5F, 4.5F}});
      return;
  }
}

/// Its ground and its words; the corner is that of the button.
bool pressedGround(const char* id, float width, const char* words, bool chosen, ImVec2& corner) {
  corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(width, px(kSide));
  const bool pressed = ImGui::InvisibleButton(id, size);
  const bool held = chosen || ImGui::IsItemActive();
  const ImGuiCol ground = held                     ? ImGuiCol_ButtonActive
                          : ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered
                                                   : ImGuiCol_Button;
  ImGui::GetWindowDrawList()->AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y),
                                            ImGui::GetColorU32(ground), px(4));
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", words);
  return pressed;
}

}  // namespace

bool drawIconButton(const char* id, Icon icon, const char* words, bool chosen) {
  ImVec2 corner;
  const bool pressed = pressedGround(id, px(kSide), words, chosen, corner);
  const float inset = px((kSide - 16) / 2);
  drawIcon(icon, ImVec2(corner.x + inset, corner.y + inset), ImGui::GetColorU32(ImGuiCol_Text));
  return pressed;
}

bool drawTextButton(const char* id, const std::string& text, const char* words) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  // As wide for every text of its kind: what is beside it stays.
  const float width = std::max(px(34), size.x + px(8));
  ImVec2 corner;
  const bool pressed = pressedGround(id, width, words, false, corner);
  ImGui::GetWindowDrawList()->AddText(
      ImVec2(corner.x + (width - size.x) / 2, corner.y + (px(kSide) - size.y) / 2),
      ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  return pressed;
}

}  // namespace rocinante
