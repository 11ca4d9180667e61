#include "viewer/ui/panels/panels.h"

#include <algorithm>

#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/picture_lines.h"
#include "viewer/ui/panels/placed_panel.h"

namespace rocinante {
namespace {

void drawScenePanel(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                    ViewerRequests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const float below = px(model.cursor() != nullptr ? kTimeBarHeight : kPanelMargin) +
                      plotsHeight(model, io.DisplaySize.y);
  const float tallest = std::max(px(120), io.DisplaySize.y - px(kPanelMargin) - below);
  PlacedPanel placed(model.viewer.panels.places, "Scene",
                     ImVec2(px(kPanelMargin), px(kPanelMargin)), ImVec2(0, 0),
                     px(scenePanelWidth(model.isLive())), tallest);
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
      model.viewer.panels.help_shown = !model.viewer.panels.help_shown;
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

}  // namespace

CoveredEdges drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                        ViewerRequests& requests) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  FreeMiddle middle{0, size.x};
  CoveredEdges covered;
  float right_end = 0;
  model.viewer.hover.wanted.reset();
  if (model.viewer.is_empty) drawWelcome(model, status.loading.has_value(), requests);
  if (model.viewer.panels.shown && !model.viewer.is_empty) {
    const float unit = px(1);
    const float plots = plotsHeight(model, size.y);
    const PanelLayout layout =
        panelLayout(size.x / unit, (size.y - plots) / unit, model.isLive(),
                    model.cursor() != nullptr, !model.inspected().device.empty());
    if (layout.scene) {
      drawScenePanel(model, status, now, requests);
      middle.left = coveredAtLeft(model.viewer.panels.places,
                                  px(scenePanelWidth(model.isLive()) + kPanelMargin));
    }
    if (layout.figures != PanelLayout::Figures::none) {
      const bool brief = layout.figures == PanelLayout::Figures::brief;
      right_end = drawFigures(model, status, now, brief, model.viewer.panels.places);
      middle.right = size.x - px(brief ? 150 : 270);
      if (isMoved(model.viewer.panels.places, "figures")) {
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
        if (!isMoved(model.viewer.panels.places, "device")) {
          middle.right = std::min(middle.right, size.x - static_cast<float>(covered.right));
        }
      }
    }
    if (TimelineCursor* cursor = model.cursor()) {
      if (cursor->playing()) model.viewer.time_view.follow(cursor->position(now));
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
  if (status.loading) drawLoading(*status.loading, model.viewer.is_empty);
  const float bottom = size.y - static_cast<float>(covered.bottom);
  drawPictureLines(pictureLines(model, status, now), middle, right_end, bottom,
                   model.viewer.panels.lines);
  drawDriveFrame(model);
  if (model.viewer.panels.asks_mark) drawMarkPrompt(model, requests);
  if (model.viewer.panels.help_shown) drawHelp(model);
  if (model.viewer.panels.open.shown) drawOpenList(model, requests);
  if (model.viewer.panels.palette.shown) drawPalette(model, now, requests);
  return covered;
}

}  // namespace rocinante
