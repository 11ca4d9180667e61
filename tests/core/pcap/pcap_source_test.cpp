#include "core/pcap/pcap_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <fstream>

#include "core/transport/open_source.h"
#include "tests/core/pcap/frames.h"
#include "tests/support/network_namespace.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;
using test::ethernetFrame;
using test::ipPackets;
using test::NetworkNamespace;
using test::Sent;
using test::sent;
using test::TemporaryFolder;
using ::testing::HasSubstr;

Endpoint captureEndpoint(std::string_view text) { return Endpoint::parse(text).value(); }

struct Seen {
  std::string from, to, payload;
  WallTime time;
  bool operator==(const Seen&) const = default;
};

std::vector<Seen> receiveSome(DatagramSource& source) {
  std::vector<Seen> seen;
  const auto batch = source.receive();
  EXPECT_TRUE(batch.ok()) << batch.error().text();
  if (!batch) return seen;
  for (const ReceivedDatagram& each : *batch) {
    EXPECT_NE(each.destination, nullptr);
    seen.push_back({each.sender.text(), each.destination->text(), std::string(textOf(each.payload)),
                    each.kernel_time});
  }
  return seen;
}

/// A capture file as written by libpcap's own tools, with nanoseconds, in this machine's byte
/// order.
class CaptureFile {
 public:
  explicit CaptureFile(std::uint32_t link = 1) {
    number(0xA1B23C4D);
    number(0x00040002);  // version 2.4
    number(0);
    number(0);
    number(262'144);
    number(link);
  }
  CaptureFile& add(std::int64_t time_ns, const Bytes& frame, std::size_t kept = 1U << 20U) {
    number(static_cast<std::uint32_t>(time_ns / 1'000'000'000));
    number(static_cast<std::uint32_t>(time_ns % 1'000'000'000));
    kept = std::min(kept, frame.size());
    number(static_cast<std::uint32_t>(kept));
    number(static_cast<std::uint32_t>(frame.size()));
    bytes_ += textOf(ByteView(frame).first(kept));
    return *this;
  }
  CaptureFile& cut(std::size_t bytes) {
    bytes_.resize(bytes_.size() - bytes);
    return *this;
  }
  /// The endpoint for this file.
  std::string write(const std::filesystem::path& path, std::string_view filter = {}) const {
    std::ofstream(path, std::ios::binary) << bytes_;
    Endpoint endpoint;
    endpoint.scheme = Endpoint::Scheme::pcap;
    endpoint.file = path.string();
    endpoint.filter = filter;
    return endpoint.text();
  }

 private:
  void number(std::uint32_t value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  std::string bytes_;
};

std::vector<Seen> readAll(DatagramSource& source) {
  std::vector<Seen> all;
  while (!source.ended() && !testing::Test::HasFailure()) {
    for (Seen& each : receiveSome(source)) all.push_back(std::move(each));
  }
  return all;
}

const Sent kFirst = sent("10.0.0.1", 4'000, "10.0.0.2", 5'000, "first");
const Sent kSecond = sent("fd00::1", 4'001, "fd00::2", 6'000, "second");

TEST(PcapSource, ReadsAFileWithItsOwnTimesToTheNanosecond) {
  const TemporaryFolder folder;
  CaptureFile file;
  file.add(1'000'000'000'000'000'123, ethernetFrame(ipPackets(kFirst).at(0)));
  file.add(999'999'999'999'999'999, ethernetFrame(ipPackets(kSecond).at(0), {5}));
  const auto source = openSource(captureEndpoint(file.write(folder / "a b.pcap")));
  ASSERT_TRUE(source.ok()) << source.error().text();
  EXPECT_THAT(readAll(**source),
              testing::ElementsAre(Seen{"10.0.0.1:4000", "10.0.0.2:5000", "first",
                                        WallTime(Nanoseconds(1'000'000'000'000'000'123))},
                                   Seen{"[fd00::1]:4001", "[fd00::2]:6000", "second",
                                        WallTime(Nanoseconds(999'999'999'999'999'999))}));
  EXPECT_TRUE((*source)->receive()->empty());
  EXPECT_EQ((*source)->counts(), InputCounts());
  EXPECT_EQ((*source)->droppedByNow().value(), 0U);
}

TEST(PcapSource, TakesWhatTheFilterTakesAndAllFragmentsOfIt) {
  Sent large = kFirst;
  large.payload.assign(4'000, 'x');
  Sent other = large;
  other.to.port = 5'001;
  CaptureFile file;
  for (const std::vector<unsigned>& vlans : {std::vector<unsigned>{}, std::vector<unsigned>{5}}) {
    for (const Bytes& each : ipPackets(large, 1'480, 1)) file.add(1, ethernetFrame(each, vlans));
    for (const Bytes& each : ipPackets(other, 1'480, 2)) file.add(2, ethernetFrame(each, vlans));
    file.add(3, ethernetFrame(ipPackets(kFirst).at(0), vlans));
    file.add(3, ethernetFrame(ipPackets(kSecond).at(0), vlans));
  }
  const TemporaryFolder folder;
  const auto count = [&](std::string_view filter) {
    const auto source = openSource(captureEndpoint(file.write(folder / "x.pcap", filter)));
    EXPECT_TRUE(source.ok()) << source.error().text();
    return source ? readAll(**source).size() : 0;
  };
  EXPECT_EQ(count(""), 8U);
  // Behind tags, too: the filter is about the datagram.
  EXPECT_EQ(count("port 5000"), 4U);
  EXPECT_EQ(count("udp dst port 5001 or ip6"), 4U);
  EXPECT_EQ(count("vlan 5 and port 5000"), 2U);
  EXPECT_EQ(count("vlan and not port 5000"), 2U);
  EXPECT_EQ(count("tcp"), 0U);
}

TEST(PcapSource, SaysWhatIsWrongWithAFileOrAFilter) {
  const TemporaryFolder folder;
  const auto error = [](const std::string& text) {
    const auto source = openSource(captureEndpoint(text));
    return source ? Error{ErrorKind::refused, "opened", ""} : source.error();
  };
  EXPECT_EQ(error("pcap://" + (folder / "none.pcap").string()).kind, ErrorKind::not_found);
  std::ofstream(folder / "text.pcap") << "this is no capture, but it is long enough for one";
  EXPECT_EQ(error("pcap://" + (folder / "text.pcap").string()).kind, ErrorKind::damaged);
  const Error filter = error(CaptureFile().write(folder / "x.pcap", "prot 5"));
  EXPECT_EQ(filter.kind, ErrorKind::bad_argument);
  EXPECT_THAT(filter.what, HasSubstr("libpcap rejects this filter: "));
  const Error link = error(CaptureFile(147).write(folder / "y.pcap"));
  EXPECT_EQ(link.kind, ErrorKind::unsupported);
}

TEST(PcapSource, AFileThatBreaksOffIsReadUpToThere) {
  CaptureFile file;
  for (int i = 0; i < 3; ++i) file.add(i, ethernetFrame(ipPackets(kFirst).at(0)));
  file.cut(1);
  const TemporaryFolder folder;
  const auto source = openSource(captureEndpoint(file.write(folder / "x.pcap")));
  ASSERT_TRUE(source.ok());
  EXPECT_EQ(receiveSome(**source).size(), 2U);
  const auto batch = (*source)->receive();
  ASSERT_FALSE(batch.ok());
  EXPECT_EQ(batch.error().kind, ErrorKind::damaged);
}

TEST(PcapSource, CountsWhatNeverBecameWholeAtTheEndOfAFile) {
  Sent large = kFirst;
  large.payload.assign(4'000, 'x');
  CaptureFile file;
  file.add(1, ethernetFrame(ipPackets(large, 1'480).at(0)));
  file.add(2, ethernetFrame(ipPackets(kFirst).at(0)), 50);
  const TemporaryFolder folder;
  const auto source = openSource(captureEndpoint(file.write(folder / "x.pcap")));
  ASSERT_TRUE(source.ok());
  const auto all = readAll(**source);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].payload, kFirst.payload);  // padding apart, all of it was kept
  EXPECT_EQ((*source)->counts().incomplete, 1U);
}

TEST(PcapSource, ReadsRealCapturesWithTheirFragments) {
  ROCINANTE_NEEDS_SHARED_DATA("captures");
  const auto count = [](const char* name) {
    const std::string path = test::sharedData("captures").string() + "/" + name;
    const auto source = openSource(captureEndpoint("pcap://" + path));
    EXPECT_TRUE(source.ok()) << source.error().text();
    std::vector<std::size_t> sizes;
    if (!source) return sizes;
    for (const Seen& each : readAll(**source)) sizes.push_back(each.payload.size());
    EXPECT_EQ((*source)->counts().incomplete, 0U);
    EXPECT_EQ((*source)->counts().malformed, 0U);
    return sizes;
  };
  const auto lidar = count("ouster/OS-1-32-G_v2.1.1_1024x10.pcap");
  EXPECT_EQ(lidar.size(), 64U);
  EXPECT_EQ(std::ranges::count(lidar, 6'464U), 64);
  const auto radar = count("navico_br24_radar/BR24.pcap");
  EXPECT_EQ(radar.size(), 35U);
  EXPECT_EQ(std::ranges::count(radar, 17'160U), 26);
}

TEST(PcapSource, SaysWhichInterfacesThereAre) {
  const auto source = openSource(captureEndpoint("pcap://nowhere0"));
  ASSERT_FALSE(source.ok());
  if (source.error().what.find("CAP_NET_RAW") != std::string::npos) {
    GTEST_SKIP() << "no right to capture here";
  }
  EXPECT_THAT(source.error().what, HasSubstr("there is no network interface nowhere0"));
}

TEST(PcapSource, RefusesAnInterfaceWithoutNanoseconds) {
  const auto source = openSource(captureEndpoint("pcap://nflog"));
  ASSERT_FALSE(source.ok());
  EXPECT_EQ(source.error().kind, ErrorKind::refused);
  EXPECT_THAT(source.error().what, HasSubstr("cannot watch nflog: "));
  EXPECT_THAT(source.error().what, HasSubstr("time stamp precision"));
}

/// Receives until there are `count`, or none arrived for two seconds.
std::vector<Seen> receiveAll(DatagramSource& source, std::size_t count) {
  std::vector<Seen> all;
  for (int idle = 0; all.size() < count && idle < 100; ++idle) {
    pollfd readable{source.fileDescriptor(), POLLIN, 0};
    ::poll(&readable, 1, 20);
    for (Seen& each : receiveSome(source)) {
      all.push_back(std::move(each));
      idle = 0;
    }
  }
  return all;
}

TEST(PcapSource, WatchesTrafficThatHasItsReceiver) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  for (const std::string_view interface : {"lo", "any"}) {
    for (const std::string_view host : {"127.0.0.1:0", "[::1]:0"}) {
      SCOPED_TRACE(std::string(interface) + " " + std::string(host));
      auto receiver = UdpReceiver::open(captureEndpoint(host)).value();
      Endpoint to = receiver.endpoint();
      to.address = receiver.boundAddress();
      auto sender = UdpSender::open(to).value();
      Endpoint watch = captureEndpoint("pcap://" + std::string(interface));
      watch.filter = "udp port " + std::to_string(to.address.port);
      const auto source = openSource(watch);
      ASSERT_TRUE(source.ok()) << source.error().text();
      const auto before = std::chrono::system_clock::now();
      std::vector<std::string> payloads;
      for (const std::size_t size : {0U, 1U, 100U, 1'472U, 9'000U, 65'507U}) {
        payloads.emplace_back(size, static_cast<char>('a' + payloads.size()));
        ASSERT_TRUE(sender.send(bytesOf(payloads.back())).ok());
      }
      const auto seen = receiveAll(**source, payloads.size());
      ASSERT_EQ(seen.size(), payloads.size());
      for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_EQ(seen[i].payload, payloads[i]);
        EXPECT_EQ(seen[i].from, sender.localAddress().text());
        EXPECT_EQ(seen[i].to, to.address.text());
        EXPECT_GE(seen[i].time, before - milliseconds(5));
        EXPECT_LE(seen[i].time, std::chrono::system_clock::now() + milliseconds(5));
      }
      EXPECT_EQ((*source)->droppedByNow().value(), 0U);
    }
  }
}

TEST(PcapSource, PutsLiveFragmentsTogetherAndSurvivesItsInterface) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  const std::string make =
      "ip link add cell0 type veth peer name robot0 && ip addr add 10.9.0.1/24 dev cell0 && "
      "ip link set cell0 up && ip link set robot0 up";
  ASSERT_TRUE(NetworkNamespace::run(make));
  const auto source = openSource(captureEndpoint("pcap://robot0?filter=udp port 5000"));
  ASSERT_TRUE(source.ok()) << source.error().text();
  const std::string payload(40'000, 'x');
  const auto send = [&] {
    auto sender = UdpSender::open(captureEndpoint("239.1.2.3:5000?interface=cell0"));
    return sender.ok() && sender->send(bytesOf(payload)).ok();
  };
  const auto heard = [&] {
    for (int attempt = 0; attempt < 200; ++attempt) {
      (void)(*source)->maintain();
      if (!send()) {
        ::poll(nullptr, 0, 10);
        continue;
      }
      for (int wait = 0; wait < 5; ++wait) {
        pollfd readable{(*source)->fileDescriptor(), POLLIN, 0};
        ::poll(&readable, 1, 10);
        const auto seen = receiveSome(**source);
        if (seen.empty()) continue;
        EXPECT_EQ(seen[0].payload, payload);
        EXPECT_EQ(seen[0].to, "239.1.2.3:5000");
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(heard());
  ASSERT_TRUE(NetworkNamespace::run("ip link set robot0 down && ip link set robot0 up"));
  EXPECT_TRUE(heard()) << "after it was down";
  ASSERT_TRUE(NetworkNamespace::run("ip link del cell0"));
  std::string said;
  for (int wait = 0; wait < 300 && said.empty(); ++wait) {
    (void)receiveSome(**source);
    said = (*source)->maintain().value_or("");
    ::poll(nullptr, 0, 10);
  }
  EXPECT_THAT(said, HasSubstr("is gone; nothing is captured until it returns"));
  ASSERT_TRUE(NetworkNamespace::run(make));
  EXPECT_TRUE(heard()) << "after it was made anew";
}

}  // namespace
}  // namespace rocinante
