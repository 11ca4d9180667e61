#include "viewer/serve/idle_connections.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(IdleConnections, OneTooManyEndsTheOldestOfTheAddressWithMost) {
  IdleConnections<int> idle(4);
  EXPECT_EQ(idle.add(1, "browser"), std::nullopt);
  EXPECT_EQ(idle.add(2, "flood"), std::nullopt);
  EXPECT_EQ(idle.add(3, "flood"), std::nullopt);
  EXPECT_EQ(idle.add(4, "flood"), std::nullopt);
  for (int more = 5; more < 400; ++more) EXPECT_EQ(idle.add(more, "flood"), more - 3);
  EXPECT_EQ(idle.size(), 4U);
  // The browser's is still there, and so is the newest of the flood.
  EXPECT_EQ(idle.add(1000, "another"), 397);
  EXPECT_EQ(idle.add(1001, "another"), 398);
}

TEST(IdleConnections, WhatAsksOrEndsIsNotAmongThem) {
  IdleConnections<int> idle(2);
  idle.add(1, "a");
  idle.add(2, "a");
  idle.remove(1);
  idle.remove(1);
  idle.remove(7);
  EXPECT_EQ(idle.add(3, "b"), std::nullopt);
  // One that comes back is the newest.
  EXPECT_EQ(idle.add(2, "a"), std::nullopt);
  EXPECT_EQ(idle.add(4, "b"), 3);
  EXPECT_EQ(idle.size(), 2U);
}

}  // namespace
}  // namespace rocinante
