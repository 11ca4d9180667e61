#include "player/logs/read_ahead.h"

#include <gtest/gtest.h>

#include "tests/player/send/fake_send_port.h"

namespace rocinante {
namespace {

using test::FakeStream;

std::vector<FakeStream::Item> numbered(std::size_t count, std::size_t bytes) {
  std::vector<FakeStream::Item> items;
  for (std::size_t i = 0; i < count; ++i) {
    std::string payload = std::to_string(i);
    payload.resize(bytes, '.');
    items.push_back({Due{LogTime(Nanoseconds(i)), static_cast<std::uint32_t>(i % 3), i % 7 == 0},
                     std::move(payload)});
  }
  return items;
}

void expectAll(ReadAhead& ahead, const std::vector<FakeStream::Item>& items) {
  for (const auto& item : items) {
    const auto due = ahead.due();
    ASSERT_TRUE(due.ok());
    ASSERT_TRUE(due->has_value());
    EXPECT_EQ((*due)->time, item.due.time);
    EXPECT_EQ((*due)->span, item.due.span);
    EXPECT_EQ((*due)->restated, item.due.restated);
    ASSERT_EQ(textOf(ahead.take()), item.payload);
  }
}

TEST(ReadAhead, GivesTheSameDatagramsInTheSameOrder) {
  // More than the blocks hold, by number and by bytes; and payloads larger than a block.
  for (const auto& [count, bytes] : {std::pair<std::size_t, std::size_t>{0, 0},
                                     {1, 10},
                                     {100'000, 8},
                                     {9'000, 1'200},
                                     {20, 1'000'000}}) {
    SCOPED_TRACE(count);
    const auto items = numbered(count, bytes);
    FakeStream stream(items);
    ReadAhead ahead(stream);
    expectAll(ahead, items);
    EXPECT_FALSE(ahead.due()->has_value());
    EXPECT_FALSE(ahead.due()->has_value());
  }
}

TEST(ReadAhead, AnErrorComesAfterEverythingBeforeIt) {
  const auto items = numbered(5'000, 100);
  FakeStream stream(items);
  stream.fail_at = items.size();
  ReadAhead ahead(stream);
  expectAll(ahead, items);
  for (int again = 0; again < 2; ++again) {
    const auto end = ahead.due();
    ASSERT_FALSE(end.ok());
    EXPECT_EQ(end.error().kind, ErrorKind::damaged);
  }
}

TEST(ReadAhead, CanBeLeftInTheMiddle) {
  const auto items = numbered(200'000, 100);
  FakeStream stream(items);
  ReadAhead ahead(stream);
  ASSERT_TRUE(ahead.due()->has_value());
  ahead.take();
}

}  // namespace
}  // namespace rocinante
