#include "viewer/ui/model/device_moves.h"

#include <gtest/gtest.h>

#include <string>

#include "core/packet/decoder.h"

namespace rocinante {
namespace {

Pose poseOn(double x) { return {{x, 0, 0}, {1, 0, 0, 0}}; }

double placeOf(const DeviceMoves& moves, std::string_view device) {
  const Pose* const pose = moves.find(device);
  return pose == nullptr ? -1 : pose->position.x;
}

TEST(DeviceMoves, AreUndoneAndDoneAgainOneByOne) {
  DeviceMoves moves;
  EXPECT_FALSE(moves.undo().has_value());
  moves.put("a", poseOn(1));
  moves.put("b", poseOn(5));
  moves.put("a", poseOn(2));
  EXPECT_TRUE(moves.takeChanged());
  EXPECT_EQ(moves.undo(), "a");
  EXPECT_EQ(placeOf(moves, "a"), 1);
  EXPECT_EQ(moves.undo(), "b");
  EXPECT_EQ(moves.find("b"), nullptr);
  EXPECT_EQ(moves.undo(), "a");
  EXPECT_TRUE(moves.poses().empty());
  EXPECT_FALSE(moves.undo().has_value());
  EXPECT_EQ(moves.redo(), "a");
  EXPECT_EQ(moves.redo(), "b");
  EXPECT_EQ(placeOf(moves, "b"), 5);
  // Another move ends what could be done again.
  moves.put("b", poseOn(6));
  EXPECT_FALSE(moves.canRedo());
  EXPECT_EQ(placeOf(moves, "a"), 1);
}

TEST(DeviceMoves, ADragIsOneStepAndNoneIfNothingMoved) {
  DeviceMoves moves;
  moves.hold("a", poseOn(1));
  moves.hold("a", poseOn(2));
  EXPECT_TRUE(moves.canUndo());
  moves.settle();
  moves.settle();
  EXPECT_EQ(moves.undo(), "a");
  EXPECT_TRUE(moves.poses().empty());
  EXPECT_FALSE(moves.canUndo());
  moves.put("a", poseOn(1));
  moves.hold("a", poseOn(3));
  moves.hold("a", poseOn(1));
  moves.settle();
  EXPECT_EQ(moves.undo(), "a");
  EXPECT_FALSE(moves.undo().has_value());
  // Undone while the mouse holds it: where it was before.
  moves.hold("a", poseOn(4));
  EXPECT_EQ(moves.undo(), "a");
  EXPECT_TRUE(moves.poses().empty());
}

TEST(DeviceMoves, KnowWhatTheCellHasNot) {
  DeviceMoves moves;
  moves.put("a", poseOn(1));
  moves.put("b", poseOn(1));
  moves.saved("a", poseOn(1));
  EXPECT_EQ(moves.unsaved(), std::vector<std::string>{"b"});
  moves.put("a", poseOn(2));
  EXPECT_EQ(moves.unsaved(), (std::vector<std::string>{"a", "b"}));
  moves.put("a", std::nullopt);
  EXPECT_EQ(moves.unsaved(), (std::vector<std::string>{"a", "b"}));
  moves.put("a", poseOn(1));
  moves.put("b", std::nullopt);
  EXPECT_TRUE(moves.unsaved().empty());
  moves.put("a", std::nullopt);
  moves.saved("a", poseOn(0));
  EXPECT_TRUE(moves.unsaved().empty());
}

TEST(DeviceMoves, OnlyTheOldestStepsAreForgotten) {
  DeviceMoves moves;
  for (std::size_t i = 0; i < DeviceMoves::kMostSteps + 5; ++i) {
    moves.put("a", poseOn(static_cast<double>(i) + 1));
  }
  std::size_t undone = 0;
  while (moves.undo()) ++undone;
  EXPECT_EQ(undone, DeviceMoves::kMostSteps);
  EXPECT_EQ(placeOf(moves, "a"), 5);
}

TEST(DeviceMoves, AreDrawnWherePacketsSayNothing) {
  Cell cell;
  for (const char* name : {"said", "still"}) {
    CellDevice device;
    device.name = name;
    cell.device_by_name.emplace(name, cell.devices.size());
    cell.devices.push_back(device);
  }
  cell.devices[1].on_device = "said";
  SessionState received;
  const std::string text = "RK1 robot 1 -\npose said 1 2 3 0 0 0 1\n";
  const auto decoder = makeDecoder("rk1");
  received.apply(LogTime{}, *decoder->decode(bytesOf(text)));
  DeviceMoves moves;
  EXPECT_EQ(moves.over(received, cell, LogTime{}), &received);
  moves.put("said", poseOn(7));
  moves.put("gone", poseOn(7));
  EXPECT_EQ(moves.over(received, cell, LogTime{}), &received);
  moves.put("still", poseOn(8));
  const SessionState* const shown = moves.over(received, cell, LogTime{});
  ASSERT_NE(shown, &received);
  EXPECT_EQ(shown->findDevice("said")->pose->value.pose.position, Vec3(1, 2, 3));
  ASSERT_NE(shown->findDevice("still"), nullptr);
  EXPECT_EQ(shown->findDevice("still")->pose->value.pose.position, Vec3(8, 0, 0));
  EXPECT_EQ(shown->findDevice("still")->pose->value.carrier.first, "said");
  EXPECT_EQ(shown->findDevice("gone"), nullptr);
  EXPECT_EQ(received.findDevice("still"), nullptr);
}

}  // namespace
}  // namespace rocinante
