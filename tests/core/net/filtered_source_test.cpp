#include "core/net/filtered_source.h"

#include <gtest/gtest.h>

#include "tests/core/net/fake_source.h"

namespace rocinante {
namespace {

using test::FakeSource;

AddressFilter filterOf(std::string_view network) {
  AddressFilter filter;
  EXPECT_TRUE(filter.add(network).ok());
  return filter;
}

std::string received(DatagramSource& source) {
  const auto batch = source.receive();
  EXPECT_TRUE(batch.ok());
  std::string all;
  for (const ReceivedDatagram& each : *batch) all += textOf(each.payload);
  return all;
}

struct Filtering {
  explicit Filtering(AddressFilter allow, std::vector<SocketAddress> own = {}) {
    auto fake = std::make_unique<FakeSource>("127.0.0.1:1");
    inner = fake.get();
    source = std::make_unique<FilteredSource>(std::move(fake), std::move(allow), std::move(own));
  }
  FakeSource* inner;
  std::unique_ptr<FilteredSource> source;
};

TEST(FilteredSource, GivesWhatIsAllowedAndCountsTheRest) {
  Filtering setup(filterOf("10.0.0.0/24"));
  setup.inner->arrive({{"a", {}}, {"b", {}, "10.0.1.1"}, {"c", {}}, {"d", {}, "::1"}});
  setup.inner->arrive({{"e", {}}});
  EXPECT_EQ(received(*setup.source), "ac");
  EXPECT_EQ(received(*setup.source), "e");
  EXPECT_EQ(setup.source->counts().refused, 2U);
  EXPECT_EQ(setup.source->counts().echoes, 0U);
}

TEST(FilteredSource, AFloodFromElsewhereIsNoSilence) {
  Filtering setup(filterOf("10.0.0.0/24"));
  for (int i = 0; i < 10; ++i) setup.inner->arrive({{"x", {}, "10.9.9.9"}, {"x", {}, "10.9.9.9"}});
  setup.inner->arrive({{"kept", {}}});
  EXPECT_EQ(received(*setup.source), "kept");
  EXPECT_EQ(setup.source->counts().refused, 20U);
}

TEST(FilteredSource, RequestsForARelayAreDroppedAndCounted) {
  auto fake = std::make_unique<FakeSource>("127.0.0.1:1");
  fake->arrive({{"a", {}}, {"R", {}}, {"b", {}}, {"R", {}}});
  FilteredSource source(std::move(fake), AddressFilter(), {},
                        [](ByteView datagram) { return textOf(datagram) == "R"; });
  EXPECT_EQ(received(source), "ab");
  EXPECT_EQ(source.counts().requests, 2U);
  EXPECT_EQ(source.counts().refused, 0U);
}

TEST(FilteredSource, DoesNotHearItself) {
  Filtering setup(AddressFilter(), {SocketAddress::parse("10.0.0.1", 5001).value()});
  setup.inner->arrive({{"a", {}}, {"echo", {}, "10.0.0.1", 5001}, {"b", {}, "10.0.0.1", 5002}});
  EXPECT_EQ(received(*setup.source), "ab");
  EXPECT_EQ(setup.source->counts().echoes, 1U);
  EXPECT_EQ(setup.source->counts().refused, 0U);
}

TEST(FilteredSource, AConfirmationIncludesWhatWasRemovedBefore) {
  auto fake = std::make_unique<FakeSource>("jetstream://h/S");
  FakeSource& inner = *fake;
  inner.keepPlace();
  inner.arrive({{"R", {}}, {"a", {}}, {"R", {}}, {"R", {}}, {"b", {}}, {"c", {}}, {"R", {}}});
  FilteredSource source(std::move(fake), AddressFilter(), {},
                        [](ByteView datagram) { return textOf(datagram) == "R"; });
  ASSERT_TRUE(source.keepsPlace());
  EXPECT_EQ(received(source), "abc");
  for (const auto& [count, all] : {std::pair(0U, 1U), {1U, 4U}, {2U, 5U}, {3U, 7U}}) {
    source.confirm(count);
    EXPECT_EQ(inner.confirmed(), all);
  }
}

TEST(FilteredSource, ThatTheSocketFailsIsPassedOn) {
  Filtering setup(filterOf("10.0.0.0/24"));
  setup.inner->fail();
  EXPECT_FALSE(setup.source->receive().ok());
}

}  // namespace
}  // namespace rocinante
