#include "viewer/ui/model/notice_stack.h"

#include <gtest/gtest.h>

#include <random>

namespace rocinante {
namespace {

using Order = std::vector<std::size_t>;

TEST(NoticeStack, HasTheNewestFirstBelowWhatStays) {
  NoticeStack stack;
  const std::vector<NoticeKey> one{{"old"}};
  EXPECT_EQ(stack.order(one), (Order{0}));
  const std::vector<NoticeKey> more{{"driving", true}, {"old"}, {"new"}, {"newer"}};
  EXPECT_EQ(stack.order(more), (Order{0, 2, 3, 1}));
  const std::vector<NoticeKey> last{{"driving", true}, {"old"}, {"new"}, {"newer"}, {"newest"}};
  EXPECT_EQ(stack.order(last), (Order{0, 4, 2, 3, 1}));
}

TEST(NoticeStack, LeavesOutWhatWasDismissedUntilItIsSaidAnew) {
  NoticeStack stack;
  const std::vector<NoticeKey> said{{"driving", true}, {"a"}, {"b"}};
  stack.order(said);
  stack.dismiss("a");
  EXPECT_EQ(stack.order(said), (Order{0, 2}));
  EXPECT_EQ(stack.order(said), (Order{0, 2}));
  const std::vector<NoticeKey> without{{"driving", true}, {"b"}};
  EXPECT_EQ(stack.order(without), (Order{0, 1}));
  EXPECT_EQ(stack.order(said), (Order{0, 1, 2}));  // said anew: it is the newest
  stack.dismissAll();
  EXPECT_EQ(stack.order(said), (Order{0}));  // a mode that is on is not dismissed
  stack.dismiss("driving");
  EXPECT_EQ(stack.order(said), (Order{0}));
}

TEST(NoticeStack, IsAColumnInTheMiddleWithANumberBelow) {
  const std::vector<NoticeSize> sizes{{100, 20}, {60, 40}, {80, 20}};
  const PanelRectangle free{300, 10, 400, 300};
  const NoticePlaces all = placeNotices(sizes, free, {50, 16}, 6, 4);
  ASSERT_EQ(all.places.size(), 3U);
  EXPECT_EQ(all.more, 0U);
  EXPECT_EQ(all.places[0], (PanelRectangle{450, 10, 100, 20}));
  EXPECT_EQ(all.places[1], (PanelRectangle{470, 36, 60, 40}));
  EXPECT_EQ(all.places[2], (PanelRectangle{460, 82, 80, 20}));

  const NoticePlaces two = placeNotices(sizes, free, {50, 16}, 6, 2);
  ASSERT_EQ(two.places.size(), 2U);
  EXPECT_EQ(two.more, 1U);
  EXPECT_EQ(two.more_place, (PanelRectangle{475, 82, 50, 16}));

  // The second would leave no room for the number.
  const NoticePlaces low = placeNotices(sizes, {300, 10, 400, 80}, {50, 16}, 6, 4);
  EXPECT_EQ(low.places.size(), 1U);
  EXPECT_EQ(low.more, 2U);
}

TEST(NoticeStack, HasAtLeastOneWhereThereIsNoRoom) {
  const std::vector<NoticeSize> sizes{{100, 20}, {60, 40}};
  const NoticePlaces placed = placeNotices(sizes, {5, 10, 40, 0}, {50, 16}, 6, 4);
  ASSERT_EQ(placed.places.size(), 1U);
  EXPECT_EQ(placed.places[0], (PanelRectangle{5, 10, 100, 20}));
  EXPECT_EQ(placed.more, 1U);
  EXPECT_TRUE(placeNotices({}, {}, {50, 16}, 6, 4).places.empty());
}

TEST(NoticeStack, StaysInTheFreeRectangleAndCoversNothing) {
  std::mt19937 random(39);
  const auto number = [&](int least, int most) {
    return static_cast<float>(std::uniform_int_distribution(least, most)(random));
  };
  for (int round = 0; round < 2000; ++round) {
    std::vector<NoticeSize> sizes(static_cast<std::size_t>(number(0, 12)));
    for (NoticeSize& size : sizes) size = {number(20, 300), number(16, 90)};
    const PanelRectangle free{10, 20, 300, number(0, 600)};
    const auto most = static_cast<std::size_t>(number(1, 8));
    const NoticePlaces placed = placeNotices(sizes, free, {50, 16}, 6, most);
    ASSERT_EQ(placed.places.size() + placed.more, sizes.size());
    ASSERT_LE(placed.places.size(), most);
    std::vector<PanelRectangle> all = placed.places;
    if (placed.more > 0) all.push_back(placed.more_place);
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_GE(all[i].x, free.x);
      ASSERT_LE(all[i].x + all[i].width, free.x + free.width);
      if (i == 0) continue;
      ASSERT_GE(all[i].y, all[i - 1].y + all[i - 1].height);
    }
    // The first is always there; with another one all are in it.
    if (placed.places.size() > 1) {
      ASSERT_LE(all.back().y + all.back().height, free.y + free.height);
    }
  }
}

}  // namespace
}  // namespace rocinante
