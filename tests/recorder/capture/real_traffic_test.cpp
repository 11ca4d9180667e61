#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "core/base/hash.h"
#include "core/log/log_reader.h"
#include "core/net/endpoint.h"
#include "tests/support/network_namespace.h"
#include "tests/support/programs.h"
#include "tests/support/shared_data.h"

// Captured real traffic, put on a virtual wire, recorded as its receiver and by
// watching, and compared with tshark's reading of the capture.
namespace rocinante {
namespace {

using test::NetworkNamespace;
using test::Program;
using test::ProgramResult;
using test::TemporaryFolder;

/// Payloads in hexadecimal, in order, by destination ("236.6.7.8:6678").
using Traffic = std::map<std::string, std::vector<std::string>>;

bool hasTool(const std::string& name) { return NetworkNamespace::run("command -v " + name); }

/// The payloads that tshark finds in a capture, with fragments reassembled.
Traffic byTshark(const std::filesystem::path& capture, const std::filesystem::path& folder) {
  Traffic traffic;
  const std::filesystem::path text = folder / "tshark.txt";
  const std::string command = "tshark -n -r '" + capture.string() +
                              "' -Y 'udp && !icmp' -T fields -e ip.dst -e udp.dstport -e "
                              "udp.payload > '" +
                              text.string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string host, port, payload;
    fields >> host >> port >> payload;
    traffic[host + ":" + port].push_back(payload);
  }
  return traffic;
}

/// The payloads of a log, by the same keys.
Traffic inLog(const std::filesystem::path& path) {
  Traffic traffic;
  auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok()) << log.error().text();
  if (!log) return traffic;
  for (auto message = log->next(); message && *message; message = log->next()) {
    if (!(*message)->channel->captured()) continue;
    traffic[(*message)->channel->metadata.at("local")].push_back(hexOf((*message)->payload));
  }
  EXPECT_TRUE(log->summary().complete);
  EXPECT_TRUE(log->losses().empty());
  return traffic;
}

std::size_t countOf(const Traffic& traffic) {
  std::size_t count = 0;
  for (const auto& [to, payloads] : traffic) count += payloads.size();
  return count;
}

void expectSame(const Traffic& expected, const Traffic& found) {
  EXPECT_EQ(countOf(found), countOf(expected));
  for (const auto& [to, payloads] : expected) {
    SCOPED_TRACE(to);
    const auto same = found.find(to);
    ASSERT_NE(same, found.end());
    ASSERT_EQ(same->second.size(), payloads.size());
    for (std::size_t i = 0; i < payloads.size(); ++i) {
      ASSERT_TRUE(same->second[i] == payloads[i]) << "datagram " << i << " differs";
    }
  }
}

/// A wire from robot0 to cell0, which is 10.9.0.1 and takes packets of any sender and length.
constexpr const char* kWire =
    "ip link add cell0 type veth peer name robot0 && ip link set robot0 mtu 9000 && "
    "ip link set cell0 mtu 9000 address 02:00:00:00:00:01 && ip addr add 10.9.0.1/24 dev cell0 && "
    "sysctl -qw net.ipv4.conf.all.rp_filter=0 && sysctl -qw net.ipv4.conf.cell0.rp_filter=0 && "
    "ip link set robot0 up && ip link set cell0 up";

class RealTraffic : public testing::Test {
 protected:
  void SetUp() override {
    ROCINANTE_NEEDS_SHARED_DATA("captures");
    for (const char* tool : {"tcprewrite", "tshark"}) {
      if (!hasTool(tool)) GTEST_SKIP() << "no " << tool << " here (packages tcpreplay, tshark)";
    }
    ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
    ASSERT_TRUE(NetworkNamespace::run(kWire));
  }

  Program start(std::vector<std::string> endpoints, const char* log, std::size_t count) {
    endpoints.insert(endpoints.end(), {"-o", (folder / log).string(), "--max-packets",
                                       std::to_string(count), "--json"});
    Program program = Program::start("rocinante-record", endpoints);
    program.waitForLine("recording ");
    return program;
  }

  /// Replays `capture` and records it twice: as its receiver, and by watching.
  void expectRecorded(const std::filesystem::path& capture, const Traffic& expected) {
    std::vector<std::string> endpoints;
    for (const auto& [to, payloads] : expected) {
      const bool group = Endpoint::parse(to).value().isMulticast();
      endpoints.push_back(to + (group ? "?interface=cell0" : ""));
    }
    const std::size_t count = countOf(expected);
    Program receiver = start(endpoints, "received.mcap", count);
    Program watcher = start({"pcap://cell0"}, "watched.mcap", count);
    // Not tcpreplay: from 4.5 on it cuts frames at 4,096 bytes.
    ASSERT_TRUE(NetworkNamespace::run("python3 " ROCINANTE_SOURCE_DIR
                                      "/tests/support/send_frames.py robot0 '" +
                                      capture.string() + "'"));
    for (Program* each : {&receiver, &watcher}) {
      const ProgramResult result = each->finish(std::chrono::milliseconds(20'000));
      EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    {
      SCOPED_TRACE("as the receiver");
      expectSame(expected, inLog(folder / "received.mcap"));
    }
    SCOPED_TRACE("by watching");
    expectSame(expected, inLog(folder / "watched.mcap"));
  }

  NetworkNamespace network;
  TemporaryFolder folder;
};

TEST_F(RealTraffic, ARadarOnThreeGroupsInFragments) {
  const auto capture = test::sharedData("captures") / "navico_br24_radar/BR24.pcap";
  const Traffic expected = byTshark(capture, folder / "");
  ASSERT_EQ(countOf(expected), 35U);
  ASSERT_EQ(expected.size(), 3U);
  // What the capturing machine itself sent has no checksums yet: its network card fills them in.
  const std::filesystem::path adapted = folder / "radar.pcap";
  ASSERT_TRUE(NetworkNamespace::run("tcprewrite -i '" + capture.string() + "' -o '" +
                                    adapted.string() + "' --fixcsum"));
  expectRecorded(adapted, expected);

  // The capture file, read directly.
  const ProgramResult read = test::runProgram(
      "rocinante-record", {"pcap://" + capture.string(), "-o", (folder / "read.mcap").string()});
  EXPECT_EQ(read.exit_code, 0) << read.err;
  expectSame(expected, inLog(folder / "read.mcap"));
}

TEST_F(RealTraffic, ALidarOfLargeDatagrams) {
  const auto capture = test::sharedData("captures") / "ouster/OS-1-32-G_v2.1.1_1024x10.pcap";
  const std::filesystem::path adapted = folder / "lidar.pcap";
  // It was captured on a loopback: the kernel accepts none of its addresses from a wire.
  ASSERT_TRUE(NetworkNamespace::run(
      "tcprewrite -i '" + capture.string() + "' -o '" + adapted.string() +
      "' --srcipmap=127.0.0.1/32:10.9.0.2/32 --dstipmap=127.0.0.1/32:10.9.0.1/32 "
      "--enet-dmac=02:00:00:00:00:01 --enet-smac=02:00:00:00:00:02 --fixcsum"));
  const Traffic expected = byTshark(adapted, folder / "");
  ASSERT_EQ(countOf(expected), 64U);
  const Traffic original = byTshark(capture, folder / "");
  ASSERT_EQ(original.begin()->second, expected.begin()->second);
  expectRecorded(adapted, expected);
}

}  // namespace
}  // namespace rocinante
