#include <gtest/gtest.h>

#include "core/transport/open_sink.h"
#include "core/transport/open_source.h"

namespace rocinante {
namespace {

TEST(NoNats, SaysThatThisBuildCannot) {
  for (const std::string text : {"nats://127.0.0.1/a", "jetstream://127.0.0.1/A"}) {
    const Endpoint endpoint = Endpoint::parse(text).value();
    EXPECT_EQ(openSource(endpoint).error().kind, ErrorKind::unsupported);
    EXPECT_EQ(openSink(endpoint).error().kind, ErrorKind::unsupported);
  }
}

}  // namespace
}  // namespace rocinante
