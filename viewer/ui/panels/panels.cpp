#include "viewer/ui/panels/panels.h"

#include <algorithm>

#include "viewer/ui/panels/device_panel.h"
#include "viewer/ui/panels/figures_panel.h"
#include "viewer/ui/panels/help_panel.h"
#include "viewer/ui/panels/look_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/scene_panel.h"
#include "viewer/ui/panels/sources_panel.h"
#include "viewer/ui/panels/time_bar.h"

namespace rocinante {
namespace {

void drawScenePanel(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                    ViewerRequests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const float below = px(model.cursor() != nullptr ? kTimeBarHeight : kPanelMargin);
  const float tallest = std::max(px(120), io.DisplaySize.y - px(kPanelMargin) - below);
  ImGui::SetNextWindowPos(ImVec2(px(kPanelMargin), px(kPanelMargin)));
  ImGui::SetNextWindowSizeConstraints(ImVec2(px(kScenePanelWidth), 0),
                                      ImVec2(px(kScenePanelWidth), tallest));
  ImGui::Begin("Scene", nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
  if (ImGui::BeginTabBar("tabs")) {
    if (ImGui::BeginTabItem("Scene")) {
      drawSceneTab(model, px(kPanelMargin) + tallest, requests);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Look")) {
      drawLookTab(model);
      ImGui::EndTabItem();
    }
    if (model.isLive() && ImGui::BeginTabItem("Sources")) {
      drawSourcesTab(model, now);
      ImGui::EndTabItem();
    }
    if (model.cursor() != nullptr && ImGui::BeginTabItem("Events")) {
      drawEventsTab(model, now, requests);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Frame")) {
      drawFrameTab(status, requests);
      ImGui::EndTabItem();
    }
    if (ImGui::TabItemButton("?", ImGuiTabItemFlags_Trailing)) model.help_shown = !model.help_shown;
    explain("mouse and keyboard (F1)");
    ImGui::EndTabBar();
  }
  ImGui::End();
}

/// The part of the window between the panels at its sides.
struct Middle {
  float left = 0, right = 0;
};

/// Draws a line or two over the picture; returns their bottom. Computes its size here, because an
/// auto-sized window is one frame late.
float drawBanner(const char* name, const Middle& middle, float top, const ImVec4& color,
                 const std::string& what, const std::string& hint) {
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float room =
      std::max(px(160), std::min(px(560), middle.right - middle.left - px(2 * kPanelMargin)));
  const float wrap = room - 2 * padding.x;
  const ImVec2 said = ImGui::CalcTextSize(what.c_str(), nullptr, false, wrap);
  ImVec2 size(said.x, said.y);
  if (!hint.empty()) {
    const ImVec2 more = ImGui::CalcTextSize(hint.c_str(), nullptr, false, wrap);
    size.x = std::max(size.x, more.x);
    size.y += more.y + ImGui::GetStyle().ItemSpacing.y;
  }
  size.x += 2 * padding.x + 1;
  size.y += 2 * padding.y;
  ImGui::SetNextWindowPos(ImVec2((middle.left + middle.right) / 2, top), ImGuiCond_Always,
                          ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(size);
  ImGui::Begin(name, nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
  ImGui::PushTextWrapPos(padding.x + wrap);
  ImGui::TextColored(color, "%s", what.c_str());
  if (!hint.empty()) ImGui::TextDisabled("%s", hint.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  return top + size.y + px(6);
}

void drawBanners(const ViewModel& model, const ViewerStatus& status, const Middle& middle,
                 SteadyTime now) {
  const ImVec4 fault(1, 0.6F, 0.4F, 1);
  float top = px(kPanelMargin);
  if (const auto reason = model.liveReason(now)) {
    // Keep the last picture visible; without any data, show the reason in the centre.
    const bool nothing_yet = model.live() == nullptr || model.live()->datagrams == 0;
    const float at = nothing_yet ? ImGui::GetIO().DisplaySize.y * 0.3F : top;
    const float end = drawBanner("reason", middle, at, fault, reason->what, reason->hint);
    if (!nothing_yet) top = end;
  }
  if (!model.damage().empty()) {
    top = drawBanner("damage", middle, top, fault, model.damage().what(),
                     "what is shown may be older than its time says");
  }
  if (!model.complaint.empty()) {
    top = drawBanner("complaint", middle, top, fault, model.complaint, "");
  }
  if (!status.notice.empty()) {
    drawBanner("notice", middle, top, status.notice_is_fault ? fault : ImVec4(0.7F, 0.9F, 0.75F, 1),
               status.notice, "");
  }
}

}  // namespace

CoveredEdges drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                        ViewerRequests& requests) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  Middle middle{0, size.x};
  CoveredEdges covered;
  if (model.panels_shown) {
    const float unit = px(1);
    const PanelLayout layout = panelLayout(size.x / unit, size.y / unit, model.cursor() != nullptr,
                                           !model.selected.device.empty());
    if (layout.scene) {
      drawScenePanel(model, status, now, requests);
      middle.left = px(kScenePanelWidth + kPanelMargin);
    }
    float right_end = 0;
    if (layout.figures != PanelLayout::Figures::none) {
      const bool brief = layout.figures == PanelLayout::Figures::brief;
      right_end = drawFigures(model, status, now, brief);
      middle.right = size.x - px(brief ? 150 : 270);
    }
    covered.right = static_cast<int>(size.x - middle.right);
    if (layout.device) {
      const float end = drawDevicePanel(model, right_end + px(kPanelMargin));
      if (end > right_end + px(kPanelMargin)) {
        right_end = end;
        covered.right =
            std::max(covered.right, static_cast<int>(px(kDevicePanelWidth + kPanelMargin)));
      }
    }
    if (TimelineCursor* cursor = model.cursor()) {
      drawTimeBar(model, *cursor, now);
      covered.bottom = static_cast<int>(px(kTimeBarHeight - kPanelMargin));
    }
    covered.left = static_cast<int>(middle.left);
    covered.right_top = static_cast<int>(right_end);
  }
  drawBanners(model, status, middle, now);
  if (model.help_shown) drawHelp(model);
  return covered;
}

}  // namespace rocinante
