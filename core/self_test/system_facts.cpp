#include "core/self_test/system_facts.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <sys/timex.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/file_lock.h"
#include "core/base/loaded_module.h"
#include "core/base/size_text.h"
#include "core/kinematics/sdformat_module.h"
#include "core/self_test/file_capability.h"

namespace rocinante {
namespace {

using State = SelfTestFact::State;

// As requested by player/send/realtime.cpp and recorder/capture/prompt_thread.cpp.
constexpr int kPlayPriority = 10;
constexpr int kRecordNice = -10;
// One chunk of a log's end, as log_writer allocates ahead.
constexpr off_t kAhead = 1 << 16;

/// The three ways to give a right to `program`.
std::string grantAdvice(const std::filesystem::path& program, const char* unit_line,
                        const char* limits_line) {
  return fmt::format(
      "once: sudo setcap cap_sys_nice+ep {}; or in a systemd unit {}; or in "
      "/etc/security/limits.conf USER - {}; a container needs --cap-add SYS_NICE",
      program.string(), unit_line, limits_line);
}

}  // namespace

SelfTestFact schedulingFact(const std::filesystem::path& programs) {
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

SelfTestFact priorityFact(const std::filesystem::path& programs) {
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

SelfTestFact clockFact() {
  timex clock{};
  const int answer = ::adjtimex(&clock);
  if (answer < 0) {
    return {"clock", State::limited, fmt::format("adjtimex: {}", std::strerror(errno)),
            "allow this program to read the state of the clock (seccomp)"};
  }
  return judgeClock(answer != TIME_ERROR && (clock.status & STA_UNSYNC) == 0, clock.maxerror);
}

SelfTestFact filesFact(const std::filesystem::path& folder) {
  SelfTestFact fact{"files", State::missing, "", ""};
  std::string name = (folder / ".rocinante-self-test-XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) {
    fact.says = fmt::format("{}: {}", folder.string(), std::strerror(errno));
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
  fact.says = fmt::format(
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

SelfTestFact sdfFact() {
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

}  // namespace rocinante
