#include "player/transmit_stamps.h"

#include <linux/errqueue.h>
#include <linux/net_tstamp.h>
#include <sys/socket.h>
#include <time.h>

#include <array>
#include <cstring>
#include <optional>

namespace rocinante {
namespace {

constexpr std::size_t kMost = 64;
constexpr int kFruitlessCalls = 64;

Nanoseconds fromSystem(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

/// What to add to the wall clock to get the steady one, now.
Nanoseconds steadyMinusWall() {
  timespec before{};
  timespec wall{};
  timespec after{};
  ::clock_gettime(CLOCK_MONOTONIC, &before);
  ::clock_gettime(CLOCK_REALTIME, &wall);
  ::clock_gettime(CLOCK_MONOTONIC, &after);
  return (fromSystem(before) + fromSystem(after)) / 2 - fromSystem(wall);
}

std::optional<Nanoseconds> stampIn(msghdr& message) {
  for (cmsghdr* control = CMSG_FIRSTHDR(&message); control != nullptr;
       control = CMSG_NXTHDR(&message, control)) {
    if (control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_TIMESTAMPING) continue;
    scm_timestamping stamps{};
    std::memcpy(&stamps, CMSG_DATA(control), sizeof stamps);
    // The first of the three is the software stamp.
    if (stamps.ts[0].tv_sec != 0) return fromSystem(stamps.ts[0]);
  }
  return std::nullopt;
}

struct Answers {
  std::array<Nanoseconds, kMost> wall{};
  std::size_t count = 0;
  bool overrun = false;  ///< more than were asked for
};

/// Empties the socket's error queue.
Answers readAnswers(int descriptor, std::size_t wanted) {
  constexpr std::size_t kBatch = 32;
  Answers answers;
  std::array<std::array<char, 256>, kBatch> controls;
  std::array<mmsghdr, kBatch> messages{};
  while (true) {
    for (std::size_t i = 0; i < kBatch; ++i) {
      messages[i].msg_hdr.msg_control = controls[i].data();
      messages[i].msg_hdr.msg_controllen = controls[i].size();
    }
    const int count =
        ::recvmmsg(descriptor, messages.data(), kBatch, MSG_ERRQUEUE | MSG_DONTWAIT, nullptr);
    if (count <= 0) return answers;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const auto stamp = stampIn(messages[i].msg_hdr);
      if (!stamp) continue;
      if (answers.count == wanted) {
        answers.overrun = true;
      } else {
        answers.wall[answers.count++] = *stamp;
      }
    }
    // Few answers come for few datagrams: a second look would cost another call each time.
    if (static_cast<std::size_t>(count) < kBatch) return answers;
  }
}

}  // namespace

TransmitStamps::TransmitStamps(int descriptor) : descriptor_(descriptor) {
  const unsigned flags = SOF_TIMESTAMPING_TX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE |
                         SOF_TIMESTAMPING_OPT_ID | SOF_TIMESTAMPING_OPT_TSONLY;
  asking_ = ::setsockopt(descriptor_, SOL_SOCKET, SO_TIMESTAMPING, &flags, sizeof flags) == 0;
}

void TransmitStamps::collect(std::span<SteadyTime> sent_at) {
  if (asking_ && sent_at.size() <= kMost) {
    const Answers answers = readAnswers(descriptor_, sent_at.size());
    if (answers.count == sent_at.size() && !answers.overrun) {
      const Nanoseconds offset = steadyMinusWall();
      for (std::size_t i = 0; i < sent_at.size(); ++i) {
        sent_at[i] = SteadyTime(answers.wall[i] + offset);
      }
      stamped_ += sent_at.size();
      return;
    }
    if (answers.count == 0 && stamped_ == 0 && ++fruitless_ == kFruitlessCalls) asking_ = false;
  }
  unstamped_ += sent_at.size();
}

}  // namespace rocinante
