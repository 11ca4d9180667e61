#include "core/net/endpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

namespace rocinante {
namespace {

struct Case {
  std::string_view text, canonical;
};

TEST(Endpoint, ReadsEveryFormAndWritesTheCanonicalOne) {
  for (const Case& each : {
           Case{":19960", "udp://0.0.0.0:19960"},
           Case{"127.0.0.1:1", "udp://127.0.0.1:1"},
           Case{"udp://127.0.0.1:65535", "udp://127.0.0.1:65535"},
           Case{"udp://:0", "udp://0.0.0.0:0"},
           Case{"[::1]:19960", "udp://[::1]:19960"},
           Case{"udp://[2001:DB8::0001]:5", "udp://[2001:db8::1]:5"},
           Case{"[fe80::1%lo]:5", "udp://[fe80::1%lo]:5"},
           Case{"localhost:9", "udp://127.0.0.1:9"},
           Case{"10.0.0.1:5?ttl=3", "udp://10.0.0.1:5?ttl=3"},
           Case{"239.1.2.3:5", "udp://239.1.2.3:5"},
           Case{"239.1.2.3:5?source=10.0.0.9&ttl=0&interface=eth0",
                "udp://239.1.2.3:5?interface=eth0&ttl=0&source=10.0.0.9"},
           Case{"[ff02::1]:5?interface=en-x.7:1", "udp://[ff02::1]:5?interface=en-x.7:1"},
           Case{"[ff02::1%lo]:5", "udp://[ff02::1]:5?interface=lo"},
           Case{"[ff3e::1]:5?source=2001:db8::7", "udp://[ff3e::1]:5?source=2001:db8::7"},
           Case{"subscribe://localhost:19961", "subscribe://127.0.0.1:19961"},
           Case{"subscribe://[::1]:5?rate=2.50", "subscribe://[::1]:5?rate=2.5"},
           Case{"subscribe://[fe80::1%lo]:5", "subscribe://[fe80::1%lo]:5"},
           Case{"subscribe://10.0.0.1:5?rate=1e3&source=cell?&device=arm*%2C",
                "subscribe://10.0.0.1:5?device=arm*,&source=cell?&rate=1000"},
           Case{"subscribe://10.0.0.1:5?min-change=signal arm *%3D0.5,joint=0.1&signal=arm */",
                "subscribe://10.0.0.1:5?signal=arm%20*/&min-change=signal%20arm%20*=0.5,joint=0.1"},
           Case{"subscribe://10.0.0.1:5?device=a%26b%3D%25 ä",
                "subscribe://10.0.0.1:5?device=a%26b=%25%20%C3%A4"},
           Case{"pcap://eth0", "pcap://eth0"},
           Case{"pcap://any?filter=udp port 5 and ip[6:2] & 7 = 0",
                "pcap://any?filter=udp%20port%205%20and%20ip[6:2]%20&%207%20=%200"},
           Case{"pcap://eth0?filter=udp[0] %25 2 = 0",
                "pcap://eth0?filter=udp[0]%20%25%202%20=%200"},
           Case{"pcap:///tmp/a b.pcap", "pcap:///tmp/a%20b.pcap"},
           Case{"pcap://./what%3F.pcapng?filter=host ::1",
                "pcap://./what%3F.pcapng?filter=host%20::1"},
       }) {
    SCOPED_TRACE(each.text);
    const auto endpoint = Endpoint::parse(each.text);
    ASSERT_TRUE(endpoint.ok()) << endpoint.error().text();
    EXPECT_EQ(endpoint->text(), each.canonical);
    const auto again = Endpoint::parse(endpoint->text());
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_EQ(*again, *endpoint);
  }
}

TEST(Endpoint, IsCheckedWithoutLookingUpItsName) {
  for (const char* good : {":19960", "robot.invalid:5", "udp://robot.invalid:5?interface=lo",
                           "subscribe://robot.invalid:5?rate=2", "nats://robot.invalid/a"}) {
    EXPECT_TRUE(Endpoint::check(good)) << good;
  }
  EXPECT_EQ(Endpoint::check("nonsense:host:99999").error().text(),
            "an IPv6 address must be in brackets, as in [::1]:19960 (nonsense:host:99999)");
  EXPECT_FALSE(Endpoint::check("robot.invalid:99999"));
  EXPECT_FALSE(Endpoint::check("subscribe://robot.invalid"));
  EXPECT_FALSE(Endpoint::check("127.0.0.1:5?ttl=-1"));
}

TEST(Endpoint, StandardIsTheLoopbackGroup) {
  EXPECT_EQ(Endpoint::standard().text(), "udp://239.255.19.96:19960?interface=lo&ttl=0");
  EXPECT_EQ(Endpoint::parse(Endpoint::standard().text()).value(), Endpoint::standard());
}

struct Refusal {
  std::string_view text, reason;
};

TEST(Endpoint, RefusesWithTheReasonAndTheText) {
  for (const Refusal& each : {
           Refusal{"", "an endpoint is udp://HOST:PORT, HOST:PORT or :PORT"},
           Refusal{"127.0.0.1", "an endpoint needs a port, as in HOST:19960"},
           Refusal{"logs/cell.pcapng", "a capture file is given as pcap://./FILE"},
           Refusal{"[fe80::1]:7",
                   "a link-local address needs its interface, as in [fe80::1%eth0]:19960"},
           Refusal{"udp://127.0.0.1:", "a port is a whole number from 0 to 65535"},
           Refusal{"127.0.0.1:65536", "a port is a whole number from 0 to 65535"},
           Refusal{"127.0.0.1:007", "a port is a whole number from 0 to 65535"},
           Refusal{"127.0.0.1:+7", "a port is a whole number from 0 to 65535"},
           Refusal{"127.0.0.1:7/", "a port is a whole number from 0 to 65535"},
           Refusal{"::1:7", "an IPv6 address must be in brackets, as in [::1]:19960"},
           Refusal{"[::1:7", "the bracket of an IPv6 address is not closed"},
           Refusal{"[127.0.0.1]:7", "brackets are for IPv6 addresses"},
           Refusal{"[::1]7", "expected a colon and the port after the address"},
           Refusal{"[::x]:7", "this is not an IPv6 address"},
           Refusal{"300.1.1.1:7",
                   "an IPv4 address is four numbers from 0 to 255 separated by dots"},
           Refusal{"127.1:7", "an IPv4 address is four numbers from 0 to 255 separated by dots"},
           Refusal{"a b:7", "the host is neither an address nor a name"},
           Refusal{"http://127.0.0.1:7", "an endpoint begins with udp:// or is HOST:PORT or :PORT"},
           Refusal{"1.2.3.4:7?interface=lo", "interface= is for multicast groups only"},
           Refusal{"1.2.3.4:7?source=1.2.3.5", "source= is for multicast groups only"},
           Refusal{"239.0.0.1:7?interface=",
                   "interface= takes the name of a network interface, such as eth0"},
           Refusal{"239.0.0.1:7?interface=a/b",
                   "interface= takes the name of a network interface, such as eth0"},
           Refusal{"239.0.0.1:7?interface=sixteen-bytes-ab",
                   "interface= takes the name of a network interface, such as eth0"},
           Refusal{"239.0.0.1:7?ttl=256", "ttl= is a whole number from 0 to 255"},
           Refusal{"239.0.0.1:7?ttl=-1", "ttl= is a whole number from 0 to 255"},
           Refusal{"239.0.0.1:7?ttl=", "ttl= is a whole number from 0 to 255"},
           Refusal{"239.0.0.1:7?ttl=1&ttl=1", "ttl= is given twice"},
           Refusal{"[ff02::1%lo]:7?interface=lo", "interface= is given twice"},
           Refusal{"239.0.0.1:7?source=::1",
                   "source= and the group must both be IPv4 or both IPv6"},
           Refusal{"239.0.0.1:7?source=239.0.0.2", "source= takes the address of one sender"},
           Refusal{"239.0.0.1:7?source=0.0.0.0", "source= takes the address of one sender"},
           Refusal{"239.0.0.1:7?", "the options of an endpoint are interface=, ttl= and source="},
           Refusal{"239.0.0.1:7?ttl=1&",
                   "the options of an endpoint are interface=, ttl= and source="},
           Refusal{"subscribe://10.0.0.1", "an endpoint needs a port, as in HOST:19960"},
           Refusal{"subscribe://10.0.0.1:0", "subscribe:// needs the relay's port"},
           Refusal{"subscribe://:5", "subscribe:// needs the relay's host"},
           Refusal{"subscribe://239.0.0.1:5",
                   "a relay is asked at an address of its own, not at a group"},
           Refusal{"subscribe://10.0.0.1:5?ttl=1",
                   "the options of a subscribe:// endpoint are device=, signal=, source=, "
                   "min-change= and rate="},
           Refusal{"subscribe://10.0.0.1:5?",
                   "the options of a subscribe:// endpoint are device=, signal=, source=, "
                   "min-change= and rate="},
           Refusal{"subscribe://10.0.0.1:5?device",
                   "device= takes a pattern of 1 to 255 bytes, such as arm*"},
           Refusal{"subscribe://10.0.0.1:5?source=%01",
                   "source= takes a pattern of 1 to 255 bytes, such as arm*"},
           Refusal{"subscribe://10.0.0.1:5?source=%FF",
                   "source= takes a pattern of 1 to 255 bytes, such as arm*"},
           Refusal{"subscribe://10.0.0.1:5?source=a%2",
                   "a % in source= is written %25, as in URLs"},
           Refusal{"subscribe://10.0.0.1:5?source=a&source=a", "source= is given twice"},
           Refusal{"subscribe://10.0.0.1:5?min-change=0.5",
                   "min-change= takes joint=X, position=X, turn=X, signal=X and 'signal "
                   "PATTERN=X'"},
           Refusal{"subscribe://10.0.0.1:5?min-change=signal=0.5,",
                   "min-change= takes joint=X, position=X, turn=X, signal=X and 'signal "
                   "PATTERN=X'"},
           Refusal{"subscribe://10.0.0.1:5?min-change=signal=nan",
                   "min-change= needs a number greater than zero"},
           Refusal{"subscribe://10.0.0.1:5?rate=0", "rate= is a number of hertz above 0"},
           Refusal{"subscribe://10.0.0.1:5?rate=-1", "rate= is a number of hertz above 0"},
           Refusal{"subscribe://10.0.0.1:5?rate=inf", "rate= is a number of hertz above 0"},
           Refusal{"subscribe://10.0.0.1:5?rate=5Hz", "rate= is a number of hertz above 0"},
           Refusal{"subscribe://10.0.0.1:5?rate=1&rate=1", "rate= is given twice"},
           Refusal{"pcap://",
                   "pcap:// needs a network interface, such as eth0 or any, or a "
                   "capture file with a / in its name"},
           Refusal{"pcap://eth0?ttl=1", "the only option of a pcap:// endpoint is filter="},
           Refusal{"pcap://eth0?filter=",
                   "filter= takes what tcpdump takes, such as udp port 5000"},
           Refusal{"pcap://eth0?filter=100%", "a % in filter= is written %25, as in URLs"},
           Refusal{"pcap://eth0?filter=a%00b", "a % in filter= is written %25, as in URLs"},
           Refusal{"pcap:///tmp/%zz", "a % in a file's name is written %25, as in URLs"},
           Refusal{"239.0.0.1:7?speed=1",
                   "the options of an endpoint are interface=, ttl= and source="},
       }) {
    SCOPED_TRACE(each.text);
    const auto endpoint = Endpoint::parse(each.text);
    ASSERT_FALSE(endpoint.ok()) << endpoint->text();
    EXPECT_EQ(endpoint.error().kind, ErrorKind::bad_argument);
    EXPECT_EQ(endpoint.error().what, each.reason);
    EXPECT_EQ(endpoint.error().where, each.text);
  }
}

TEST(Endpoint, ShowsHostileTextAsPrintableAndShort) {
  const auto endpoint = Endpoint::parse("a\x1b[2J\n:" + std::string(900, '9'));
  ASSERT_FALSE(endpoint.ok());
  EXPECT_TRUE(endpoint.error().where.starts_with("a\\x1b[2J\\x0a:999"));
  EXPECT_LE(endpoint.error().where.size(), 100U);
  EXPECT_EQ(Endpoint::parse("Prüfstand №1").error().where, "Prüfstand №1");
  EXPECT_FALSE(Endpoint::parse(std::string(100'000, ':')).ok());
}

/// Every endpoint that can be built parses back to itself.
TEST(Endpoint, RoundTripsWhateverItsFields) {
  std::mt19937 random(1996);
  const auto byte = [&] { return static_cast<std::uint8_t>(random() & 0xFFU); };
  for (int round = 0; round < 5'000; ++round) {
    Endpoint endpoint;
    endpoint.address.is_ipv6 = random() % 2 != 0;
    const std::size_t length = endpoint.address.is_ipv6 ? 16 : 4;
    for (std::size_t i = 0; i < length; ++i) {
      endpoint.address.address[i] = random() % 3 != 0 ? byte() : std::uint8_t{0};
    }
    if (random() % 2 != 0) endpoint.address.address[0] = endpoint.address.is_ipv6 ? 0xFF : 0xEF;
    endpoint.address.port = static_cast<std::uint16_t>(random());
    if (random() % 2 != 0) endpoint.ttl = byte();
    if (endpoint.isMulticast() && random() % 2 != 0) endpoint.interface = "eth0.7:1";
    if (endpoint.isMulticast() && random() % 2 != 0) {
      SocketAddress source;
      source.is_ipv6 = endpoint.address.is_ipv6;
      for (std::size_t i = 0; i < length; ++i) source.address[i] = byte();
      source.address[0] = 0x20;
      endpoint.source = source;
    }
    const auto again = Endpoint::parse(endpoint.text());
    ASSERT_TRUE(again.ok()) << again.error().text();
    ASSERT_EQ(*again, endpoint) << endpoint.text();
  }
}

TEST(Endpoint, WatchedTrafficRoundTripsWhateverItsFilterAndFile) {
  std::mt19937 random(4);
  for (int round = 0; round < 2'000; ++round) {
    const auto text = [&] {
      std::string bytes;
      for (unsigned i = 0; i < 1 + random() % 12; ++i) {
        const char c = static_cast<char>(random() % 256);
        if (c != '\0' && c != '\n' && c != '\r') bytes.push_back(c);
      }
      return bytes;
    };
    Endpoint endpoint;
    endpoint.scheme = Endpoint::Scheme::pcap;
    if (random() % 2 != 0) endpoint.filter = text() + "x";
    if (random() % 2 != 0) {
      endpoint.file = "/" + text();
    } else {
      endpoint.interface = "eth0.7";
    }
    const std::string written = endpoint.text();
    EXPECT_EQ(written.find_first_of(" \n\t"), written.npos);
    const auto again = Endpoint::parse(written);
    ASSERT_TRUE(again.ok()) << again.error().text();
    ASSERT_EQ(*again, endpoint) << written;
  }
}

TEST(Endpoint, ASubscriptionRoundTripsWhateverItsPatterns) {
  std::mt19937 random(16);
  const auto pattern = [&] {
    constexpr std::array<std::string_view, 8> kPieces{"arm", "*", "?", "[a-c]",
                                                      "&",   "%", " ", "\u00e9"};
    std::string text;
    while (random() % 8 != 0 && text.size() < 250) text += kPieces[random() % kPieces.size()];
    return text;
  };
  for (int round = 0; round < 2'000; ++round) {
    Endpoint endpoint;
    endpoint.scheme = Endpoint::Scheme::subscribe;
    endpoint.address.is_ipv6 = random() % 2 != 0;
    endpoint.address.address[0] = 0x20;
    for (std::size_t i = 1; i < (endpoint.address.is_ipv6 ? 16U : 4U); ++i) {
      endpoint.address.address[i] = static_cast<std::uint8_t>(random());
    }
    endpoint.address.port = static_cast<std::uint16_t>(1 + random() % 65'535);
    endpoint.selection.source = pattern();
    endpoint.selection.device = pattern();
    endpoint.selection.signal = pattern();
    if (random() % 2 != 0) endpoint.selection.min_change = "turn=1,signal " + pattern() + "x=2.5";
    if (random() % 2 != 0) {
      endpoint.selection.rate_hz = std::ldexp(1 + static_cast<double>(random()) / 7, -20);
    }
    const std::string written = endpoint.text();
    EXPECT_EQ(written.find_first_of(" \n\t"), written.npos);
    const auto again = Endpoint::parse(written);
    ASSERT_TRUE(again.ok()) << again.error().text();
    ASSERT_EQ(*again, endpoint) << written;
  }
  Endpoint longest;
  longest.scheme = Endpoint::Scheme::subscribe;
  longest.address.address = {10, 0, 0, 1};
  longest.address.port = 1;
  longest.selection.source = longest.selection.device = std::string(255, '&');
  EXPECT_EQ(Endpoint::parse(longest.text()).value(), longest);
  EXPECT_FALSE(Endpoint::parse("subscribe://10.0.0.1:1?source=" + std::string(256, 'a')).ok());
}

/// Every accepted text is canonical after one round; nothing crashes.
TEST(Endpoint, AnyTextIsRefusedOrReadsBack) {
  std::mt19937 random(7);
  const std::string_view alphabet = "0123456789.:[]?&=%/-ufedpslo";
  const std::array seeds{std::string("udp://239.255.19.96:19960?interface=lo&ttl=0&source=1.2.3.4"),
                         std::string("[ff02::1%lo]:5?ttl=9"), std::string("127.0.0.1:19960")};
  for (int round = 0; round < 20'000; ++round) {
    std::string text = seeds[random() % seeds.size()];
    for (unsigned change = 0; change < 1 + random() % 3; ++change) {
      const std::size_t at = random() % text.size();
      if (random() % 2 != 0) text.erase(at, 1);
      text.insert(std::min(at, text.size()), 1, alphabet[random() % alphabet.size()]);
    }
    // Names would be looked up; this test does not use the network.
    const std::size_t scheme_end = text.find("://");
    const std::string host = scheme_end == text.npos ? text : text.substr(scheme_end + 3);
    const std::string before_port = host.substr(0, host.find(':'));
    if (before_port.find_first_of("ufedpslo-") != before_port.npos) continue;
    const auto endpoint = Endpoint::parse(text);
    if (!endpoint) continue;
    const auto again = Endpoint::parse(endpoint->text());
    ASSERT_TRUE(again.ok()) << text;
    ASSERT_EQ(*again, *endpoint) << text;
  }
}

}  // namespace
}  // namespace rocinante
