#include "viewer/ui/panels/panels.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>
#include <functional>

#include "tests/viewer/support/arm_window.h"
#include "viewer/ui/panels/picture_lines.h"
#include "viewer/ui/window/panel_texts.h"

namespace rocinante {
namespace {

/// Corners of all triangles of one frame of the panels.
int drawnCorners(ViewModel& model) {
  InterfaceContext interface(nullptr);
  ImGui::GetIO().Fonts->Build();
  ViewerRequests requests;
  for (int frame = 0; frame < 2; ++frame) {  // a window that fits itself is a frame late
    interface.beginFrame(1280, 720);
    drawPanels(model, ViewerStatus(), SteadyTime{}, requests);
    ImGui::Render();
  }
  return ImGui::GetDrawData()->TotalVtxCount;
}

TEST(Panels, OfTensOfThousandsOfEventsDrawWhatThereIsRoomFor) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  std::string many;
  for (int i = 0; i < 20'000; ++i) many += "event \"step\"\n";
  test::writeSession(folder / "s.mcap",
                     {{0, "event \"begun\"\n"}, {500, many}, {1000, "event \"x\"\n"}});
  auto cell = loadCell(folder / "arm.urdf", {});
  auto session = Timeline::open(folder / "s.mcap");
  ASSERT_TRUE(cell.ok() && session.ok());
  auto model = ViewModel::make(std::move(*cell), std::move(*session), std::nullopt, {}, {});
  ASSERT_TRUE(model.ok());
  ASSERT_TRUE(model->update(SteadyTime{}).ok());
  ASSERT_GT(model->events().size(), 15'000U);
  EXPECT_LT(drawnCorners(*model), 20'000);
}

TEST(Panels, SayWhyALogBesideIsNotCompared) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  for (const char* name : {"s.mcap", "part.mcap"}) test::writeArmSession(folder / name);
  std::filesystem::resize_file(folder / "part.mcap",
                               std::filesystem::file_size(folder / "part.mcap") - 20);
  auto cell = loadCell(folder / "arm.urdf", {});
  auto session = Timeline::open(folder / "s.mcap"), part = Timeline::open(folder / "part.mcap");
  ASSERT_TRUE(cell.ok() && session.ok() && part.ok());
  auto model = ViewModel::make(std::move(*cell), std::move(*session), std::nullopt, {}, {});
  ASSERT_TRUE(model.ok());
  ASSERT_TRUE(model->showBeside(std::move(*part), {}).has_value());
  ASSERT_TRUE(model->update(SteadyTime{}).ok());
  ASSERT_NE(model->partings(), nullptr);
  model->partings()->wait();
  InterfaceContext interface(nullptr);
  ImGui::GetIO().Fonts->Build();
  ViewerRequests requests;
  for (int frame = 0; frame < 4; ++frame) {
    interface.beginFrame(1280, 720);
    drawPanels(*model, ViewerStatus(), SteadyTime{}, requests);
    ImGui::Render();
  }
  std::string said;
  for (const PanelText& text : panelTexts(*ImGui::GetDrawData())) said += text.text + " ";
  EXPECT_NE(said.find("not compared: the log"), std::string::npos) << said;
  EXPECT_EQ(said.find(folder.path().string()), std::string::npos) << "its name is enough";
}

/// Of 1280x720; each frame has the panels that the test draws.
class DrawnPanels : public test::ArmWindow {
 protected:
  /// Frames with what `draw` draws, the last one with the left button down there.
  void frames(const std::function<void()>& draw,
              std::optional<std::pair<double, double>> clicked = {}) {
    FrameInput input;
    input.mouse = clicked;
    for (int frame = 0; frame < 4; ++frame) {
      input.down[0] = clicked && frame == 3;
      interface_.beginFrame(1280, 720, &input);
      draw();
      ImGui::Render();
    }
    input.down[0] = false;
    interface_.beginFrame(1280, 720, &input);
    ImGui::Render();
  }
};

TEST_F(DrawnPanels, ALineOverThePictureIsDismissedByAClick) {
  PanelState& panels = model_->viewer.panels;
  for (const char* text : {"one", "two", "three", "four", "five", "six"}) {
    panels.notes.push_back({text, true});
  }
  const PanelRectangle free{400, 100, 500, 400};
  const auto draw = [&] {
    drawPictureLines(*model_, pictureLines(*model_, ViewerStatus(), SteadyTime{}), {free});
  };
  frames(draw);
  // Those for which there is no room are said, too.
  ASSERT_EQ(panels.lines.size(), 7U);
  EXPECT_EQ(panels.lines[0], "one");
  EXPECT_EQ(panels.lines[1], "Esc dismisses it");
  EXPECT_EQ(panels.lines.back(), "six");
  frames(draw, std::pair(650.0, 110.0));
  ASSERT_EQ(panels.notes.size(), 5U);
  EXPECT_EQ(panels.notes.front().text, "two");
  frames(draw, std::pair(300.0, 110.0));  // beside them
  EXPECT_EQ(panels.notes.size(), 5U);
}

TEST_F(DrawnPanels, ALineWithoutRoomIsCutAndItsTipSaysTheWhole) {
  PanelState& panels = model_->viewer.panels;
  std::string text = "it begins here";
  for (int i = 0; i < 60; ++i) text += " and goes on";
  panels.notes.push_back({text + " to its end", true});
  const PanelRectangle free{400, 100, 300, 60};
  const auto draw = [&] {
    drawPictureLines(*model_, pictureLines(*model_, ViewerStatus(), SteadyTime{}), {free});
  };
  const auto said = [&](std::optional<std::pair<double, double>> mouse) {
    FrameInput input;
    input.mouse = mouse;
    for (int frame = 0; frame < 4; ++frame) {
      interface_.beginFrame(1280, 720, &input);
      draw();
      ImGui::Render();
    }
    std::string all;
    for (const PanelText& one : panelTexts(*ImGui::GetDrawData())) {
      EXPECT_FALSE(one.isCut()) << one.text;
      all += one.text + "\n";
    }
    return all;
  };
  const std::string line = said({});
  EXPECT_NE(line.find("it begins here"), std::string::npos) << line;
  EXPECT_NE(line.find("to its end"), std::string::npos) << line;
  const std::string hovered = said(std::pair(500.0, 120.0));
  EXPECT_GT(hovered.size(), text.size());
  EXPECT_NE(hovered.find("a click dismisses it"), std::string::npos) << hovered;
}

TEST_F(DrawnPanels, TheListOfDevicesOpensWhatWasSelectedInThePicture) {
  PanelState& panels = model_->viewer.panels;
  ViewerRequests requests;
  const auto draw = [&] {
    ImGui::Begin("list");
    drawSceneTab(*model_, 600, requests);
    ImGui::End();
  };
  frames(draw);
  EXPECT_TRUE(panels.open_devices.empty());
  std::string("leg").copy(panels.device_filter.data(), 3);
  model_->selected = {"arm", "hand"};
  frames(draw);
  EXPECT_TRUE(panels.open_devices.contains("arm"));
  EXPECT_EQ(panels.device_filter[0], 0);
  // What the user closes then stays closed.
  panels.open_devices.clear();
  frames(draw);
  EXPECT_TRUE(panels.open_devices.empty());
}

TEST(Panels, ListLiveSessionsBehindWhatIsShownAndWhatIsHeard) {
  auto model = ViewModel::make(Cell(), std::nullopt, std::nullopt, {}, {});
  ASSERT_TRUE(model.ok());
  EXPECT_TRUE(endpointLines(*model).empty()) << "nobody listened around";
  const std::string usual = Endpoint::standard().text();
  model->viewer.panels.open.left = {usual};
  ASSERT_EQ(endpointLines(*model).size(), 1U);
  EXPECT_EQ(endpointLines(*model)[0].note, "goes on behind this");
  model->listenAround();
  const auto lines = endpointLines(*model);
  ASSERT_EQ(lines.size(), 2U) << "each once";
  EXPECT_EQ(lines[0].endpoints, usual);
  EXPECT_EQ(lines[1].endpoints, "udp://0.0.0.0:19960");
  model->viewer.is_empty = true;
  EXPECT_GT(drawnCorners(*model), 100);
}

}  // namespace
}  // namespace rocinante
