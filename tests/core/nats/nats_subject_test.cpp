#include "core/nats/nats_subject.h"

#include <gtest/gtest.h>

#include "core/net/endpoint.h"

namespace rocinante {
namespace {

TEST(NatsSubject, ASourceIsOneWord) {
  EXPECT_EQ(subjectWord("arm"), "arm");
  EXPECT_EQ(subjectWord("cell.arm 1"), "cell%2Earm%201");
  EXPECT_EQ(subjectWord("*"), "%2A");
  EXPECT_EQ(subjectWord(">"), "%3E");
  // What another program listens to can be written in an endpoint.
  EXPECT_TRUE(Endpoint::parse("nats://h/cell1." + subjectWord("a.b*c>\x01 \xc3\xbc")).ok());
}

TEST(NatsSubject, FollowsTheSourceOfEachDatagram) {
  SubjectOf subject("cell1");
  EXPECT_EQ(subject(bytesOf("RK1 arm 1 -\n")), "cell1.arm");
  EXPECT_EQ(subject(bytesOf("RK1 gantry.x 1 -\n")), "cell1.gantry%2Ex");
  EXPECT_EQ(subject(bytesOf("no packet")), "cell1._octets");
  EXPECT_EQ(subject(bytesOf("")), "cell1._octets");
  EXPECT_EQ(subject(bytesOf("RK1 arm@run2 2 -\njoints arm 1\n")), "cell1.arm");
}

}  // namespace
}  // namespace rocinante
