// docs/packet-format.md, section "Restatements": what a complete one removes, and what abandons it.
#include <gtest/gtest.h>

#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using test::TextFold;

class FoldRestatement : public ::testing::Test {
 protected:
  FoldRestatement() {
    fold_.fold(1,
               "RK1 a 1 -\njoints arm 1\npose arm 0 0 0 0 0 0 1\nshow arm\ncolor arm #ff0000\n"
               "order arm2 j\njoint arm2 j=1\nadd arm3 m\nhide layer/x\nview v 0 0 1 0 0 0 45\n"
               "line l #ff0000 0 0 0\n");
    fold_.fold(1, "RK1 b 1 -\njoint arm k=1\njoints tank 1\nline l #ff0000 0 0 0\n");
  }
  std::size_t itemsOf(const std::string& source) const {
    const std::string text = fold_.state.identityText();
    std::size_t count = 0;
    const std::string line = "item " + source + " ";
    for (std::size_t at = text.find(line); at != std::string::npos; at = text.find(line, at + 1)) {
      ++count;
    }
    return count;
  }
  TextFold fold_;
};

TEST_F(FoldRestatement, AWholeOneInOnePartForgetsEverythingElseOfItsSource) {
  EXPECT_EQ(itemsOf("a"), 10U);
  fold_.fold(2, "RK1 a 2 - restated part=r:1/1\njoints arm 1\n");
  EXPECT_EQ(itemsOf("a"), 1U);
  EXPECT_EQ(fold_.state.devices().count("arm2"), 0U) << "nothing is said about it any more";
  EXPECT_EQ(fold_.state.devices().count("arm3"), 0U);
  EXPECT_FALSE(fold_.state.restatementOpen());
}

TEST_F(FoldRestatement, OtherSourcesItemsAreLeftAlone) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/1\n");
  EXPECT_EQ(itemsOf("a"), 0U);
  EXPECT_EQ(itemsOf("b"), 3U);
  EXPECT_TRUE(fold_.device("arm").joints == std::nullopt);
  EXPECT_EQ(fold_.device("arm").named_joints.size(), 1U);
}

TEST_F(FoldRestatement, NothingIsForgottenUntilAllPartsHaveCome) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/3\njoints arm 1\n");
  EXPECT_TRUE(fold_.state.restatementOpen());
  fold_.fold(2, "RK1 a 4 - restated part=r:3/3\nshow arm\n");
  fold_.fold(2, "RK1 a - - restated part=r:3/3\nshow arm\n");
  EXPECT_EQ(itemsOf("a"), 10U);
  fold_.fold(2, "RK1 a 5 - restated part=r:2/3\n");
  EXPECT_EQ(itemsOf("a"), 2U);
}

TEST_F(FoldRestatement, WhatWasSaidBetweenThePartsIsRepeatedToo) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/2\njoints arm 1\n");
  fold_.fold(2, "RK1 a 3 -\ncolor arm #00ff00\njoint tank q=1\n");
  fold_.fold(2, "RK1 b 3 -\nhide layer/x\n");
  fold_.fold(2, "RK1 a 4 - restated part=r:2/2\n");
  EXPECT_EQ(itemsOf("a"), 3U);
  EXPECT_EQ(itemsOf("b"), 3U) << "layer/x is b's now; its joint of arm fell to a's positions";
}

TEST_F(FoldRestatement, ALatePartDoesNotCount) {
  fold_.fold(2, "RK1 a 3 - restated part=r:2/2\njoints arm 1\n");
  EXPECT_EQ(fold_.fold(2, "RK1 a 2 - restated part=r:1/2\n"), Applied::late);
  EXPECT_TRUE(fold_.state.restatementOpen());
  EXPECT_EQ(itemsOf("a"), 10U);
}

TEST_F(FoldRestatement, AnotherIdOrAnotherCountAbandonsIt) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/2\njoints arm 1\n");
  fold_.fold(2, "RK1 a 3 - restated part=s:1/2\njoints arm 1\n");
  fold_.fold(2, "RK1 a 4 - restated part=r:2/2\n");
  fold_.fold(2, "RK1 a 5 - restated part=r:1/3\n");
  fold_.fold(2, "RK1 a 6 - restated part=r:2/2\n");
  EXPECT_EQ(itemsOf("a"), 10U);
  EXPECT_TRUE(fold_.state.restatementOpen());
}

TEST_F(FoldRestatement, APartOfAnotherSourceDoesNotDisturb) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/2\njoints arm 1\n");
  fold_.fold(2, "RK1 b 2 - restated part=s:1/2\njoint arm k=1\n");
  fold_.fold(2, "RK1 a 3 - restated part=r:2/2\n");
  EXPECT_EQ(itemsOf("a"), 1U);
  fold_.fold(2, "RK1 b 3 - restated part=s:2/2\n");
  EXPECT_EQ(itemsOf("b"), 1U);
}

TEST_F(FoldRestatement, ARestartAbandonsIt) {
  for (const char* const restart : {"RK1 a 0 -\n", "RK1 a@new 9 -\n"}) {
    SCOPED_TRACE(restart);
    fold_.fold(2, "RK1 a - - restated part=r:1/2\n");
    fold_.fold(2, restart);
    EXPECT_FALSE(fold_.state.restatementOpen());
  }
}

TEST_F(FoldRestatement, ASecondOfLogTimeAbandonsIt) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/2\njoints arm 1\n");
  EXPECT_TRUE(fold_.state.restatementOpen(test::atSeconds(2.999999999)));
  EXPECT_FALSE(fold_.state.restatementOpen(test::atSeconds(3)));
  fold_.fold(3, "RK1 b - -\n");
  EXPECT_FALSE(fold_.state.restatementOpen()) << "anybody's packet tells the time";
  fold_.fold(3, "RK1 a 3 - restated part=r:2/2\n");
  EXPECT_EQ(itemsOf("a"), 10U);
  fold_.fold(3.999999999, "RK1 a 4 - restated part=r:1/2\njoints arm 1\n");
  EXPECT_EQ(itemsOf("a"), 1U) << "and these two were within one second";
}

TEST_F(FoldRestatement, ResetTakesLaterThingsAwayWhenComplete) {
  fold_.fold(9, "RK1 a 90 -\njoints later 1\n");
  fold_.fold(10, "RK1 a 1 - restated part=p:1/2 by=player reset\njoints arm 1\n");
  EXPECT_EQ(fold_.state.devices().count("later"), 1U);
  fold_.fold(10, "RK1 a 1 - restated part=p:2/2 by=player reset\nshow arm\n");
  EXPECT_EQ(fold_.state.devices().count("later"), 0U);
  EXPECT_EQ(itemsOf("a"), 2U);
  EXPECT_EQ(fold_.fold(10, "RK1 a 2 -\njoints arm 2\n"), Applied::yes);
}

TEST_F(FoldRestatement, PartsOfADrawingThatAreNotRepeatedBecomeGaps) {
  fold_.fold(2, "RK1 a 2 -\nline l:1/3 #ff0000 0 0 0\nline l:3/3 #ff0000 0 0 0\n");
  fold_.fold(3, "RK1 a 3 - restated part=r:1/1\nline l:1/3 #ff0000 0 0 0\n");
  const Drawing& line = fold_.state.drawings().at({"a", "l"});
  EXPECT_TRUE(line.parts[0]);
  EXPECT_FALSE(line.parts[2]);
}

TEST_F(FoldRestatement, ACopyMadeMidwayFinishesTheSame) {
  fold_.fold(2, "RK1 a 2 - restated part=r:1/2\njoints arm 1\n");
  TextFold copy;
  copy.state = fold_.state;
  for (TextFold* const fold : {&fold_, &copy}) {
    fold->fold(2.5, "RK1 a 3 - restated part=r:2/2\nshow arm\n");
  }
  EXPECT_EQ(itemsOf("a"), 2U);
  EXPECT_EQ(copy.state.identityText(), fold_.state.identityText());
  EXPECT_TRUE(copy.state.sameAs(fold_.state));
}

TEST_F(FoldRestatement, AnUnfinishedOneIsNoPartOfTheIdentity) {
  TextFold copy;
  copy.state = fold_.state;
  fold_.fold(2, "RK1 a - - restated part=r:1/2\nhide layer/x\n");
  copy.fold(2, "RK1 a - -\nhide layer/x\n");
  EXPECT_TRUE(copy.state.sameAs(fold_.state));
  EXPECT_EQ(copy.state.identityText(), fold_.state.identityText());
}

}  // namespace
}  // namespace rocinante
