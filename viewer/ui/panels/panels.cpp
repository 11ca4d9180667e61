#include "viewer/ui/panels/panels.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/panels/docks.h"
#include "viewer/ui/panels/gizmo_panel.h"
#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/picture_lines.h"
#include "viewer/ui/panels/placed_panel.h"
#include "viewer/ui/panels/view_cube_panel.h"

namespace rocinante {
namespace {

/// The row of tabs, which ends before the button for help.
bool beginTabs(ViewModel& model) {
  const ImVec2 begin = ImGui::GetCursorPos();
  const float size = ImGui::GetTextLineHeight() + px(4);
  ImGui::SetCursorPosX(begin.x + ImGui::GetContentRegionAvail().x - size);
  drawHelpButton(model);
  ImGui::SetCursorPos(begin);
  float& right = ImGui::GetCurrentWindow()->WorkRect.Max.x;
  const float whole = std::exchange(right, right - size - px(6));
  // Six names stand beside each other in a narrow panel.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, ImVec2(px(2), px(4)));
  const bool open = ImGui::BeginTabBar("tabs");
  ImGui::PopStyleVar();
  right = whole;
  return open;
}

void drawScenePanel(ViewModel& model, const ViewerStatus& status, const PanelRectangle& room,
                    SteadyTime now, ViewerRequests& requests) {
  PlacedPanel placed(model.viewer.panels.places, "Scene", {DockEdge::left, room},
                     px(scenePanelWidth(model.isLive())));
  if (!placed.begin()) return;
  if (placed.collapsed()) {
    drawCollapsed("Scene");
  } else if (beginTabs(model)) {
    const auto begin = [tab = std::exchange(model.viewer.panels.wanted_tab, {})](const char* name) {
      return ImGui::BeginTabItem(name, nullptr, tab == name ? ImGuiTabItemFlags_SetSelected : 0);
    };
    if (begin("Scene")) {
      drawSceneTab(model, placed.bottom(), requests);
      ImGui::EndTabItem();
    }
    if (begin("Look")) {
      drawLookTab(model);
      ImGui::EndTabItem();
    }
    if (model.isLive() && begin("Sources")) {
      drawSourcesTab(model, now);
      ImGui::EndTabItem();
    }
    if (model.cursor() != nullptr && begin("Events")) {
      drawEventsTab(model, now, requests);
      ImGui::EndTabItem();
    }
    if (model.cursor() != nullptr && begin("Check")) {
      drawFindingsTab(model, now);
      ImGui::EndTabItem();
    }
    if (begin("Frame")) {
      drawFrameTab(status, requests);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  placed.end();
}

/// Figures and selection, one below the other.
void drawRightPanels(ViewModel& model, const ViewerStatus& status, const PanelRectangle& room,
                     SteadyTime now) {
  const float top = drawFigures(model, status, now, room);
  PanelRectangle below = room;
  below.y = top;
  below.height = std::max(1.0F, room.y + room.height - top);
  drawDevicePanel(model, below, now);
}

/// Plots and time line, on one axis.
void drawTimePanels(ViewModel& model, const DockLayout& layout, SteadyTime now) {
  TimelineCursor* const cursor = model.cursor();
  if (cursor == nullptr) return;
  if (cursor->playing()) model.viewer.time_view.follow(cursor->position(now));
  const TimeAxis axis = timeAxis(model, ImGui::GetIO().DisplaySize.x);
  askStudy(model, axis);
  if (layout.time.height > 0) {
    drawTimeBar(model, *cursor, axis, layout.time, now);
  } else {
    model.viewer.panels.time.shown = false;  // a line that comes back asks for nothing
  }
  if (layout.plots.height > 0) drawPlots(model, *cursor, axis, layout.plots, now);
  drawPlotDrag(model, layout.picture.y + layout.picture.height);
}

/// The part of the picture between the panels that are looked at over it, from its own left.
std::pair<float, float> uncovered(const DockLayout& layout) {
  const PanelRectangle& picture = layout.picture;
  const DockedSide &left = layout.left, &right = layout.right;
  const float from = left.peeked ? left.gutter.x + left.gutter.width - picture.x : 0;
  const float until = right.peeked ? right.gutter.x - picture.x : picture.width;
  return {std::max(0.0F, from), std::min(picture.width, until)};
}

/// Where lines over the picture stand: between its upper insets and the cube, or below them where
/// that is too narrow. Beside what is looked at over the picture, or over its lower half, below its
/// tabs, where there is no room beside it.
NoticeRoom noticeRoom(ViewModel& model, const DockLayout& layout) {
  constexpr float kLeastNoticeWidth = 240, kLeastBesidePanel = 140;
  const PanelRectangle& picture = layout.picture;
  const float margin = px(kPanelMargin);
  const auto [from, until] = uncovered(layout);
  if (until - from < std::min(px(kLeastBesidePanel), picture.width)) {
    return {
        {picture.x + margin, picture.y + picture.height / 2,
         std::max(0.0F, picture.width - 2 * margin), std::max(0.0F, picture.height / 2 - margin)},
        true};
  }
  float left = from + margin, right = until - margin, below = margin;
  std::vector<PixelRectangle> taken;
  for (const InsetPlace& inset : model.viewer.inset_places) taken.push_back(inset.part);
  if (auto cube = viewCubePlace(model, picture)) {
    cube->x -= static_cast<int>(picture.x);
    cube->y -= static_cast<int>(picture.y);
    taken.push_back(*cube);
  }
  for (const PixelRectangle& part : taken) {
    if (static_cast<float>(part.y) > picture.height / 2) continue;
    const auto begin = static_cast<float>(part.x), end = begin + static_cast<float>(part.width);
    if (begin + end < picture.width) {
      left = std::max(left, end + margin);
    } else {
      right = std::min(right, begin - margin);
    }
    below = std::max(below, static_cast<float>(part.y + part.height) + margin);
  }
  float top = margin;
  if (right - left < px(kLeastNoticeWidth)) {
    left = from + margin;
    right = until - margin;
    top = below;
  }
  return {{picture.x + left, picture.y + top, std::max(0.0F, right - left),
           std::max(0.0F, picture.height - top - margin)}};
}

}  // namespace

PixelRectangle drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                          ViewerRequests& requests) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  model.viewer.hover.wanted.reset();
  PanelState& panels = model.viewer.panels;
  notePress(panels.places);
  endNeedlessPeek(model, size.x, size.y, px(1));
  DockLayout layout = dockLayoutOf(model, size.x, size.y, px(1));
  if (!panels.wanted_tab.empty() && layout.left.strip.width > 0 && !layout.left.peeked) {
    panels.places.peeked = nameOf(DockEdge::left);
    layout = dockLayoutOf(model, size.x, size.y, px(1));
  }
  const PixelRectangle part = model.viewer.picture_part = picturePart(layout);
  replaceInsets(model, part.width, part.height, px(1));
  if (model.viewer.is_empty) drawWelcome(model, status.loading.has_value(), requests);
  drawGizmo(model);  // below what is opened over the picture
  if (model.viewer.panels.shown && !model.viewer.is_empty) {
    drawDocks(model, layout);
    drawScenePanel(model, status, layout.left.panel, now, requests);
    drawRightPanels(model, status, layout.right.panel, now);
    drawTimePanels(model, layout, now);
    drawViewCube(model, layout.picture);
  }
  drawInsetTabs(model);
  drawInsetGrip(model);
  if (status.loading) drawLoading(*status.loading, model.viewer.is_empty);
  drawPictureLines(model, pictureLines(model, status, now), noticeRoom(model, layout));
  drawDriveFrame(model);
  if (model.viewer.panels.mark.shown) drawMarkPrompt(model, requests);
  if (model.viewer.panels.help_shown) drawHelp(model);
  if (model.viewer.panels.open.shown) drawOpenList(model, requests);
  if (model.viewer.panels.palette.shown) drawPalette(model, now, requests);
  return part;
}

}  // namespace rocinante
