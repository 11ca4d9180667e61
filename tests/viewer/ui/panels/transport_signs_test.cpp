#include "viewer/ui/panels/transport_signs.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

constexpr std::array kSigns{
    TransportSign::to_start,  TransportSign::step_back,    TransportSign::play,
    TransportSign::play_back, TransportSign::pause,        TransportSign::step_on,
    TransportSign::to_end,    TransportSign::event_before, TransportSign::event_after};

/// Twice the area, positive when the corners go round clockwise on a screen.
float turnOf(const SignPart& part, std::size_t i) {
  const SignPoint& a = part.corners[i];
  const SignPoint& b = part.corners[(i + 1) % part.count];
  const SignPoint& c = part.corners[(i + 2) % part.count];
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

TEST(TransportSigns, AreConvexPartsOfTheUnitSquare) {
  for (const TransportSign sign : kSigns) {
    SCOPED_TRACE(static_cast<int>(sign));
    const std::vector<SignPart> parts = partsOf(sign);
    ASSERT_FALSE(parts.empty());
    for (const SignPart& part : parts) {
      ASSERT_GE(part.count, 3U);
      for (std::size_t i = 0; i < part.count; ++i) {
        EXPECT_GE(part.corners[i].x, 0);
        EXPECT_LE(part.corners[i].x, 1);
        EXPECT_GE(part.corners[i].y, 0);
        EXPECT_LE(part.corners[i].y, 1);
        EXPECT_GT(turnOf(part, i), 0);
      }
    }
  }
}

/// Where the middle of all corners is, across.
float middleOf(TransportSign sign) {
  float sum = 0, count = 0;
  for (const SignPart& part : partsOf(sign)) {
    for (std::size_t i = 0; i < part.count; ++i, ++count) sum += part.corners[i].x;
  }
  return sum / count;
}

TEST(TransportSigns, OfBothDirectionsAreMirrorPictures) {
  using Pair = std::pair<TransportSign, TransportSign>;
  for (const auto& [back, on] : {Pair{TransportSign::to_start, TransportSign::to_end},
                                 Pair{TransportSign::step_back, TransportSign::step_on},
                                 Pair{TransportSign::play_back, TransportSign::play},
                                 Pair{TransportSign::event_before, TransportSign::event_after}}) {
    EXPECT_EQ(partsOf(back).size(), partsOf(on).size());
    EXPECT_NEAR(middleOf(back), 1 - middleOf(on), 1e-6);
    EXPECT_NE(middleOf(back), middleOf(on));
  }
}

}  // namespace
}  // namespace rocinante
