// What the cameras show that every cell has, and which insets a picture of them keeps.
#include "viewer/render/fitted_cameras.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/transform.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"
#include "tests/viewer/render/test_maker.h"
#include "viewer/program/render_job.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

class FitTest : public test::MakerTest {
 protected:
  void SetUp() override {
    MakerTest::SetUp();
    test::writeText(folder_ / "hall.urdf",
                    "<robot name=\"hall\"><link name=\"walls\"><visual><geometry>"
                    "<box size=\"60 40 12\"/></geometry></visual></link></robot>");
    test::writeText(folder_ / "pallet.urdf",
                    "<robot name=\"pallet\"><link name=\"wood\"><visual><geometry>"
                    "<box size=\"1 1 0.2\"/></geometry></visual></link></robot>");
  }

  static CameraView cameraOf(FrameMaker& maker, const std::string& name,
                             const std::vector<std::string>& hide = {}) {
    FrameRequest request = requestAt(1000);
    request.camera = name;
    request.hide = hide;
    const auto view = maker.camera(request);
    EXPECT_TRUE(view.has_value()) << (view ? "" : view.error().text());
    return view ? *view : CameraView{};
  }
  static std::string refusalOf(FrameMaker& maker, const std::string& name,
                               const std::vector<std::string>& hide = {}) {
    FrameRequest request = requestAt(1000);
    request.camera = name;
    request.hide = hide;
    const auto view = maker.camera(request);
    return view ? "" : view.error().text();
  }
  static DeviceNames movable(const std::filesystem::path& file, const std::string& statements) {
    auto cell = loadCell(file, {});
    EXPECT_TRUE(cell.has_value());
    SessionState said;
    const std::string text = "RK1 robot 1 -\n" + statements;
    const auto decoder = makeDecoder("rk1");
    const Packet* packet = decoder->decode(bytesOf(text));
    EXPECT_NE(packet, nullptr);
    if (packet != nullptr) said.apply(test::sessionTime(0), *packet);
    DeviceNames names;
    addMovableDevices(*cell, poseScene(*cell, SessionState{}), poseScene(*cell, said), names);
    return names;
  }
};

constexpr const char* kHall = "[[device]]\nname = \"hall\"\nmodel = \"hall.urdf\"\n";

TEST_F(FitTest, TheBuildingAroundARobotIsNotFramed) {
  FrameMaker bare = open("x-none = 1\n");
  const CameraView alone = cameraOf(bare, "fit");
  FrameMaker maker = open(kHall);
  EXPECT_EQ(cameraOf(maker, "fit"), alone);
  EXPECT_EQ(cameraOf(maker, ""), alone) << "the camera of a cell without cameras";
  EXPECT_EQ(cameraOf(maker, "fit:arm"), alone);
  // The map and the hall's own are of the hall.
  EXPECT_GT(cameraOf(maker, "map").ortho_height_m.value(), 40);
  EXPECT_GT(lengthOf(cameraOf(maker, "fit:hall").eye), 40);
}

TEST_F(FitTest, WhereNothingCanMoveItShowsEverything) {
  test::writeText(folder_ / "still.cell.toml",
                  std::string("format = 1\n") + kHall +
                      "[[device]]\nname = \"pallet\"\nmodel = \"pallet.urdf\"\n");
  FrameMaker maker = openCell(folder_ / "still.cell.toml", false);
  EXPECT_EQ(cameraOf(maker, "fit"), cameraOf(maker, "fit:hall"));
  EXPECT_LT(lengthOf(cameraOf(maker, "fit:pallet").eye), 5);
  // Nor where what can move is hidden.
  FrameMaker with_arm = open(kHall);
  EXPECT_GT(lengthOf(cameraOf(with_arm, "fit", {"arm"}).eye), 40);
}

TEST_F(FitTest, ADeviceThatIsNotThereOrNotSeenIsRefused) {
  FrameMaker maker = open(kHall);
  const std::string unknown = refusalOf(maker, "fit:arn");
  EXPECT_NE(unknown.find("neither the cell nor the log has a device `arn`"), std::string::npos)
      << unknown;
  EXPECT_NE(unknown.find("arm"), std::string::npos) << unknown;
  const std::string hidden = refusalOf(maker, "fit:hall", {"hall"});
  EXPECT_NE(hidden.find("`fit:hall` sees nothing: no part of hall is visible"), std::string::npos)
      << hidden;
}

TEST_F(FitTest, WhatCanMoveIsSaidByTheModelTheCellOrThePackets) {
  const auto file = folder_ / "yard.cell.toml";
  const std::string cell =
      std::string("format = 1\n") + kHall +
      "[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n"
      "[[device]]\nname = \"tool\"\nmodel = \"pallet.urdf\"\non = \"arm/hand\"\n"
      "[[device]]\nname = \"cap\"\nmodel = \"pallet.urdf\"\non = \"tool\"\n"
      "[[device]]\nname = \"pallet\"\nmodel = \"pallet.urdf\"\n"
      "pose = { xyz = [1, 2, 0] }\n"
      "[[device]]\nname = \"cart\"\nmodel = \"pallet.urdf\"\n";
  test::writeText(file, cell);
  EXPECT_EQ(movable(file, "joints arm 0\n"), (DeviceNames{"arm", "cap", "tool"}));
  // A simulator that repeats where the cell has a building moves no building.
  EXPECT_EQ(movable(file, "pose hall 0 0 0 0 0 0 1\npose pallet 1.0004 2 0 0 0 0 1\n"),
            (DeviceNames{"arm", "cap", "tool"}));
  EXPECT_EQ(movable(file, "pose pallet 1.1 2 0 0 0 0 1\n"),
            (DeviceNames{"arm", "cap", "pallet", "tool"}));
  EXPECT_EQ(movable(file, "add other arm.urdf\n"), (DeviceNames{"arm", "cap", "other", "tool"}));
  test::writeText(file, cell + "[[source]]\nname = \"plc\"\ndevices = [\"cart\"]\n");
  EXPECT_EQ(movable(file, "joints arm 0\n"), (DeviceNames{"arm", "cap", "cart", "tool"}));
}

TEST_F(FitTest, AnInsetThatRepeatsTheMainViewLeavesItselfOut) {
  FrameMaker maker = open(std::string(test::kCameras) +
                          "[[camera]]\nname = \"top again\"\neye = [0, 0, 6]\ntarget = [0, 0, 0]\n"
                          "[[inset]]\ncamera = \"top\"\n[[inset]]\ncamera = \"map\"\n"
                          "[[inset]]\ncamera = \"front\"\ncorner = \"top-left\"\n");
  const auto framed = [&](const std::string& camera, const std::vector<std::string>& insets) {
    FrameRequest request = requestAt(1000);
    request.camera = camera;
    request.samples = 1;
    request.insets.emplace();
    for (const std::string& inset : insets) request.insets->push_back(*parseInset(inset));
    return frameOf(maker, request);
  };
  const auto ofCell = [&](const std::string& camera) {
    FrameRequest request = requestAt(1000);
    request.camera = camera;
    request.samples = 1;
    return frameOf(maker, request);
  };
  // By name, whether the cell asks or the request; the others of the corner move up.
  EXPECT_EQ(ofCell("top").rgba, framed("top", {"map", "front:top-left"}).rgba);
  EXPECT_EQ(framed("top", {"top", "map"}).rgba, framed("top", {"map"}).rgba);
  EXPECT_EQ(framed("", {"top", "map"}).rgba, framed("top", {"map"}).rgba) << "the cell's first";
  EXPECT_EQ(framed("map", {"map"}).rgba, framed("map", {}).rgba);
  // By what it sees.
  EXPECT_EQ(framed("top again", {"top"}).rgba, framed("top again", {}).rgba);
  EXPECT_EQ(framed("@0,0,6/0,0,0/up=0,1,0", {"top"}).rgba,
            framed("@0,0,6/0,0,0/up=0,1,0", {}).rgba);
  EXPECT_NE(framed("front", {"top"}).rgba, framed("front", {}).rgba);
}

double luminance(const std::uint8_t* rgb) {
  const auto linear = [](double value) {
    value /= 255;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
}

TEST_F(FitTest, TheGnomonsLettersCanBeReadOnAnyGround) {
  for (const char* ground : {"#8a5a2b", "#c8a26a", "#6b859e", "#ffffff", "#000000", "#d8453b"}) {
    FrameMaker maker = open(std::string(test::kCameras) + "[scene]\nbackground_top = \"" + ground +
                            "\"\nbackground_bottom = \"" + ground + "\"\ngrid = false\n");
    FrameRequest request = requestAt(0);
    request.camera = "front";
    request.width = 320;
    request.height = 240;
    const Picture frame = frameOf(maker, request);
    // 26 pixels long from (42, 198): x to the right, z up, their letters a third farther.
    for (const auto& [x, y] : {std::pair(76, 198), std::pair(42, 164)}) {
      double darkest = 1, lightest = 0;
      for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
          const auto place = static_cast<std::size_t>((y + dy) * 320 + x + dx) * 4;
          const double here = luminance(&frame.rgba[place]);
          darkest = std::min(darkest, here);
          lightest = std::max(lightest, here);
        }
      }
      EXPECT_GT((lightest + 0.05) / (darkest + 0.05), 4.5) << ground << " at " << x << " " << y;
    }
  }
}

TEST_F(FitTest, LabelsOfASheetShrinkWithItsTilesAndThoseOfFramesDoNot) {
  RenderJob job;
  job.cell = folder_ / "arm.urdf";
  job.log = folder_ / "arm.mcap";
  job.moments.at = {"5"};
  job.look.width = 240;
  job.look.height = 180;
  job.sheet = folder_ / "sheet.png";
  job.frames = folder_ / "frames";
  const auto report = render(job, [](std::size_t, std::size_t) { return true; });
  ASSERT_TRUE(report.has_value()) << report.error().text();
  const auto sheet = readPng(job.sheet);
  ASSERT_TRUE(sheet.has_value());
  FrameMaker maker = open();
  FrameRequest request = requestAt(5000);
  request.width = 240;
  request.height = 180;
  const Picture frame = frameOf(maker, request);
  const auto written = readPng(report->frames.front().file);
  ASSERT_TRUE(written.has_value());
  EXPECT_EQ(written->rgba, frame.rgba);
  request.scale = 0.5;
  const Picture tile = frameOf(maker, request);
  EXPECT_NE(tile.rgba, frame.rgba);
  for (int y = 0; y < 180; ++y) {
    const auto row = sheet->rgba.begin() + (std::ptrdiff_t{y + 12} * sheet->width + 12) * 4;
    ASSERT_TRUE(std::equal(row, row + 240 * 4, tile.rgba.begin() + std::ptrdiff_t{y} * 240 * 4))
        << y;
  }
}

}  // namespace
}  // namespace rocinante
