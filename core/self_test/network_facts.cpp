#include "core/self_test/network_facts.h"

#include <fmt/format.h>
#include <linux/capability.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>

#include "core/base/size_text.h"
#include "core/net/receive_buffer.h"
#include "core/net/udp_socket.h"
#include "core/pcap/pcap_source.h"
#include "core/self_test/file_capability.h"

namespace rocinante {
namespace {

using State = SelfTestFact::State;
using SteadyClock = std::chrono::steady_clock;

constexpr auto kLongestWait = std::chrono::seconds(1);
// About the size of a datagram of a robot's joint values.
constexpr double kUsualBytes = 100;

/// Sends a datagram from and to this machine and receives it. `listen_at` has port 0.
Status sendAndHear(const Endpoint& listen_at) {
  UdpReceiver::Options options;
  options.receive_buffer_bytes = 1 << 16;
  Result<UdpReceiver> receiver = UdpReceiver::open(listen_at, options);
  if (!receiver) return receiver.error();
  Endpoint to = listen_at;
  to.address.port = receiver->boundAddress().port;
  Result<UdpSender> sender = UdpSender::open(to);
  if (!sender) return sender.error();
  const std::string text = fmt::format("rocinante self-test {}", ::getpid());
  if (Status sent = sender->send(bytesOf(text)); !sent) return sent;
  for (const auto until = SteadyClock::now() + kLongestWait;;) {
    const auto datagrams = receiver->receive();
    if (!datagrams) return datagrams.error();
    for (const ReceivedDatagram& datagram : *datagrams) {
      if (textOf(datagram.payload) == text) return {};
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - SteadyClock::now());
    if (left.count() <= 0) break;
    pollfd waiting{receiver->fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, static_cast<int>(left.count()));
  }
  return Error{ErrorKind::refused, "a datagram was sent and did not arrive", to.text()};
}

}  // namespace

SelfTestFact multicastFact() {
  Endpoint group = Endpoint::standard();
  group.address.port = 0;
  const Status heard = sendAndHear(group);
  if (heard) {
    return {"multicast", State::ok,
            fmt::format("{} on lo: sent and heard", group.address.hostText()), ""};
  }
  return {"multicast", State::missing, heard.error().text(),
          "bring the loopback interface up (sudo ip link set lo up), or give every program a "
          "unicast endpoint"};
}

SelfTestFact ipv6Fact() {
  Endpoint here;
  here.address.is_ipv6 = true;
  here.address.address[15] = 1;
  const Status heard = sendAndHear(here);
  if (heard) return {"ipv6", State::ok, "[::1]: sent and heard", ""};
  return {"ipv6", State::limited, heard.error().text(),
          "use IPv4 endpoints, or enable IPv6 (sudo sysctl -w net.ipv6.conf.all.disable_ipv6=0)"};
}

SelfTestFact judgeReceiveBuffer(std::uint64_t granted_bytes, std::uint64_t asked_bytes) {
  const double charged = static_cast<double>(chargedBytes(static_cast<std::size_t>(kUsualBytes)));
  const double rate = static_cast<double>(granted_bytes) / charged /
                      std::chrono::duration<double>(kReceiveStall).count();
  SelfTestFact fact{"receive_buffer", State::ok,
                    fmt::format("{} of {}: holds 50 ms of {:.0f} datagrams/s of {:.0f} bytes",
                                sizeText(granted_bytes), sizeText(asked_bytes), rate, kUsualBytes),
                    ""};
  if (granted_bytes >= asked_bytes) return fact;
  fact.state = State::limited;
  // The kernel doubles the requested size, up to net.core.rmem_max.
  fact.advice = fmt::format(
      "for more: sudo sysctl -w net.core.rmem_max={0}, and for good: echo net.core.rmem_max={0} | "
      "sudo tee /etc/sysctl.d/60-rocinante.conf",
      asked_bytes / 2);
  return fact;
}

SelfTestFact receiveBufferFact() {
  const UdpReceiver::Options options;
  Endpoint anywhere;  // 0.0.0.0:0
  const Result<UdpReceiver> receiver = UdpReceiver::open(anywhere, options);
  if (!receiver) {
    return {"receive_buffer", State::missing, receiver.error().text(),
            "allow this program to open UDP sockets"};
  }
  return judgeReceiveBuffer(receiver->receiveBufferBytes(),
                            2 * static_cast<std::uint64_t>(options.receive_buffer_bytes));
}

SelfTestFact captureFact(const std::filesystem::path& programs) {
  Endpoint everything;
  everything.scheme = Endpoint::Scheme::pcap;
  everything.interface = "any";
  PcapOptions options;
  options.buffer_bytes = 1 << 20;
  const auto source = openPcap(everything, options);
  if (source) return {"capture", State::ok, "pcap:// may watch every interface", ""};
  if (source.error().kind == ErrorKind::unsupported) {
    return {"capture", State::limited, source.error().what, "build with libpcap (ROCINANTE_PCAP)"};
  }
  const auto record = programs / "rocinante-record";
  if (fileHasCapability(record, CAP_NET_RAW)) {
    return {"capture", State::ok, fmt::format("{} has cap_net_raw", record.string()), ""};
  }
  return {"capture", State::limited, "pcap:// may not watch traffic",
          fmt::format("run it as root (a container with --cap-add NET_RAW), or once: sudo setcap "
                      "cap_net_raw+ep {} (and rocinante-spy beside it)",
                      record.string())};
}

}  // namespace rocinante
