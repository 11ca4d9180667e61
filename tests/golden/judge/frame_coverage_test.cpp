#include "golden/judge/frame_coverage.h"

#include <gtest/gtest.h>

#include "core/base/bytes.h"
#include "core/packet/decoder.h"

namespace rocinante {
namespace {

using Devices = std::set<std::string>;

/// What one packet after another states.
SessionState stateOf(std::initializer_list<const char*> bodies) {
  SessionState state;
  const auto decoder = makeDecoder("rk1");
  int number = 0;
  for (const char* body : bodies) {
    const std::string text = "RK1 plc@1 " + std::to_string(++number) + " 1.0\n" + body;
    state.apply(LogTime(std::chrono::seconds(number)), *decoder->decode(bytesOf(text)));
  }
  return state;
}

class FrameCoverageTest : public testing::Test {
 protected:
  FrameCoverageTest() {
    CellOptions options;
    options.geometry = false;
    auto cell = loadCell(
        std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo/demo.cell.toml", options);
    EXPECT_TRUE(cell.ok());
    if (cell.ok()) cell_ = std::move(*cell);
  }

  RunCoverage coverageIn(const SessionState& state) const {
    return frameCoverage(case_, cell_, state, LogTime{});
  }

  /// lostSentence() for a picture that was accepted with these devices; empty: it lost none.
  static std::string lostOf(std::vector<std::string> accepted_devices, RunCoverage now) {
    AcceptedPicture accepted;
    accepted.coverage = std::move(accepted_devices);
    now.lost = lostSince(accepted, now);
    return now.lost.empty() ? "" : lostSentence(now);
  }

  Cell cell_;
  SuiteCase case_;
  SessionState moving_ =
      stateOf({"joints arm 0 0 0 0 0 0\npose canister 1 0 0 0 0 0 1\n"
               "joint gantry z=0.1\nhide tanks\n"});
};

TEST_F(FrameCoverageTest, DevicesThatTheLogMovesAreJudged) {
  const RunCoverage coverage = coverageIn(moving_);
  EXPECT_EQ(coverage.judged, (Devices{"arm", "arm/*", "canister", "gantry", "gantry/z"}));
  EXPECT_TRUE(coverage.masked.empty() && coverage.left_out.empty());
  EXPECT_EQ(lostOf({"arm", "canister", "gantry"}, coverage), "");
  EXPECT_EQ(
      lostOf({"arm", "signs"}, coverage),
      "signs: not judged, since the log states no pose or joint of it by then, though accepted");
}

TEST_F(FrameCoverageTest, AnotherDeviceCountsAsNone) {
  const RunCoverage coverage =
      coverageIn(stateOf({"joints arn 0 0 0 0 0 0\npose Canister 1 0 0 0 0 0 1\n"}));
  EXPECT_TRUE(coverage.judged.empty());
  EXPECT_EQ(coverage.left_out.total(), 2U);
  EXPECT_EQ(lostOf({"arn", "canister"}, coverage),
            "arn and 1 more: not judged, since the cell has no such device, though accepted");
}

TEST_F(FrameCoverageTest, ValuesThatDoNotFitCountAsNone) {
  EXPECT_EQ(
      lostOf({"arm"}, coverageIn(stateOf({"pose arm 1 0 0 0 0 0 1\njoints arm 0 0 0 0 0 0 0\n"}))),
      "arm: not judged, since it states 7 values, its model takes 6, though accepted");
  EXPECT_EQ(lostOf({"arm"}, coverageIn(stateOf({"joint arm joint1=0\njoint arm jiont2=0\n"}))),
            "arm: not judged, since its model has no such joint, though accepted");
}

TEST_F(FrameCoverageTest, AJointThatIsStatedNoMoreIsLost) {
  const char* const five = "joint arm joint1=0 joint2=0 joint3=0 joint4=0 joint6=0\n";
  const std::string none =
      ": not judged, since the log states no value of it by then, though accepted";
  const std::vector<std::string> all = {"arm", "arm/*"};
  const RunCoverage whole = coverageIn(
      stateOf({"joint arm joint1=0 joint2=0 joint3=0\njoint arm joint4=0 joint5=0 joint6=0\n"}));
  EXPECT_EQ(whole.judged, (Devices{"arm", "arm/*"}));
  EXPECT_EQ(lostOf(all, whole), "");
  const RunCoverage unstated = coverageIn(stateOf({five}));
  EXPECT_EQ(lostOf(all, unstated), "arm/joint5" + none);
  EXPECT_EQ(lostOf({"arm"}, unstated), "") << "accepted by an older version";
  // A misspelt joint is named, and not its whole device.
  const RunCoverage misspelt = coverageIn(stateOf({five, "joint arm jiont5=0\n"}));
  EXPECT_EQ(lostOf(all, misspelt), "arm/joint5" + none);
  EXPECT_EQ(misspelt.left_out.leftOut().front().name, "arm/jiont5");
  EXPECT_EQ(lostOf({"arm"}, misspelt),
            "arm: not judged, since its model has no such joint, though accepted");
  // Some joints were accepted.
  const std::vector<std::string> two = {"arm", "arm/joint1", "arm/joint5"};
  EXPECT_EQ(lostOf(two, whole), "");
  EXPECT_EQ(lostOf(two, unstated), "arm/joint5" + none);
  EXPECT_EQ(lostOf(all, coverageIn(stateOf({"pose arm 1 0 0 0 0 0 1\n"}))),
            "arm (its joints)" + none);
  EXPECT_EQ(lostOf(all, coverageIn(stateOf({"joints arm 0 0 0 0 0 0 0\n"}))),
            "arm: not judged, since it states 7 values, its model takes 6, though accepted");
  case_.mask = {PictureArea{{}, "arm", 0}};
  EXPECT_EQ(lostOf(all, coverageIn(stateOf({five}))), "");
}

TEST_F(FrameCoverageTest, ARemovedDeviceIsNotLeftOut) {
  const RunCoverage coverage =
      coverageIn(stateOf({"pose canister 1 0 0 0 0 0 1\n", "remove canister\n"}));
  EXPECT_TRUE(coverage.judged.empty() && coverage.left_out.empty());
}

TEST_F(FrameCoverageTest, WhatTheCaseMasksOrHidesIsNotJudged) {
  const auto areaOf = [](const char* path) { return PictureArea{{}, path, 0}; };
  const auto expect = [&](const Devices& judged) {
    const RunCoverage coverage = coverageIn(moving_);
    Devices devices;
    for (const std::string& item : coverage.judged) devices.insert(item.substr(0, item.find('/')));
    EXPECT_EQ(devices, judged);
    EXPECT_EQ(devices.size() + coverage.masked.size(), 3U);
    EXPECT_EQ(lostOf({"arm", "canister", "gantry"}, coverage), "");
    case_ = {};
  };
  case_.mask = {areaOf("arm"), areaOf("canister/*")};
  expect({"gantry"});
  case_.mask = {areaOf("layer/robots")};
  expect({"canister"});
  case_.mask = {areaOf("gantry/bridge"), {MaskRectangle{0, 0, 640, 480}, "", 0}};
  expect({"arm", "canister", "gantry"});  // some of it is judged
  case_.judge_only = {areaOf("gantry/bridge")};
  expect({"gantry"});
  case_.judge_only = {{MaskRectangle{0, 0, 9, 9}, "", 0}};
  expect({"arm", "canister", "gantry"});  // may be anything's place
  case_.hide = {"arm"};
  expect({"canister", "gantry"});
  case_.layers = {"tanks"};
  case_.show = {"arm"};
  expect({"arm", "canister"});
}

TEST_F(FrameCoverageTest, APictureWithoutCoverageLosesNothing) {
  EXPECT_TRUE(lostSince({}, coverageIn(stateOf({}))).empty());
}

}  // namespace
}  // namespace rocinante
