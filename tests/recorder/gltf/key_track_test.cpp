#include "recorder/gltf/key_track.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::ElementsAre;

std::vector<float> numbersOf(const KeySpill& spill, std::size_t list) {
  std::vector<float> numbers;
  const Status read = spill.read(list, [&](ByteView bytes) -> Status {
    const std::size_t before = numbers.size();
    numbers.resize(before + bytes.size() / sizeof(float));
    std::memcpy(numbers.data() + before, bytes.data(), bytes.size());
    return {};
  });
  EXPECT_TRUE(read.ok());
  return numbers;
}

class KeyTracks : public testing::Test {
 protected:
  void add(KeyTrack& track, double seconds, const std::vector<double>& value) {
    ASSERT_TRUE(track.add(spill_, seconds, value).ok());
  }
  void end(KeyTrack& track) { ASSERT_TRUE(track.end(spill_).ok()); }
  std::vector<float> timesOf(const KeyTrack& track) const {
    return numbersOf(spill_, track.timeList());
  }
  std::vector<float> valuesOf(const KeyTrack& track) const {
    return numbersOf(spill_, track.valueList());
  }

  test::TemporaryFolder folder_;
  KeySpill spill_ = std::move(*KeySpill::make(folder_.path().string()));
};

TEST_F(KeyTracks, WhatStaysIsNoAnimation) {
  KeyTrack track(KeyTrack::Kind::translation);
  EXPECT_TRUE(track.empty());
  for (int i = 0; i < 5; ++i) add(track, i, {1, 2, 3 + 1e-9 * i});
  end(track);
  EXPECT_FALSE(track.animated());
  EXPECT_THAT(track.first(), ElementsAre(1, 2, 3));
}

TEST_F(KeyTracks, AValueHoldsAsLongAsItIsGiven) {
  KeyTrack track(KeyTrack::Kind::translation);
  add(track, 0, {0, 0, 0});
  add(track, 0.25, {0, 0, 0});
  add(track, 0.5, {0, 0, 0});
  add(track, 0.75, {1, 0, 0});
  end(track);
  EXPECT_THAT(timesOf(track), ElementsAre(0, 0.5, 0.75));
  EXPECT_THAT(valuesOf(track), ElementsAre(0, 0, 0, 0, 0, 0, 1, 0, 0));
  EXPECT_EQ(track.keys(), 3U);
}

TEST_F(KeyTracks, BlendsOverASecondAtMost) {
  KeyTrack track(KeyTrack::Kind::translation);
  add(track, 0, {0, 0, 0});
  add(track, 10, {1, 0, 0});
  add(track, 10.5, {2, 0, 0});
  end(track);
  EXPECT_THAT(timesOf(track), ElementsAre(0, 9, 10, 10.5));
}

TEST_F(KeyTracks, QuaternionsStayInOneHemisphere) {
  KeyTrack track(KeyTrack::Kind::rotation);
  add(track, 0, {0, 0, 0, 1});
  add(track, 0.5, {0, 0, -0.6, -0.8});
  add(track, 1, {0, 0, -0.6, -0.8});
  end(track);
  EXPECT_THAT(timesOf(track), ElementsAre(0, 0.5));
  EXPECT_THAT(valuesOf(track), ElementsAre(0, 0, 0, 1, 0, 0, 0.6F, 0.8F));
}

TEST_F(KeyTracks, AScaleSteps) {
  KeyTrack track(KeyTrack::Kind::scale);
  add(track, 0, {1, 1, 1});
  add(track, 5, {1, 1, 1});
  add(track, 6, {0, 0, 0});
  end(track);
  EXPECT_THAT(timesOf(track), ElementsAre(0, 6));
}

TEST_F(KeyTracks, MomentsThatAFloatDoesNotTellApartAreOne) {
  KeyTrack track(KeyTrack::Kind::translation);
  add(track, 100000, {0, 0, 0});
  add(track, 100000.0001, {1, 0, 0});
  add(track, 100000.0002, {2, 0, 0});
  add(track, 100000.5, {3, 0, 0});
  end(track);
  EXPECT_THAT(timesOf(track), ElementsAre(100000, 100000.5F));
  EXPECT_THAT(valuesOf(track), ElementsAre(2, 0, 0, 3, 0, 0));
}

TEST_F(KeyTracks, ListsAreReadAsTheyWereWrittenHoweverMany) {
  constexpr std::size_t kLists = 3, kCount = 5000;
  for (std::size_t list = 0; list < kLists; ++list) spill_.addList();
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t list = 0; list < kLists; ++list) {
      const std::vector<float> some(list + 1, static_cast<float>(i * 10 + list));
      ASSERT_TRUE(spill_.append(list, some).ok());
    }
  }
  for (std::size_t list = 0; list < kLists; ++list) {
    const std::vector<float> numbers = numbersOf(spill_, list);
    ASSERT_EQ(numbers.size(), kCount * (list + 1));
    EXPECT_EQ(spill_.bytesOf(list), numbers.size() * sizeof(float));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      ASSERT_EQ(numbers[i], static_cast<float>(i / (list + 1) * 10 + list));
    }
  }
}

TEST(KeySpillFolder, MustExist) {
  EXPECT_EQ(KeySpill::make("/nowhere/at/all").error().kind, ErrorKind::unreadable);
}

TEST_F(KeyTracks, AFarPlaceIsAsExactAsANearOne) {
  KeyTrack track(KeyTrack::Kind::translation);
  for (int i = 0; i < 5; ++i) add(track, i, {5'400'000.25 + 0.05 * i, -4'649'776.5, 320});
  end(track);
  ASSERT_TRUE(track.animated());
  EXPECT_EQ(track.keys(), 5U);
  const auto values = valuesOf(track);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(track.offset()[i], static_cast<float>(track.offset()[i]));
  }
  EXPECT_NEAR(track.offset()[0] + values[12], 5'400'000.45, 1e-4);
  EXPECT_NEAR(track.offset()[1] + values[1], -4'649'776.5, 1e-4);
  EXPECT_EQ(track.offset()[2], 0);
  EXPECT_LT(track.worstError(), 1e-4);
}

TEST_F(KeyTracks, WhatIsNearHasNoOffset) {
  KeyTrack track(KeyTrack::Kind::translation), turn(KeyTrack::Kind::rotation);
  add(track, 0, {1024, -1024, 0});
  add(turn, 0, {0, 0, 0, 1});
  EXPECT_FALSE(track.hasOffset());
  EXPECT_FALSE(turn.hasOffset());
}

TEST_F(KeyTracks, CountsWhatAFloatCannotHold) {
  KeyTrack track(KeyTrack::Kind::translation);
  add(track, 0, {0, 0, 0});
  for (int i = 0; i < 1000; ++i) add(track, 18'000 + 0.001 * i, {0.001 * i, 0, 0});
  add(track, 18'002, {5'400'000.3, 0, 0});
  end(track);
  // Floats are 1.95 ms apart there.
  EXPECT_NEAR(static_cast<double>(track.merged()), 488, 3);
  EXPECT_GT(track.worstError(), 0.04);
  KeyTrack twice(KeyTrack::Kind::translation);
  for (int i = 0; i < 9; ++i) add(twice, 1, {1.0 * i, 0, 0});
  end(twice);
  EXPECT_EQ(twice.merged(), 0U);  // one moment: the last value holds
}

TEST_F(KeyTracks, NumbersThatNoFloatHoldsDoNoHarm) {
  for (const double odd : {1e300, -1e300, std::nan(""), double{INFINITY}, 1e18}) {
    KeyTrack track(KeyTrack::Kind::translation);
    add(track, 0, {odd, 0, 0});
    add(track, 1, {0, odd, 0});
    end(track);
    for (const double part : track.offset()) EXPECT_TRUE(std::isfinite(part));
  }
}

}  // namespace
}  // namespace rocinante
