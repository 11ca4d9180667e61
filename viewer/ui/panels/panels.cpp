#include "viewer/ui/panels/panels.h"

#include <algorithm>

#include "viewer/ui/panels/device_panel.h"
#include "viewer/ui/panels/figures_panel.h"
#include "viewer/ui/panels/findings_tab.h"
#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/help_panel.h"
#include "viewer/ui/panels/inset_grip.h"
#include "viewer/ui/panels/look_panel.h"
#include "viewer/ui/panels/mark_prompt.h"
#include "viewer/ui/panels/open_panel.h"
#include "viewer/ui/panels/others_panel.h"
#include "viewer/ui/panels/palette_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/placed_panel.h"
#include "viewer/ui/panels/plot_panel.h"
#include "viewer/ui/panels/scene_panel.h"
#include "viewer/ui/panels/sources_panel.h"
#include "viewer/ui/panels/time_bar.h"
#include "viewer/ui/panels/welcome_panel.h"

namespace rocinante {
namespace {

void drawScenePanel(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                    ViewerRequests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const float below = px(model.cursor() != nullptr ? kTimeBarHeight : kPanelMargin) +
                      plotsHeight(model, io.DisplaySize.y);
  const float tallest = std::max(px(120), io.DisplaySize.y - px(kPanelMargin) - below);
  PlacedPanel placed(model.panels.places, "Scene", ImVec2(px(kPanelMargin), px(kPanelMargin)),
                     ImVec2(0, 0), px(kScenePanelWidth), tallest);
  ImGui::Begin("Scene", nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
  if (placed.collapsed()) {
    drawCollapsed("Scene");
  } else if (ImGui::BeginTabBar("tabs")) {
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
    if (model.cursor() != nullptr && ImGui::BeginTabItem("Check")) {
      drawFindingsTab(model, now);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Frame")) {
      drawFrameTab(status, requests);
      ImGui::EndTabItem();
    }
    if (ImGui::TabItemButton("?", ImGuiTabItemFlags_Trailing))
      model.panels.help_shown = !model.panels.help_shown;
    explain("mouse and keyboard (F1)");
    ImGui::EndTabBar();
  }
  placed.follow();
  ImGui::End();
}

bool isMoved(const PanelPlaces& places, const char* panel) {
  const PanelPlace* const place = places.find(panel);
  return place != nullptr && place->moved;
}

/// How much of the picture's left the scene panel covers: nothing when it was moved away.
float coveredAtLeft(const PanelPlaces& places, float usual) {
  const PanelPlace* const place = places.find("Scene");
  if (place == nullptr) return usual;
  if (place->moved && (place->from_right || place->across > 2 * kPanelMargin)) return 0;
  const auto drawn = places.drawn.find("Scene");
  return drawn == places.drawn.end() ? usual : drawn->second.x + drawn->second.width;
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
  ImGui::TextColored(ink(color), "%s", what.c_str());
  if (!hint.empty()) ImGui::TextDisabled("%s", hint.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  return top + size.y + px(6);
}

/// Between the panels at the sides; below those at the right where a narrow window leaves no room.
float placeBanners(Middle& middle, float right_end, float bottom) {
  constexpr float kLeastRoom = 240;
  constexpr float kLeastHeight = 60;
  const float below = right_end + px(kPanelMargin);
  const float top = px(kPanelMargin);
  if (middle.right - middle.left >= px(kLeastRoom) || bottom - below < px(kLeastHeight)) return top;
  middle.right = ImGui::GetIO().DisplaySize.x;
  return below;
}

void drawBanners(const ViewModel& model, const ViewerStatus& status, const Middle& middle,
                 float top, SteadyTime now) {
  const ImVec4 fault(1, 0.6F, 0.4F, 1);
  if (const auto reason = model.liveReason(now)) {
    // Keep the last picture visible; without any data, show the reason in the centre.
    const bool nothing_yet = model.live() == nullptr || model.live()->datagrams == 0;
    const float at = nothing_yet ? std::max(top, ImGui::GetIO().DisplaySize.y * 0.3F) : top;
    const float end = drawBanner("reason", middle, at, fault, reason->text, reason->hint);
    if (!nothing_yet) top = end;
  }
  if (!model.damage().empty()) {
    top = drawBanner("damage", middle, top, fault, model.damage().what(),
                     "what is shown may be older than its time says");
  }
  if (const HandBanner hand = handBanner(model); !hand.what.empty()) {
    top = drawBanner("hand", middle, top, hand.color, hand.what, hand.hint);
  }
  if (const OthersBanner others = othersBanner(model); !others.what.empty()) {
    top = drawBanner("others", middle, top, others.is_fault ? fault : ImVec4(0.6F, 0.85F, 1, 1),
                     others.what, others.hint);
  }
  if (model.picking.active()) {
    top = drawBanner(
        "picking", middle, top, ImVec4(1.0F, 0.85F, 0.3F, 1),
        model.picking.first() ? "click the second point" : "click two points: their distance",
        "Esc ends it");
  }
  if (!model.keepingTrouble().empty()) {
    top = drawBanner("kept", middle, top, fault, model.keepingTrouble(), "");
  }
  if (!model.panels.complaint.empty()) {
    top = drawBanner("complaint", middle, top, fault, model.panels.complaint, "");
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
  float right_end = 0;
  model.hover.wanted.reset();
  if (model.is_empty) drawWelcome(model, status.loading.has_value(), requests);
  if (model.panels.shown && !model.is_empty) {
    const float unit = px(1);
    const float plots = plotsHeight(model, size.y);
    const PanelLayout layout =
        panelLayout(size.x / unit, (size.y - plots) / unit, model.cursor() != nullptr,
                    !model.inspected().device.empty());
    if (layout.scene) {
      drawScenePanel(model, status, now, requests);
      middle.left = coveredAtLeft(model.panels.places, px(kScenePanelWidth + kPanelMargin));
    }
    if (layout.figures != PanelLayout::Figures::none) {
      const bool brief = layout.figures == PanelLayout::Figures::brief;
      right_end = drawFigures(model, status, now, brief, model.panels.places);
      middle.right = size.x - px(brief ? 150 : 270);
      if (isMoved(model.panels.places, "figures")) {
        middle.right = size.x;
        right_end = 0;
      }
    }
    covered.right = static_cast<int>(size.x - middle.right);
    if (layout.device) {
      const float end = drawDevicePanel(model, right_end + px(kPanelMargin), now);
      if (end > right_end + px(kPanelMargin)) {
        right_end = end;
        covered.right =
            std::max(covered.right, static_cast<int>(px(kDevicePanelWidth + kPanelMargin)));
      }
    }
    if (TimelineCursor* cursor = model.cursor()) {
      if (cursor->playing()) model.time_view.follow(cursor->position(now));
      const TimeAxis axis = timeAxis(model, size.x);
      askStudy(model, axis);
      drawTimeBar(model, *cursor, axis, now);
      if (plots > 0)
        drawPlots(model, *cursor, axis, size.y - px(kTimeBarHeight) + px(kPanelMargin) / 2, now);
      drawPlotDrag(model);
      covered.bottom = static_cast<int>(px(kTimeBarHeight - kPanelMargin) + plots);
    }
    covered.left = static_cast<int>(middle.left);
    covered.right_top = static_cast<int>(right_end);
  }
  drawInsetGrip(model);
  if (status.loading) drawLoading(*status.loading, model.is_empty);
  const float bottom = size.y - static_cast<float>(covered.bottom);
  const float banners_top = placeBanners(middle, right_end, bottom);
  drawBanners(model, status, middle, banners_top, now);
  if (model.panels.asks_mark) drawMarkPrompt(model, requests);
  if (model.panels.help_shown) drawHelp(model);
  if (model.panels.open.shown) drawOpenList(model, requests);
  if (model.panels.palette.shown) drawPalette(model, now, requests);
  return covered;
}

}  // namespace rocinante
