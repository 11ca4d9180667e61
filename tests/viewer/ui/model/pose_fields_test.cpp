#include "viewer/ui/model/pose_fields.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "tests/viewer/support/arm_model.h"
#include "viewer/ui/model/inspection.h"

namespace rocinante {
namespace {

constexpr Units kMetric{AngleUnit::radians, LengthUnit::metres};
const Pose kOdd{{0.1234564321, -2.0000004, 1.0 / 3}, quaternionFromRpy({0.1, -0.7, 1.0 / 7})};

PoseTyping typingOf(std::size_t field, std::string_view text) {
  PoseTyping typing;
  typing.device = "arm";
  typing.field = field;
  typing.opened = "as it was";
  text.copy(typing.text.data(), typing.text.size() - 1);
  return typing;
}

/// kOdd with that text in the field, in millimetres and degrees.
Result<Pose> oddWith(std::size_t field, std::string_view text) {
  return typedPose(kOdd, typingOf(field, text), Units());
}

std::string whyNot(std::size_t field, std::string_view text) {
  const auto pose = oddWith(field, text);
  return pose ? std::string() : pose.error().text();
}

Units anyUnits() {
  Units units;
  if (*rc::gen::arbitrary<bool>()) units.angle = AngleUnit::radians;
  if (*rc::gen::arbitrary<bool>()) units.length = LengthUnit::metres;
  return units;
}

RC_GTEST_PROP(PoseFields, LeftAsOpenedMoveNothingToTheLastBit, ()) {
  const auto number = [] { return *rc::gen::inRange(-4'000'000, 4'000'000) / 1.1e6; };
  const Pose before{{number(), number(), number()},
                    quaternionFromRpy({number(), number(), number()})};
  const auto field = *rc::gen::inRange<std::size_t>(0, kPoseFields.size());
  const Units units = anyUnits();
  PoseTyping typing = typingOf(field, openedPoseText(before, field, units));
  typing.opened = typing.text.data();
  const auto same = typedPose(before, typing, units);
  RC_ASSERT(same.ok() && *same == before);
  // Typed anew, it is what `save-pose` keeps of it.
  typing.opened = "something else";
  const auto kept = typedPose(before, typing, units);
  RC_ASSERT(kept.ok());
  RC_ASSERT(lengthOf(kept->position - before.position) < 1e-6);
  RC_ASSERT(std::abs(glm::dot(kept->orientation, before.orientation)) > 1 - 1e-12);
}

TEST(PoseFields, ANumberLeavesTheOthersAsTheyAre) {
  const auto moved = oddWith(1, "250");
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(moved->position, Vec3(kOdd.position.x, 0.25, kOdd.position.z));
  EXPECT_EQ(moved->orientation, kOdd.orientation);
  const auto turned = oddWith(5, "90");
  ASSERT_TRUE(turned.ok());
  EXPECT_EQ(turned->position, kOdd.position);
  const Vec3 before = rpyOf(kOdd.orientation), after = rpyOf(turned->orientation);
  EXPECT_NEAR(after.x, before.x, 1e-12);
  EXPECT_NEAR(after.y, before.y, 1e-12);
  EXPECT_NEAR(after.z, kPi / 2, 1e-12);
}

TEST(PoseFields, TakeEachUnitAndOtherwiseThatOfThePanel) {
  EXPECT_EQ(oddWith(0, " +12cm ")->position.x, 0.12);
  EXPECT_EQ(oddWith(0, "-1.5 m")->position.x, -1.5);
  EXPECT_EQ(typedPose(kOdd, typingOf(0, "-1.5"), kMetric)->position.x, -1.5);
  EXPECT_NEAR(rpyOf(oddWith(3, "0.5rad")->orientation).x, 0.5, 1e-12);
  EXPECT_NEAR(rpyOf(typedPose(kOdd, typingOf(3, "0.5"), kMetric)->orientation).x, 0.5, 1e-12);
}

TEST(PoseFields, SayTheSameNumberWithoutAMove) {
  const Pose still;
  for (std::size_t field = 0; field < kPoseFields.size(); ++field) {
    EXPECT_EQ(typedPose(still, typingOf(field, "0.000"), Units()).value(), still);
    EXPECT_EQ(typedPose(still, typingOf(field, "-0"), Units()).value(), still);
  }
}

TEST(PoseFields, RefuseWhatIsNoPlace) {
  EXPECT_EQ(whyNot(0, "12q"), "`12q` is not a length: 120, 120mm, 0.12m");
  EXPECT_EQ(whyNot(5, "12mm"), "`12mm` is not an angle: 30, 30deg, 0.5rad");
  for (const std::size_t field : {0U, 4U}) {
    for (const char* text : {"", " ", "nan", "inf", "-inf", "1e999", "0x10", "1,5", "--1", "1 2"}) {
      EXPECT_NE(whyNot(field, text), "") << text;
    }
  }
  EXPECT_EQ(whyNot(2, "1000km"), "`1000km` is not a length: 120, 120mm, 0.12m");
  EXPECT_EQ(whyNot(2, "1e6m"), "");
  EXPECT_EQ(whyNot(2, "-1e300"), "`-1e300` is beyond 1000 km");
  EXPECT_EQ(whyNot(4, "-720"), "");
  EXPECT_EQ(whyNot(4, "360001"), "`360001` is beyond 1000 turns");
}

TEST(PoseFields, GiveExamplesInTheUnitOfThePanel) {
  EXPECT_EQ(typedPose(kOdd, typingOf(0, "12q"), kMetric).error().what,
            "`12q` is not a length: 0.12, 0.12m, 120mm");
  EXPECT_EQ(typedPose(kOdd, typingOf(5, "12q"), kMetric).error().what,
            "`12q` is not an angle: 0.5, 0.5rad, 30deg");
  // All of them are one length.
  for (const char* text : {"120", "120mm", "0.12m"}) EXPECT_EQ(oddWith(0, text)->position.x, 0.12);
}

TEST(PoseFields, AreRoundedUntilTheyAreTypedOver) {
  EXPECT_EQ(poseFieldText(kOdd, 0, Units()), "123.5");
  EXPECT_EQ(openedPoseText(kOdd, 0, Units()), "123.456");
  EXPECT_EQ(openedPoseText(kOdd, 0, kMetric), "0.123456");
  EXPECT_EQ(openedPoseText(kOdd, 1, kMetric), "-2");
  EXPECT_EQ(openedPoseText(kOdd, 4, kMetric), "-0.7");
  EXPECT_EQ(poseFieldText(kOdd, 5, Units()), "8.19");
  EXPECT_EQ(openedPoseText(kOdd, 5, Units()), "8.185111");
  EXPECT_EQ(openedPoseText({{-1e-9, 0, 0}, {1, 0, 0, 0}}, 0, Units()), "0");
}

TEST(PoseFields, StandInColumnsWhereThereIsRoom) {
  EXPECT_EQ(poseFieldColumns(200, 200), 2U);
  EXPECT_EQ(poseFieldColumns(199, 200), 1U);
}

/// An arm, and another that stands on its hand.
class TakenPose : public testing::Test {
 protected:
  void take(const PoseTyping& typing) {
    model_->viewer.panels.pose_fields.typing = typing;
    takeTypedPose(*model_);
    EXPECT_FALSE(model_->viewer.panels.pose_fields.typing.has_value());
  }
  const std::string& trouble() const { return model_->viewer.panels.pose_fields.trouble; }

  const test::TemporaryFolder folder_;
  std::unique_ptr<ViewModel> model_ =
      test::modelOfArm(folder_,
                       "[[device]]\nname = \"tool\"\nmodel = \"arm.urdf\"\non = \"arm/hand\"\n"
                       "pose = { xyz = [1, 0, 0] }\n");
};

TEST_F(TakenPose, IsOneStepToUndo) {
  take(typingOf(0, "1500"));
  // Before the next update, too, the other numbers are where they were put.
  take(typingOf(1, "20"));
  EXPECT_EQ(model_->movablePose("arm")->position, Vec3(1.5, 0.02, 0));
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  EXPECT_EQ(positionOf(model_->scene().findDevice("arm")->base), Vec3(1.5, 0.02, 0));
  EXPECT_EQ(model_->moves.undo(), "arm");
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  EXPECT_EQ(model_->movablePose("arm")->position, Vec3(1.5, 0, 0));
  EXPECT_EQ(model_->moves.undo(), "arm");
  EXPECT_FALSE(model_->moves.canUndo());
}

TEST_F(TakenPose, IsInTheSpaceThatTheCellSaysItIn) {
  PoseTyping typing = typingOf(2, "100");
  typing.device = "tool";
  take(typing);
  ASSERT_TRUE(model_->update(SteadyTime{}).ok());
  EXPECT_EQ(model_->scene().findDevice("tool")->pose.position, Vec3(1, 0, 0.1));
}

TEST_F(TakenPose, OfAWrongTextIsASentenceAndNoMove) {
  take(typingOf(0, "12q"));
  EXPECT_EQ(trouble(), "x of arm: `12q` is not a length: 120, 120mm, 0.12m");
  EXPECT_FALSE(model_->moves.canUndo());
  take(typingOf(0, "12"));
  EXPECT_EQ(trouble(), "");
  EXPECT_TRUE(model_->moves.canUndo());
  PoseTyping gone = typingOf(3, "1");
  gone.device = "nobody";
  take(gone);
  EXPECT_EQ(trouble(), "roll of nobody: the cell has no such device");
}

TEST_F(TakenPose, LeftAsItWasIsNoMove) {
  PoseTyping typing = typingOf(0, "0");
  typing.opened = "0";
  take(typing);
  take(typingOf(4, "0.0"));
  EXPECT_FALSE(model_->moves.canUndo());
  EXPECT_TRUE(model_->moves.poses().empty());
}

}  // namespace
}  // namespace rocinante
