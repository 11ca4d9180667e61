#include "viewer/ui/panels/docks.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <filesystem>

#include "tests/viewer/support/arm_window.h"
#include "viewer/ui/commands/command.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/window/panel_style.h"
#include "viewer/ui/window/panel_texts.h"

namespace rocinante {
namespace {

/// A window with all panels round the arm's session, whose size the test says.
class Docks : public test::ArmWindow {
 protected:
  Docks() {
    test::writeArmSession(folder_ / "arm.mcap");
    show("arm.mcap");
  }
  void show(const char* log) {
    auto cell = loadCell(folder_ / "arm.urdf", {});
    auto session = Timeline::open(folder_ / log);
    model_ = std::make_unique<ViewModel>(
        ViewModel::make(std::move(cell.value()), std::move(session.value()), std::nullopt, {}, {})
            .value());
    EXPECT_TRUE(model_->update(now_).ok());
  }
  void frames(int count = 3) {
    for (int i = 0; i < count; ++i) {
      interface_.beginFrame(width_, height_, &input_);
      ViewerRequests requests;
      drawPanels(*model_, ViewerStatus(), now_, requests);
      ImGui::Render();
      input_.endFrame();
    }
  }
  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    frames();
  }
  /// `again`: as the second one of a double click.
  void click(double x, double y, bool again = false) {
    input_.mouse = {x, y};
    frames(again ? 1 : 30);  // longer than between the clicks of a double one
    input_.down[0] = true;
    input_.again = again;
    frames(1);
    input_.down[0] = false;
    frames(1);
  }
  void doubleClick(double x, double y) {
    click(x, y);
    click(x, y, true);
    frames();
  }
  DockLayout layout() {
    return dockLayoutOf(*model_, static_cast<float>(width_), static_cast<float>(height_), 1);
  }
  void fold(const std::string& words) {
    ViewerRequests requests;
    const auto split = splitWords(words);
    EXPECT_TRUE(runCommand("fold", split, {*model_, now_, height_, requests}).ok());
    frames();
  }
  bool says(const std::string& line) const {
    return std::ranges::count(model_->viewer.panels.lines, line) == 1;
  }
  PanelPlaces& places() { return model_->viewer.panels.places; }

  int width_ = 1280, height_ = 720;
};

TEST_F(Docks, ANoticeIsSeenBesideOrOverWhatIsLookedAt) {
  model_->viewer.panels.notes.push_back({"what went wrong", true});
  const auto seenAt = [&]() -> std::optional<PixelRectangle> {
    for (const PanelText& text : panelTexts(*ImGui::GetDrawData())) {
      if (text.text == "what went wrong" && !text.isCut()) return text.place;
    }
    return std::nullopt;
  };
  resize(560, 400);
  for (const char* const edge : {"left", "right"}) {
    places().peeked = edge;
    frames();
    const DockedSide side = edge == std::string("left") ? layout().left : layout().right;
    ASSERT_TRUE(side.peeked) << edge;
    const auto place = seenAt();
    ASSERT_TRUE(place.has_value()) << edge;
    const auto begin = static_cast<float>(place->x);
    const auto end = begin + static_cast<float>(place->width);
    EXPECT_TRUE(end < side.panel.x || begin > side.panel.x + side.panel.width) << edge;
  }
  // Over it, where a click on the panel leaves it, and below its tabs.
  resize(360, 300);
  ASSERT_TRUE(layout().right.peeked);
  ASSERT_TRUE(seenAt().has_value());
  EXPECT_GT(seenAt()->y, 100);
  click(layout().right.panel.x + 20, 30);
  frames();
  EXPECT_TRUE(seenAt().has_value());
}

TEST_F(Docks, ThePaletteHasOneScrollBarInASmallWindow) {
  resize(240, 160);
  model_->viewer.panels.palette.open("");
  frames();
  const ImGuiWindow* const palette = ImGui::FindWindowByName("palette");
  ASSERT_NE(palette, nullptr);
  EXPECT_FALSE(palette->ScrollbarY);
  EXPECT_LE(palette->Pos.y + palette->Size.y, 160);
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (window->ParentWindow == palette) {
      EXPECT_TRUE(window->ScrollbarY);
    }
  }
}

TEST_F(Docks, TheHelpHasOneScrollBarInASmallWindow) {
  for (const auto& [width, height] : {std::pair(240, 160), std::pair(320, 200)}) {
    resize(width, height);
    model_->viewer.panels.help_shown = true;
    frames();
    const ImGuiWindow* const help = ImGui::FindWindowByName("Mouse and keyboard");
    ASSERT_NE(help, nullptr);
    EXPECT_TRUE(help->ScrollbarY);
    EXPECT_FALSE(help->ScrollbarX);
    EXPECT_LE(help->ContentSize.x, help->Size.x - help->ScrollbarSizes.x);
  }
}

TEST_F(Docks, ASideOpenedByItsStripFoldsByTheNextDoubleClick) {
  places().places["left"].collapsed = true;
  frames();
  ASSERT_GT(layout().left.strip.width, 0);
  click(11, 300);
  frames();
  ASSERT_GT(layout().left.panel.width, 0);
  EXPECT_FALSE(layout().left.peeked);
  doubleClick(150, 560);
  EXPECT_TRUE(places().places["left"].collapsed);
  EXPECT_GT(layout().left.strip.width, 0);
}

TEST_F(Docks, WhatWasOpenedInALargeWindowYieldsInASmallOne) {
  places().places["left"].collapsed = places().places["bottom"].collapsed = true;
  frames();
  click(11, 300);
  frames();
  resize(480, 720);
  EXPECT_GT(layout().left.strip.width, 0);
  EXPECT_EQ(layout().left.panel.width, 0) << "it lies over the picture";
  resize(1280, 720);
  click(640, 710);
  frames();
  ASSERT_GT(layout().time.height, 0);
  resize(1280, 180);
  EXPECT_GT(layout().time_strip.height, 0);
}

TEST_F(Docks, WhatIsLookedAtStandsAtItsEdgeAsSoonAsThereIsRoom) {
  resize(480, 720);
  click(11, 300);
  frames();
  ASSERT_TRUE(layout().left.peeked);
  resize(1280, 720);
  EXPECT_GT(layout().left.panel.width, 0);
  resize(480, 720);
  EXPECT_FALSE(layout().left.peeked);
}

TEST_F(Docks, ASideThatIsLookedAtHasItsPanels) {
  resize(480, 320);
  click(11, 100);
  frames();
  const PanelRectangle left = layout().left.panel;
  ASSERT_TRUE(layout().left.peeked);
  const ImGuiWindow* const scene = ImGui::FindWindowByName("Scene");
  EXPECT_EQ(scene->Pos.x, left.x);
  EXPECT_EQ(scene->Size.x, left.width);
  EXPECT_EQ(scene->Size.y, left.height);
  click(11, 100);
  click(469, 100);
  frames();
  ASSERT_TRUE(layout().right.peeked);
  EXPECT_EQ(ImGui::FindWindowByName("figures")->Size.x, layout().right.panel.width);
}

TEST_F(Docks, WhatIsLookedAtHasTheMouseAndLiesOverTheGizmo) {
  resize(480, 720);
  click(469, 300);
  frames();
  const PanelRectangle right = layout().right.panel;
  ASSERT_TRUE(layout().right.peeked);
  // Where the device's panel would stand, and on the picture beside it.
  places().places["device"].moved = true;
  input_.mouse = {right.x + right.width / 2, right.y + right.height - 20};
  frames();
  EXPECT_EQ(ImGui::GetCurrentContext()->HoveredWindow, ImGui::FindWindowByName("right ground"));
  EXPECT_TRUE(ImGui::GetIO().WantCaptureMouse);
  // A click leaves it below them.
  click(input_.mouse->first, input_.mouse->second);
  input_.mouse = {right.x + 40, right.y + 20};
  frames();
  EXPECT_EQ(ImGui::GetCurrentContext()->HoveredWindow, ImGui::FindWindowByName("figures"));
  input_.mouse = {right.x - 60, right.y + 300};
  frames();
  EXPECT_FALSE(ImGui::GetIO().WantCaptureMouse);
  const ImVector<ImDrawVert>& behind = ImGui::GetBackgroundDrawList()->VtxBuffer;
  const int without = behind.Size;
  model_->selected = {"arm", ""};
  model_->viewer.gizmo.shown = true;
  frames();
  ASSERT_GT(behind.Size, without);
  // The last that is drawn is the ground of panels.
  EXPECT_EQ(behind.back().col, panelColor(PanelColor::panel));
}

TEST_F(Docks, TheCommandOpensASideForWhichThereIsNoRoom) {
  resize(480, 320);
  for (const auto& [edge, side] :
       {std::pair("left", &DockLayout::left), std::pair("right", &DockLayout::right)}) {
    SCOPED_TRACE(edge);
    const std::string name = edge;
    EXPECT_EQ((layout().*side).panel.width, 0);
    fold(name + " off");
    EXPECT_TRUE((layout().*side).peeked);
    EXPECT_GT((layout().*side).panel.width, 0);
    fold(name);
    EXPECT_EQ((layout().*side).panel.width, 0);
    fold(name);
    EXPECT_TRUE((layout().*side).peeked);
    fold(name + " on");
    EXPECT_EQ((layout().*side).panel.width, 0);
  }
  // One that yielded is opened at once.
  places().places.clear();
  frames();
  fold("left");
  EXPECT_TRUE(layout().left.peeked);
  resize(480, 180);
  EXPECT_EQ(layout().time.height, 0);
  fold("bottom off");
  EXPECT_GT(layout().time.height, 0);
  resize(1280, 720);
  fold("bottom");
  EXPECT_GT(layout().time_strip.height, 0);
  fold("bottom off");
  EXPECT_GT(layout().time.height, 0);
  EXPECT_TRUE(places().peeked.empty());
}

TEST_F(Docks, WhatFoldedFiguresWouldSayIsSaidOverThePicture) {
  const std::string behind = "live behind this: udp://127.0.0.1:19960";
  model_->viewer.panels.open.left = {"udp://127.0.0.1:19960"};
  ASSERT_TRUE(model_->showBeside(Timeline::open(folder_ / "arm.mcap").value(), "").ok());
  frames();
  EXPECT_FALSE(says(behind)) << "they are there";
  resize(800, 560);
  ASSERT_GT(layout().right.strip.width, 0);
  EXPECT_TRUE(says(behind));
  EXPECT_TRUE(says("beside: arm.mcap"));
  model_->viewer.panels.notices.dismissAll();
  frames();
  EXPECT_TRUE(says(behind));
  EXPECT_FALSE(says("beside: arm.mcap"));
  click(789, 300);
  frames();
  ASSERT_TRUE(layout().right.peeked);
  EXPECT_FALSE(says(behind));
  click(789, 300);
  frames();
  EXPECT_TRUE(says(behind));
  model_->viewer.panels.shown = false;
  frames();
  EXPECT_FALSE(says(behind));
}

TEST_F(Docks, ThatALogIsDamagedIsSaidWhateverIsFolded) {
  std::filesystem::resize_file(folder_ / "arm.mcap",
                               std::filesystem::file_size(folder_ / "arm.mcap") / 2);
  show("arm.mcap");
  ASSERT_EQ(model_->session()->log().damage().size(), 2U);
  resize(800, 560);
  EXPECT_TRUE(says("damaged in 2 places"));
  EXPECT_TRUE(says("rocinante log doctor says where, and what it cost"));
  resize(1280, 720);
  EXPECT_FALSE(says("damaged in 2 places"));
}

TEST_F(Docks, PlotsOpenedInALargeWindowYieldInASmallOne) {
  model_->viewer.plots.add(*parseSeriesKey("arm.turn"));
  model_->viewer.plots.hidden = true;
  frames();
  ASSERT_GT(layout().plots_strip.height, 0);
  click(640, static_cast<double>(layout().plots_strip.y) + 10);
  frames();
  ASSERT_GT(layout().plots.height, 0);
  resize(1280, 260);
  EXPECT_GT(layout().plots_strip.height, 0);
}

TEST_F(Docks, AStripClosesWhatTheUserFoldedAndATabAskedFor) {
  places().places["left"].collapsed = true;
  model_->viewer.panels.wanted_tab = "Look";
  frames();
  ASSERT_TRUE(layout().left.peeked);
  click(11, 300);
  frames();
  EXPECT_TRUE(places().places["left"].collapsed) << "it stands at its edge";
  EXPECT_EQ(layout().left.panel.width, 0);
  // So does the arrow of its gutter.
  model_->viewer.panels.wanted_tab = "Look";
  frames();
  const PanelRectangle gutter = layout().left.gutter;
  ASSERT_GT(gutter.width, 0);
  click(static_cast<double>(gutter.x) + 3, static_cast<double>(gutter.y + gutter.height / 2));
  frames();
  EXPECT_TRUE(places().places["left"].collapsed);
  EXPECT_EQ(layout().left.panel.width, 0);
}

TEST_F(Docks, ADoubleClickOnTheTimeLinesBackgroundFoldsIt) {
  frames();
  doubleClick(1000, 640);
  EXPECT_TRUE(places().places["bottom"].collapsed);
  EXPECT_GT(layout().time_strip.height, 0);
}

TEST_F(Docks, TwoClicksOnAButtonThatGoesAwayFoldNothing) {
  const LogTime start = model_->cursor()->start();
  model_->viewer.time_view.zoom(0.5, start);
  frames();
  ASSERT_FALSE(model_->viewer.time_view.showsAll());
  const ImGuiID all = ImGui::FindWindowByName("time")->GetID("all");
  double x = 0;
  while (x < 1280 && ImGui::GetCurrentContext()->HoveredId != all) {
    input_.mouse = {x += 8, 648.0};
    frames(1);
  }
  ASSERT_LT(x, 1280);
  click(x, 648);
  ASSERT_TRUE(model_->viewer.time_view.showsAll());
  click(x, 648, true);
  frames();
  EXPECT_GT(layout().time.height, 0);
  EXPECT_FALSE(places().places["bottom"].collapsed);
}

TEST_F(Docks, ATimeLineThatIsOnlyLookedAtIsBackInALargerWindow) {
  resize(1280, 180);
  ASSERT_GT(layout().time_strip.height, 0);
  click(640, 170);
  frames();
  ASSERT_GT(layout().time.height, 0);
  doubleClick(1000, 100);
  EXPECT_GT(layout().time_strip.height, 0);
  resize(1280, 720);
  EXPECT_GT(layout().time.height, 0);
}

}  // namespace
}  // namespace rocinante
