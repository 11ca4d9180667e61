#include "core/self_test/machine_facts.h"

#include <endian.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/capability.h>
#include <poll.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <sys/timex.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "core/base/figure_text.h"
#include "core/base/file_lock.h"
#include "core/base/loaded_module.h"
#include "core/kinematics/sdformat_module.h"
#include "core/net/receive_buffer.h"
#include "core/net/udp_socket.h"
#include "core/pcap/pcap_source.h"

namespace rocinante {

namespace {

using State = SelfTestFact::State;
using SteadyClock = std::chrono::steady_clock;
using Path = std::filesystem::path;

// As requested by player/send/realtime.cpp and recorder/capture/prompt_thread.cpp.
constexpr int kPlayPriority = 10;
constexpr int kRecordNice = -10;
// One chunk of a log's end, as log_writer allocates ahead.
constexpr off_t kAhead = 1 << 16;

// About the size of a datagram of a robot's joint values.
constexpr double kUsualBytes = 100;

bool fileHasCapability(const Path& program, int capability) {
  vfs_ns_cap_data granted{};
  if (::getxattr(program.c_str(), "security.capability", &granted, sizeof granted) < 0) {
    return false;
  }
  const std::uint32_t permitted = le32toh(granted.data[0].permitted);  // the lower 32
  return (le32toh(granted.magic_etc) & VFS_CAP_FLAGS_EFFECTIVE) != 0 &&
         (permitted >> capability & 1U) != 0;
}

SelfTestFact sdfFact(const Path&) {
  const Result<void*> module = loadModule("librocinante_sdformat.so");
  if (!module) {
    return {"sdf", State::limited, "SDF models cannot be read: " + module.error().text(),
            "install the package that has it (rocinante built with libsdformat), or use URDF"};
  }
  const auto abi = reinterpret_cast<RocinanteSdfAbi>(functionOf(*module, "rocinante_sdf_abi"));
  if (abi == nullptr || abi() != ROCINANTE_SDF_ABI) {
    return {"sdf", State::limited, "librocinante_sdformat.so has a different version",
            "install programs and modules of one version"};
  }
  return {"sdf", State::ok, "SDF models can be read", ""};
}

constexpr auto kLongestWait = std::chrono::seconds(1);
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

SelfTestFact multicastFact(const Path&) {
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

SelfTestFact ipv6Fact(const Path&) {
  Endpoint here;
  here.address.is_ipv6 = true;
  here.address.address[15] = 1;
  const Status heard = sendAndHear(here);
  if (heard) return {"ipv6", State::ok, "[::1]: sent and heard", ""};
  return {"ipv6", State::limited, heard.error().text(),
          "use IPv4 endpoints, or enable IPv6 (sudo sysctl -w net.ipv6.conf.all.disable_ipv6=0)"};
}

SelfTestFact receiveBufferFact(const Path&) {
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

SelfTestFact captureFact(const Path& programs) {
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

/// The three ways to give a right to `program`.
std::string grantAdvice(const Path& program, const char* unit_line, const char* limits_line) {
  return fmt::format(
      "once: sudo setcap cap_sys_nice+ep {}; or in a systemd unit {}; or in "
      "/etc/security/limits.conf USER - {}; a container needs --cap-add SYS_NICE",
      program.string(), unit_line, limits_line);
}

SelfTestFact schedulingFact(const Path& programs) {
  sched_param parameters{};
  parameters.sched_priority = kPlayPriority;
  if (::sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) == 0) {
    return {"scheduling", State::ok, "SCHED_FIFO is permitted: play keeps microsecond timing", ""};
  }
  const std::string reason = std::strerror(errno);
  const auto play = programs / "rocinante-play";
  if (fileHasCapability(play, CAP_SYS_NICE)) {
    return {"scheduling", State::ok, fmt::format("{} has cap_sys_nice", play.string()), ""};
  }
  return {"scheduling", State::limited,
          fmt::format("SCHED_FIFO: {}: play is milliseconds late on a busy machine", reason),
          grantAdvice(play, "LimitRTPRIO=10", "rtprio 10")};
}

SelfTestFact priorityFact(const Path& programs) {
  if (::setpriority(PRIO_PROCESS, 0, kRecordNice) == 0) {
    return {"priority", State::ok, "nice -10 is permitted: record wakes in time", ""};
  }
  const std::string reason = std::strerror(errno);
  const auto record = programs / "rocinante-record";
  if (fileHasCapability(record, CAP_SYS_NICE)) {
    return {"priority", State::ok, fmt::format("{} has cap_sys_nice", record.string()), ""};
  }
  return {"priority", State::limited,
          fmt::format("nice -10: {}: a record that is killed on a busy machine may lose more than "
                      "250 ms",
                      reason),
          grantAdvice(record, "LimitNICE=-10", "nice -10")};
}

SelfTestFact clockFact(const Path&) {
  timex clock{};
  const int answer = ::adjtimex(&clock);
  if (answer < 0) {
    return {"clock", State::limited, fmt::format("adjtimex: {}", std::strerror(errno)),
            "allow this program to read the state of the clock (seccomp)"};
  }
  return judgeClock(answer != TIME_ERROR && (clock.status & STA_UNSYNC) == 0, clock.maxerror);
}

SelfTestFact filesFact(const Path&) {
  std::error_code fault;
  const Path here = std::filesystem::current_path(fault);
  const Path folder = fault ? Path(".") : here;
  SelfTestFact fact{"files", State::missing, "", ""};
  std::string name = (folder / ".rocinante-self-test-XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) {
    fact.found = fmt::format("{}: {}", folder.string(), std::strerror(errno));
    fact.advice = "work in a folder that you may write to, or name one with -o";
    return fact;
  }
  ::unlink(name.c_str());  // it is gone however this process ends
  const Result<Lock> lock = lockFile(file, name);
  const bool has_locks = lock && *lock == Lock::taken;
  const bool has_room = ::fallocate(file, FALLOC_FL_KEEP_SIZE, 0, kAhead) == 0;
  const int room_error = has_room ? 0 : errno;
  struct statvfs volume {};
  const bool known = ::fstatvfs(file, &volume) == 0;
  ::close(file);
  const std::uint64_t free_bytes = known ? volume.f_bavail * volume.f_frsize : 0;
  fact.found = fmt::format(
      "{}: locks {}, room {}, {} free", folder.string(), has_locks ? "work" : "do not work",
      has_room ? "is allocated ahead" : std::strerror(room_error), sizeText(free_bytes));
  if (room_error == ENOSPC || room_error == EDQUOT) {
    fact.advice = "make room on this disk";
  } else if (!has_locks || !has_room) {
    fact.state = State::limited;
    fact.advice = has_locks
                      ? "a full disk may leave a log without its summary here: keep an eye on "
                        "it, or record to ext4, xfs or btrfs"
                      : "nothing stops a second program from writing the same log here: "
                        "record to a local disk";
  } else {
    fact.state = State::ok;
  }
  return fact;
}

}  // namespace

std::span<const MachineCheck> machineChecks() {
  static constexpr MachineCheck kChecks[] = {
      {"sdf", sdfFact},           {"multicast", multicastFact},
      {"ipv6", ipv6Fact},         {"receive_buffer", receiveBufferFact},
      {"capture", captureFact},   {"scheduling", schedulingFact},
      {"priority", priorityFact}, {"clock", clockFact},
      {"files", filesFact},
  };
  return kChecks;
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

SelfTestFact judgeClock(bool is_synchronised, std::int64_t most_error_us) {
  if (is_synchronised) {
    return {"clock", State::ok,
            fmt::format("synchronised, wrong by {:.1f} ms at most",
                        static_cast<double>(most_error_us) / 1e3),
            ""};
  }
  return {"clock", State::limited,
          "the wall clock is not synchronised: logs of several machines will not line up",
          "install chrony, or: sudo timedatectl set-ntp true (in a container or a virtual machine: "
          "on the host)"};
}

}  // namespace rocinante
