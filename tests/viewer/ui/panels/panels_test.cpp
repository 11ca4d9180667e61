#include "viewer/ui/panels/panels.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/window/interface_context.h"

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

}  // namespace
}  // namespace rocinante
