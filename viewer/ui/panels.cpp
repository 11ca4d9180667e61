#include "viewer/ui/panels.h"

#include <algorithm>

#include "viewer/ui/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kTimeBarHeight = 62;

void drawScenePanel(ViewModel& model, SteadyTime now, ViewerWishes& wishes) {
  const ImGuiIO& io = ImGui::GetIO();
  const float below = model.transport() != nullptr ? kTimeBarHeight : kPanelMargin;
  const float tallest = std::max(120.0F, io.DisplaySize.y - kPanelMargin - below);
  ImGui::SetNextWindowPos(ImVec2(kPanelMargin, kPanelMargin));
  ImGui::SetNextWindowSizeConstraints(ImVec2(kScenePanelWidth, 0),
                                      ImVec2(kScenePanelWidth, tallest));
  ImGui::Begin("Scene", nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
  if (ImGui::BeginTabBar("tabs")) {
    if (ImGui::BeginTabItem("Scene")) {
      drawSceneTab(model, wishes);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Look")) {
      drawLookTab(model);
      ImGui::EndTabItem();
    }
    if (model.transport() != nullptr && ImGui::BeginTabItem("Events")) {
      drawEventsTab(model, now, wishes);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

/// A line or two over the picture, in its middle at the top.
void drawBanner(const char* name, float top, const ImVec4& color, const std::string& what,
                const std::string& hint) {
  const ImGuiIO& io = ImGui::GetIO();
  const float room = std::max(200.0F, std::min(560.0F, io.DisplaySize.x - 40));
  ImGui::SetNextWindowPos(ImVec2(io.DisplaySize.x / 2, top), ImGuiCond_Always, ImVec2(0.5F, 0));
  ImGui::Begin(name, nullptr,
               kPanelFlags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoInputs);
  ImGui::PushTextWrapPos(room);
  ImGui::TextColored(color, "%s", what.c_str());
  if (!hint.empty()) ImGui::TextDisabled("%s", hint.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

void drawBanners(const ViewModel& model, const ViewerStatus& status, SteadyTime now) {
  const ImVec4 fault(1, 0.6F, 0.4F, 1);
  const float middle = ImGui::GetIO().DisplaySize.y * 0.3F;
  if (const auto reason = model.liveReason(now)) {
    drawBanner("reason", middle, fault, reason->what, reason->hint);
  }
  if (!model.complaint.empty()) drawBanner("complaint", kPanelMargin, fault, model.complaint, "");
  if (!status.notice.empty()) {
    drawBanner("notice", kPanelMargin + 44,
               status.notice_is_fault ? fault : ImVec4(0.7F, 0.9F, 0.75F, 1), status.notice, "");
  }
}

}  // namespace

void stylePanels() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.ChildRounding = 4;
  style.TabRounding = 4;
  style.WindowBorderSize = 0;
  style.WindowPadding = ImVec2(12, 10);
  style.ItemSpacing = ImVec2(8, 6);
  style.IndentSpacing = 18;
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09F, 0.11F, 0.13F, 0.86F);
  style.Colors[ImGuiCol_PopupBg] = ImVec4(0.09F, 0.11F, 0.13F, 0.95F);
  style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_TitleBg] =
      ImVec4(0.13F, 0.16F, 0.19F, 0.95F);
  style.Colors[ImGuiCol_Header] = ImVec4(0.22F, 0.30F, 0.38F, 0.8F);
  style.Colors[ImGuiCol_Button] = ImVec4(0.22F, 0.30F, 0.38F, 1.0F);
  style.Colors[ImGuiCol_FrameBg] = ImVec4(0.25F, 0.31F, 0.37F, 1.0F);
  style.Colors[ImGuiCol_Tab] = ImVec4(0.16F, 0.20F, 0.24F, 1.0F);
  style.Colors[ImGuiCol_TabActive] = ImVec4(0.30F, 0.40F, 0.50F, 1.0F);
  style.Colors[ImGuiCol_TabHovered] = ImVec4(0.34F, 0.46F, 0.58F, 1.0F);
  style.Colors[ImGuiCol_CheckMark] = ImVec4(1.0F, 0.66F, 0.25F, 1.0F);
  style.Colors[ImGuiCol_SliderGrab] = ImVec4(1.0F, 0.66F, 0.25F, 1.0F);
}

CoveredEdges drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                        ViewerWishes& wishes) {
  drawBanners(model, status, now);
  if (model.help_shown) drawHelp(model);
  if (!model.panels_shown) return {};
  CoveredEdges covered;
  covered.left = static_cast<int>(kScenePanelWidth + kPanelMargin);
  drawScenePanel(model, now, wishes);
  const float figures_end = drawFigures(model, status, wishes);
  const float right_end = drawDevicePanel(model, figures_end + kPanelMargin);
  covered.right_top = static_cast<int>(std::max(figures_end, right_end));
  if (Transport* transport = model.transport()) {
    drawTimeBar(model, *transport, now);
    covered.bottom = static_cast<int>(kTimeBarHeight - kPanelMargin);
  }
  return covered;
}

}  // namespace rocinante
