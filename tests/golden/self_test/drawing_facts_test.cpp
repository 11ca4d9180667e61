#include "golden/self_test/drawing_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "golden/self_test/test_frame.h"

namespace rocinante {
namespace {

using State = SelfTestFact::State;

Picture reference() {
  auto frame = referenceFrame();
  EXPECT_TRUE(frame.ok());
  return frame.ok() ? *frame : Picture();
}

TEST(SelfTestFrame, OfAKnownRendererMustBeItsOwn) {
  const KnownFrame& known = knownFrames().front();
  EXPECT_EQ(pictureSha256(reference()), known.sha256);
  EXPECT_EQ(judgeTestFrame(reference(), std::string(known.key)).state, State::ok);
  Picture other = reference();
  other.rgba[0] ^= 1;
  const SelfTestFact fact = judgeTestFrame(other, std::string(known.key));
  EXPECT_EQ(fact.state, State::missing);
  EXPECT_THAT(fact.found, testing::HasSubstr(std::string(known.sha256)));
}

TEST(SelfTestFrame, OfAnUnknownRendererMayBeAKnownOne) {
  const SelfTestFact fact = judgeTestFrame(reference(), "llvmpipe-mesa99.0");
  EXPECT_EQ(fact.state, State::ok);
  EXPECT_THAT(fact.found, testing::HasSubstr("draws the same frame as Debian 12"));
}

TEST(SelfTestFrame, OfAnUnknownRendererIsRoundingOrIsNot) {
  Picture rounded = reference();
  rounded.rgba[40] ^= 1;
  const SelfTestFact rounding = judgeTestFrame(rounded, "llvmpipe-mesa99.0");
  EXPECT_EQ(rounding.state, State::limited);
  EXPECT_THAT(rounding.found, testing::HasSubstr("1 differ from Debian 12, by at most 1 of 255"));
  EXPECT_THAT(rounding.advice, testing::HasSubstr("within rounding"));

  Picture changed = reference();
  changed.rgba[40] ^= 64;
  EXPECT_EQ(judgeTestFrame(changed, "llvmpipe-mesa99.0").state, State::missing);
  EXPECT_EQ(judgeTestFrame(Picture{1, 1, {0, 0, 0, 255}}, "llvmpipe-mesa99.0").state,
            State::missing);
}

TEST(SelfTestFrame, TheCellThatIsBuiltInHasNoFaults) {
  const auto cell = testCell();
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  EXPECT_TRUE(cell->faults.empty());
}

}  // namespace
}  // namespace rocinante
