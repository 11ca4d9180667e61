#include "viewer/detail/detail_level.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(DetailRungs, TheFirstIsEverything) {
  const DetailRung& first = kDetailRungs.front();
  EXPECT_EQ(first.resolution, 1);
  EXPECT_TRUE(first.multisampled);
  EXPECT_EQ(first.level, DetailLevel{});
}

TEST(DetailRungs, EachSavesAndNoneGivesAnythingBack) {
  for (std::size_t i = 1; i < kDetailRungs.size(); ++i) {
    const DetailRung& finer = kDetailRungs[i - 1];
    const DetailRung& coarser = kDetailRungs[i];
    EXPECT_LT(coarser.best_cost, finer.best_cost) << i;
    EXPECT_LE(coarser.resolution, finer.resolution) << i;
    EXPECT_LE(coarser.multisampled, finer.multisampled) << i;
    EXPECT_GE(coarser.level.plain_filtering, finer.level.plain_filtering) << i;
    EXPECT_GE(coarser.level.geometry_error_px, finer.level.geometry_error_px) << i;
    EXPECT_GE(coarser.level.cull_below_px, finer.level.cull_below_px) << i;
  }
}

TEST(DetailRungs, PixelsGoBeforeGeometryAndGeometryBeforeWhatIsSmall) {
  for (const DetailRung& rung : kDetailRungs) {
    if (rung.level.geometry_error_px > 0) {
      EXPECT_LT(rung.resolution, 1);
      EXPECT_FALSE(rung.multisampled);
      EXPECT_TRUE(rung.level.plain_filtering);
    }
    if (rung.level.cull_below_px > 0) {
      EXPECT_GT(rung.level.geometry_error_px, 0);
    }
  }
}

TEST(DetailRungs, AreNamedByNumber) {
  EXPECT_EQ(parseDetailRung("0"), 0);
  EXPECT_EQ(parseDetailRung("9"), 9);
  for (const char* text : {"", "10", "-1", "1.5", " 1", "1 ", "auto", "99999999999"}) {
    EXPECT_EQ(parseDetailRung(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace rocinante
