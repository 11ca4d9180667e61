#include "viewer/ui/window/input_queue.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using Kind = InputEvent::Kind;

TEST(InputQueue, AClickIsTwoFramesAtItsOwnPlaceHoweverLateTheyAre) {
  InputQueue queue;
  // All of it before the first frame: a jump to the place, a click, and a jump away.
  queue.add({Kind::move, 0, 700, 300, {}});
  queue.add({Kind::press, 0, 700, 300, {}});
  queue.add({Kind::release, 0, 700, 300, {}});
  queue.add({Kind::move, 0, 20, 20, {}});
  const InputState press = queue.nextFrame();
  EXPECT_TRUE(press.down[0] && press.anyDown());
  EXPECT_EQ(press.x, 700);
  EXPECT_TRUE(queue.pending());
  const InputState release = queue.nextFrame();
  EXPECT_FALSE(release.anyDown());
  EXPECT_EQ(release.x, 700);
  EXPECT_EQ(release.y, 300);
  EXPECT_TRUE(queue.pending());
  EXPECT_EQ(queue.nextFrame().x, 20);
  EXPECT_FALSE(queue.pending());
}

TEST(InputQueue, ALineOfTextSeesEachEditingKeyInAFrameOfItsOwn) {
  constexpr int kErase = 259, kEnter = 257, kOther = 65;
  InputQueue queue;
  const auto press = [&](int key, bool repeated) {
    queue.add({Kind::key, 0, 0, 0, {key, false, repeated, false}});
  };
  press(kErase, false);
  press(kOther, false);
  press(kErase, false);
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.size(), 2U);
  EXPECT_TRUE(queue.pending());
  EXPECT_TRUE(queue.nextFrame(KeyTaker::line).keys.empty());
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.size(), 1U);
  EXPECT_FALSE(queue.pending());
  queue.nextFrame(KeyTaker::line);
  press(kErase, false);
  press(kEnter, false);
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.front().key, kErase);
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.front().key, kEnter);
  queue.nextFrame(KeyTaker::line);
  press(kErase, false);
  press(kErase, true);
  press(kErase, true);
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.size(), 3U);
}

TEST(InputQueue, ADoubleClickIsToldByWhenItCameNotByItsFrames) {
  using std::chrono::milliseconds;
  const auto secondIsAgain = [](milliseconds apart, std::size_t second,
                                milliseconds unknown = milliseconds(0)) {
    InputQueue queue;
    const SteadyTime at{}, later = at + apart;
    queue.add({Kind::press, 0, 5, 5, {}, 0, at, at});
    queue.add({Kind::release, 0, 5, 5, {}, 0, at, at});
    queue.add({Kind::press, second, 5, 5, {}, 0, later - unknown, later});
    queue.add({Kind::release, second, 5, 5, {}, 0, later, later});
    EXPECT_FALSE(queue.nextFrame().again);
    EXPECT_FALSE(queue.nextFrame().again);
    bool again = false;
    while (queue.pending()) {
      const InputState seen = queue.nextFrame();
      EXPECT_TRUE(!seen.again || seen.down[second]);
      again = again || seen.again;
    }
    return again;
  };
  EXPECT_TRUE(secondIsAgain(milliseconds(100), 0));
  EXPECT_FALSE(secondIsAgain(milliseconds(300), 0));
  EXPECT_TRUE(secondIsAgain(milliseconds(300), 0, milliseconds(10)))
      << "a frame was drawn meanwhile";
  EXPECT_FALSE(secondIsAgain(milliseconds(500), 0, milliseconds(250))) << "most likely not";
  EXPECT_FALSE(secondIsAgain(milliseconds(100), 1));
}

TEST(InputQueue, AButtonGoesDownWhereAKeyOrClickBeforeItHasArrangedAll) {
  InputQueue queue;
  queue.add({Kind::key, 0, 0, 0, {258, false, false, false}});
  queue.add({Kind::move, 0, 40, 5, {}});
  queue.add({Kind::press, 0, 40, 5, {}});
  queue.add({Kind::release, 0, 40, 5, {}});
  queue.add({Kind::press, 0, 40, 5, {}});
  EXPECT_EQ(queue.nextFrame().keys.size(), 1U);
  const InputState between = queue.nextFrame();
  EXPECT_EQ(between.x, 40);
  EXPECT_FALSE(between.anyDown());
  EXPECT_TRUE(queue.nextFrame().anyDown());
  EXPECT_FALSE(queue.nextFrame().anyDown());
  EXPECT_FALSE(queue.nextFrame().anyDown());
  EXPECT_TRUE(queue.pending());
  EXPECT_TRUE(queue.nextFrame().anyDown());
}

TEST(InputQueue, ACommandIsOneKeyWithItsLetterAndTheRepeatsOfIt) {
  constexpr int kShift = 340;
  InputQueue queue;
  const auto press = [&](int key, bool repeated) {
    queue.add({Kind::key, 0, 0, 0, {key, false, repeated, false}});
    InputEvent letter;
    letter.kind = Kind::letter;
    letter.letter = static_cast<unsigned>(key);
    if (key < kShift) queue.add(letter);
  };
  press(kShift, false);
  press('Y', false);
  press('Y', true);
  press('A', false);
  EXPECT_EQ(queue.nextFrame().keys.size(), 3U);
  EXPECT_EQ(queue.thisFrame().letters, (std::vector<unsigned>{'Y', 'Y'}));
  // The first opened a line.
  EXPECT_TRUE(queue.nextFrame(KeyTaker::nobody).keys.empty());
  EXPECT_TRUE(queue.thisFrame().letters.empty());
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).letters, std::vector<unsigned>{'A'});
  EXPECT_FALSE(queue.pending());
}

TEST(InputQueue, WhatComesBehindEnterWaitsUntilTheLineMayBeClosed) {
  constexpr int kEnter = 257;
  InputQueue queue;
  queue.add({Kind::key, 0, 0, 0, {kEnter, false, false, false}});
  queue.add({Kind::key, 0, 0, 0, {'G', false, false, false}});
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.front().key, kEnter);
  EXPECT_TRUE(queue.nextFrame(KeyTaker::line).keys.empty());
  EXPECT_EQ(queue.nextFrame(KeyTaker::commands).keys.front().key, 'G');
}

TEST(InputQueue, WhatComesBehindTabWaitsUntilTheNextLineHasTheKeyboard) {
  constexpr int kTab = 258;
  InputQueue queue;
  queue.add({Kind::key, 0, 0, 0, {kTab, false, false, false}});
  InputEvent letter;
  letter.kind = Kind::letter;
  letter.letter = '7';
  queue.add(letter);
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).keys.front().key, kTab);
  EXPECT_TRUE(queue.thisFrame().letters.empty());
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(queue.nextFrame(KeyTaker::line).letters.empty());
  EXPECT_EQ(queue.nextFrame(KeyTaker::line).letters, std::vector<unsigned>{'7'});
}

TEST(InputQueue, KeysDoNotWaitForeverForALine) {
  InputQueue queue;
  queue.add({Kind::key, 0, 0, 0, {'G', false, false, false}});
  int frames = 0;
  while (queue.nextFrame(KeyTaker::nobody).keys.empty()) ASSERT_LT(++frames, 100);
  EXPECT_GT(frames, 10);
}

TEST(InputQueue, LettersAndKeysOfALineKeepTheirOrder) {
  constexpr int kErase = 259;
  InputQueue queue;
  const auto type = [&](unsigned letter) {
    InputEvent event;
    event.kind = Kind::letter;
    event.letter = letter;
    queue.add(event);
  };
  const auto erase = [&] { queue.add({Kind::key, 0, 0, 0, {kErase, false, false, false}}); };
  type('a');
  type('b');
  erase();
  type('c');
  erase();
  queue.add({Kind::press, 0, 5, 5, {}});
  EXPECT_EQ(queue.waitingKeys(), (std::vector<int>{kErase, kErase}));
  const InputState first = queue.nextFrame(KeyTaker::line);
  EXPECT_EQ(first.letters, (std::vector<unsigned>{'a', 'b'}));
  EXPECT_EQ(first.keys.size(), 1U);
  EXPECT_EQ(queue.waitingKeys().size(), 1U);
  const InputState between = queue.nextFrame(KeyTaker::line);
  EXPECT_EQ(between.letters, std::vector<unsigned>{'c'});
  EXPECT_TRUE(between.keys.empty()) << "it was down in the frame before";
  const InputState last = queue.nextFrame(KeyTaker::line);
  EXPECT_TRUE(last.letters.empty() && !last.anyDown());
  EXPECT_EQ(last.keys.size(), 1U);
  EXPECT_FALSE(queue.nextFrame(KeyTaker::line).anyDown());
  EXPECT_TRUE(queue.nextFrame(KeyTaker::line).anyDown());
  // Where nothing is typed into a line, commands hear both together.
  erase();
  type('d');
  EXPECT_EQ(queue.nextFrame().letters, std::vector<unsigned>{'d'});
  EXPECT_EQ(queue.thisFrame().keys.size(), 1U);
}

TEST(InputQueue, TheLastMoveOfADragIsSeenWithTheButtonDown) {
  InputQueue queue;
  queue.add({Kind::press, 0, 100, 100, {}});
  queue.nextFrame();
  queue.add({Kind::move, 0, 150, 100, {}});
  queue.add({Kind::move, 0, 300, 100, {}});
  queue.add({Kind::release, 0, 300, 100, {}});
  const InputState drag = queue.nextFrame();
  EXPECT_TRUE(drag.down[0]);
  EXPECT_EQ(drag.x, 300);
  EXPECT_FALSE(queue.nextFrame().down[0]);
  EXPECT_FALSE(queue.pending());
}

TEST(InputQueue, TwoClicksAtTwoPlacesAreFourFramesAndOneBetween) {
  InputQueue queue;
  for (const double x : {10., 500.}) {
    queue.add({Kind::move, 0, x, 5, {}});
    queue.add({Kind::press, 0, x, 5, {}});
    queue.add({Kind::release, 0, x, 5, {}});
  }
  for (const double x : {10., 500.}) {
    if (x == 500) {
      EXPECT_FALSE(queue.nextFrame().anyDown());
    }
    for (const bool down : {true, false}) {
      const InputState state = queue.nextFrame();
      EXPECT_EQ(state.down[0], down);
      EXPECT_EQ(state.x, x);
    }
  }
}

TEST(InputQueue, MovesAloneAreOneFrameAndUnknownButtonsNone) {
  InputQueue queue;
  for (int i = 0; i < 1000; ++i) queue.add({Kind::move, 0, i * 1.0, 0, {}});
  queue.add({Kind::press, 9, 0, 0, {}});
  EXPECT_EQ(queue.nextFrame().x, 999);
  EXPECT_FALSE(queue.pending());
  EXPECT_FALSE(queue.nextFrame().anyDown());
}

TEST(InputQueue, KeysKeepTheirPlaceAmongClicks) {
  InputQueue queue;
  const auto key = [&](int number) { queue.add({Kind::key, 0, 0, 0, {number, false, false}}); };
  key(1);
  key(2);
  queue.add({Kind::press, 0, 10, 5, {}});
  queue.add({Kind::release, 0, 10, 5, {}});
  key(3);
  queue.add({Kind::move, 0, 90, 5, {}});
  EXPECT_EQ(queue.nextFrame().keys.size(), 1U);
  EXPECT_EQ(queue.nextFrame().keys.size(), 1U);
  EXPECT_FALSE(queue.nextFrame().anyDown());
  EXPECT_TRUE(queue.nextFrame().down[0]);
  EXPECT_TRUE(queue.thisFrame().keys.empty());
  EXPECT_FALSE(queue.nextFrame().down[0]);
  EXPECT_TRUE(queue.thisFrame().keys.empty()) << "not before what the click did is seen";
  ASSERT_EQ(queue.nextFrame().keys.size(), 1U);
  EXPECT_EQ(queue.thisFrame().keys.front().key, 3);
  EXPECT_EQ(queue.thisFrame().x, 10);
  EXPECT_EQ(queue.nextFrame().x, 90);
  EXPECT_FALSE(queue.pending());
}

}  // namespace
}  // namespace rocinante
