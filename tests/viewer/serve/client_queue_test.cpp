#include "viewer/serve/client_queue.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

SharedMessage ofSize(std::size_t bytes) {
  Bytes all = SharedMessage::begin();
  all.resize(all.size() + bytes);
  return SharedMessage(std::move(all));
}

TEST(ClientQueue, NothingIsAddedBeforeAGreeting) {
  ClientQueue queue(1000);
  queue.add(ofSize(10));
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.needsGreeting());
  queue.greet({ofSize(20), ofSize(30)});
  queue.add(ofSize(10));
  EXPECT_EQ(queue.bytes(), 60U);
  EXPECT_EQ(queue.take().size(), 20U);
  EXPECT_EQ(queue.take().size(), 30U);
  EXPECT_EQ(queue.take().size(), 10U);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.skipped(), 0U);
}

TEST(ClientQueue, WhoIsTooSlowIsGreetedAnew) {
  ClientQueue queue(100);
  queue.greet({ofSize(5000)});  // as large as the state is
  queue.add(ofSize(60));
  EXPECT_FALSE(queue.needsGreeting());
  queue.add(ofSize(60));
  EXPECT_TRUE(queue.needsGreeting());
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.bytes(), 0U);
  EXPECT_EQ(queue.skipped(), 3U);
  queue.add(ofSize(10));
  EXPECT_TRUE(queue.empty());
  queue.greet({ofSize(10)});
  EXPECT_FALSE(queue.needsGreeting());
  EXPECT_EQ(queue.bytes(), 10U);
}

}  // namespace
}  // namespace rocinante
