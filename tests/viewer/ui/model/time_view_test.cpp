#include "viewer/ui/model/time_view.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr LogTime kFirst{100s};
constexpr LogTime kLast{200s};

TEST(TimeView, ShowsAllAtFirst) {
  const TimeView view(kFirst, kLast);
  EXPECT_TRUE(view.showsAll());
  EXPECT_EQ(view.span(), 100s);
}

TEST(TimeView, ZoomsAboutAMomentThatStays) {
  TimeView view(kFirst, kLast);
  view.zoom(0.5, kFirst + 50s);
  EXPECT_EQ(view.from(), kFirst + 25s);
  EXPECT_EQ(view.until(), kFirst + 75s);
  view.zoom(0.1, kFirst + 25s);
  EXPECT_EQ(view.from(), kFirst + 25s);
  EXPECT_EQ(view.span(), 5s);
  view.zoom(1e9, kFirst + 26s);
  EXPECT_TRUE(view.showsAll());
  for (int i = 0; i < 200; ++i) view.zoom(0.5, kFirst + 3s);
  EXPECT_EQ(view.span(), TimeView::kShortest);
  view.zoom(0, kFirst);
  view.zoom(-1, kFirst);
  EXPECT_EQ(view.span(), TimeView::kShortest);
}

TEST(TimeView, MovesWithinTheLog) {
  TimeView view(kFirst, kLast);
  view.show(kFirst + 20s, kFirst + 10s);
  EXPECT_EQ(view.from(), kFirst + 10s);
  view.pan(0.5);
  EXPECT_EQ(view.from(), kFirst + 15s);
  view.pan(-1e30);
  EXPECT_EQ(view.from(), kFirst);
  EXPECT_EQ(view.span(), 10s);
  view.pan(1e30);
  EXPECT_EQ(view.until(), kLast);
  view.show(kFirst - 50s, kFirst - 40s);
  EXPECT_EQ(view.from(), kFirst);
  EXPECT_EQ(view.span(), 10s);
}

TEST(TimeView, FollowsWhatPlays) {
  TimeView view(kFirst, kLast);
  view.show(kFirst + 10s, kFirst + 20s);
  view.follow(kFirst + 15s);
  EXPECT_EQ(view.from(), kFirst + 10s);
  view.follow(kFirst + 21s);
  EXPECT_EQ(view.from(), kFirst + 21s);
  view.follow(kFirst + 20s);  // backwards
  EXPECT_EQ(view.until(), kFirst + 20s);
  view.follow(kLast);
  EXPECT_EQ(view.until(), kLast);
  EXPECT_EQ(view.span(), 10s);
}

TEST(TimeView, OfALogThatGrowsGoesOnShowingAll) {
  TimeView view(kFirst, kLast);
  view.resize(kFirst, kLast + 10s);
  EXPECT_EQ(view.until(), kLast + 10s);
  view.show(kFirst, kFirst + 10s);
  view.resize(kFirst, kLast + 20s);
  EXPECT_EQ(view.span(), 10s);
  // What is shown of a beginning that is no longer kept moves with it.
  view.resize(kFirst + 5s, kLast + 20s);
  EXPECT_EQ(view.from(), kFirst + 5s);
  EXPECT_EQ(view.span(), 10s);
}

TEST(TimeView, OfASessionThatBeginsShowsAllOfIt) {
  TimeView view;
  view.resize(kFirst, kFirst);
  view.resize(kFirst, kLast);
  EXPECT_EQ(view.from(), kFirst);
  EXPECT_EQ(view.until(), kLast);
}

TEST(TimeView, OfALogOfOneMoment) {
  TimeView view(kFirst, kFirst);
  view.zoom(0.5, kFirst);
  view.pan(1);
  view.follow(kFirst);
  EXPECT_TRUE(view.showsAll());
}

}  // namespace
}  // namespace rocinante
