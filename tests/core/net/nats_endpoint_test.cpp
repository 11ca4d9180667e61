#include "core/net/nats_endpoint.h"

#include <gtest/gtest.h>

#include "core/net/endpoint.h"

namespace rocinante {
namespace {

using namespace std::string_view_literals;

Endpoint parsed(std::string_view text) {
  auto endpoint = Endpoint::parse(text);
  EXPECT_TRUE(endpoint.ok()) << text << ": " << endpoint.error().text();
  return endpoint.value_or(Endpoint{});
}

TEST(NatsEndpoint, SaysServerAndSubject) {
  const Endpoint endpoint = parsed("nats://robots.example/hall.cell1");
  EXPECT_EQ(endpoint.scheme, Endpoint::Scheme::nats);
  EXPECT_TRUE(endpoint.isNats());
  EXPECT_EQ(endpoint.nats.host, "robots.example");
  EXPECT_EQ(endpoint.nats.port, 4222);
  EXPECT_EQ(endpoint.nats.subject, "hall.cell1");
  EXPECT_EQ(endpoint.nats.listenedSubject(), "hall.cell1.>");
  EXPECT_FALSE(endpoint.nats.tls);
  EXPECT_EQ(endpoint.text(), "nats://robots.example:4222/hall.cell1");
  EXPECT_EQ(parsed("nats://[::1]:14222/a").nats.server(), "[::1]:14222");
}

TEST(NatsEndpoint, CanonicalTextReadsBack) {
  for (const std::string_view text :
       {"nats://127.0.0.1:4222/cell1"sv, "nats://[fd00::1]:5000/a.*.c"sv, "nats://h:4222/a.>"sv,
        "nats://h:4222/>"sv, "nats://h:4222/cell1.arm%2E1"sv, "nats://h:4222/a?tls=on"sv,
        "nats://h:4222/a?ca=/etc/ca.pem"sv, "nats://h:4222/a?tls=off&ca=/etc/ca.pem"sv,
        "nats://h:4222/a?ca=/x&cert=/c.pem&key=/k.pem"sv, "nats://h:4222/a?creds=/a%26b/u.creds"sv,
        "jetstream://h:4222/CELLS"sv, "jetstream://h:4222/CELLS?from=17"sv,
        "jetstream://h:4222/CELLS?from=2026-01-31T08:00:00Z&durable=second"sv}) {
    SCOPED_TRACE(text);
    const Endpoint endpoint = parsed(text);
    EXPECT_EQ(parsed(endpoint.text()), endpoint);
    EXPECT_EQ(parsed(endpoint.text()).text(), endpoint.text());
  }
  EXPECT_EQ(parsed("nats://h:4222/a?creds=/a%26b/u.creds").nats.credentials, "/a&b/u.creds");
}

TEST(NatsEndpoint, ShowsNoPasswordAndNoToken) {
  const Endpoint endpoint = parsed("nats://ada:pa%2Fss%40@h/cell1");
  EXPECT_EQ(endpoint.nats.user, "ada");
  EXPECT_EQ(endpoint.nats.password, "pa/ss@");
  EXPECT_EQ(endpoint.text(), "nats://h:4222/cell1");
  EXPECT_EQ(parsed("nats://s3cret@h/a").nats.user, "s3cret");
  for (const std::string_view text :
       {"nats://ada:s3cret@h"sv, "nats://ada:s3/cret@h/a"sv, "nats://s3cret@h:x/a"sv,
        "jetstream://s3cret@h/a.b"sv, "nats://a:s3cret@h/a?speed=3"sv, "NATS://a:s3cret@h/a"sv}) {
    const auto refused = Endpoint::parse(text);
    ASSERT_FALSE(refused.ok()) << text;
    EXPECT_EQ(refused.error().text().find("cret"), std::string::npos) << refused.error().text();
  }
}

TEST(NatsEndpoint, RefusesWithTheReason) {
  struct Refused {
    std::string text;
    std::string reason;
  };
  const std::string subject =
      "a subject is words of letters, digits and -_$%:=+ with dots between them; to listen also * "
      "and a last >";
  const std::string port = "a server's port is a whole number from 1 to 65535";
  for (const Refused& each : {
           Refused{"nats://h", "nats:// needs a subject, as in nats://HOST/cell1"},
           Refused{"jetstream://h", "jetstream:// needs a stream, as in jetstream://HOST/STREAM"},
           Refused{"nats://h/", subject},
           Refused{"nats://h/a..b", subject},
           Refused{"nats://h/.a", subject},
           Refused{"nats://h/a.", subject},
           Refused{"nats://h/a.>.b", subject},
           Refused{"nats://h/a*", subject},
           Refused{"nats://h/a b", subject},
           Refused{"nats://h/" + std::string(256, 'a'), subject},
           Refused{"nats:///a", "the host is neither an address nor a name"},
           Refused{"nats://h:0/a", port},
           Refused{"nats://h:65536/a", port},
           Refused{"nats://h:/a", port},
           Refused{"nats://[::1/a", "the bracket of an IPv6 address is not closed"},
           Refused{"nats://[::1]x/a", port},
           Refused{"nats://[1.2.3.4]:1/a", "brackets are for IPv6 addresses"},
           Refused{"nats://:p@h/a",
                   "before the @ there is USER:PASSWORD or a token, with @ / : ? and % as %XX"},
           Refused{"nats://h/a?tls=yes", "tls= is on or off"},
           Refused{"nats://h/a?tls=on&tls=on", "tls= is given twice"},
           Refused{"nats://h/a?cert=/c", "cert= and key= belong together"},
           Refused{"nats://h/a?ca=", "ca= takes the name of a file"},
           Refused{"nats://h/a?ca=%zz", "a % in ca= is written %25, as in URLs"},
           Refused{"nats://h/a?nkey=/s",
                   "nkey= needs the public key before the @, as in nats://UABC...@HOST/cell1"},
           Refused{
               "nats://h/a?from=1",
               "the options of a nats:// endpoint are tls=, ca=, cert=, key=, creds= and nkey="},
           Refused{"jetstream://h/A.B",
                   "a stream's name has letters, digits, - and _, at most 128"},
           Refused{"jetstream://h/A?from=0",
                   "from= takes a sequence from 1 on, or a time as in 2026-01-31T08:00:00Z"},
           Refused{"jetstream://h/A?durable=a.b",
                   "durable= takes letters, digits, - and _, at most 128"},
       }) {
    SCOPED_TRACE(each.text);
    const auto endpoint = Endpoint::parse(each.text);
    ASSERT_FALSE(endpoint.ok());
    EXPECT_EQ(endpoint.error().kind, ErrorKind::bad_argument);
    EXPECT_EQ(endpoint.error().what, each.reason);
  }
}

TEST(NatsEndpoint, SubjectsMatchAsOnTheServer) {
  EXPECT_TRUE(subjectMatches("a.>", "a.b"));
  EXPECT_TRUE(subjectMatches("a.>", "a.b.c"));
  EXPECT_FALSE(subjectMatches("a.>", "a"));
  EXPECT_TRUE(subjectMatches("*.b", "a.b"));
  EXPECT_FALSE(subjectMatches("*.b", "a.c"));
  EXPECT_FALSE(subjectMatches("*", "a.b"));
  EXPECT_TRUE(subjectMatches("a.b", "a.b"));
  EXPECT_FALSE(subjectMatches("a.b", "a"));
  EXPECT_FALSE(subjectMatches("a", "a.b"));
}

}  // namespace
}  // namespace rocinante
