#include "player/send/transmit_stamps.h"

#include <linux/errqueue.h>
#include <linux/net_tstamp.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <time.h>

#include <array>
#include <cstring>
#include <optional>

namespace rocinante {
namespace {

constexpr std::size_t kMostStamps = 64;
constexpr int kFruitlessCalls = 64;

Nanoseconds nanosecondsIn(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

/// The current offset from the wall clock to the steady clock.
Nanoseconds steadyMinusWall() {
  timespec before{};
  timespec wall{};
  timespec after{};
  ::clock_gettime(CLOCK_MONOTONIC, &before);
  ::clock_gettime(CLOCK_REALTIME, &wall);
  ::clock_gettime(CLOCK_MONOTONIC, &after);
  return (nanosecondsIn(before) + nanosecondsIn(after)) / 2 - nanosecondsIn(wall);
}

/// A datagram's transmit time, and its number within its socket.
struct Stamp {
  std::uint32_t number = 0;
  Nanoseconds wall{};
};

std::optional<Stamp> stampIn(msghdr& message) {
  Stamp stamp;
  bool has_number = false;
  bool has_time = false;
  for (cmsghdr* control = CMSG_FIRSTHDR(&message); control != nullptr;
       control = CMSG_NXTHDR(&message, control)) {
    const bool is_error =
        (control->cmsg_level == IPPROTO_IP && control->cmsg_type == IP_RECVERR) ||
        (control->cmsg_level == IPPROTO_IPV6 && control->cmsg_type == IPV6_RECVERR);
    if (is_error) {
      sock_extended_err error{};
      std::memcpy(&error, CMSG_DATA(control), sizeof error);
      has_number = error.ee_origin == SO_EE_ORIGIN_TIMESTAMPING;
      stamp.number = error.ee_data;
    } else if (control->cmsg_level == SOL_SOCKET && control->cmsg_type == SCM_TIMESTAMPING) {
      scm_timestamping stamps{};
      std::memcpy(&stamps, CMSG_DATA(control), sizeof stamps);
      // The first of the three is the software stamp.
      has_time = stamps.ts[0].tv_sec != 0;
      stamp.wall = nanosecondsIn(stamps.ts[0]);
    }
  }
  if (!has_number || !has_time) return std::nullopt;
  return stamp;
}

struct Answers {
  std::array<Stamp, kMostStamps> stamps{};
  std::size_t count = 0;
  bool overrun = false;  ///< more stamps than requested

  /// Exactly one for each of `wanted`.
  bool areWhole(std::size_t wanted) const {
    return wanted > 0 && count == wanted && !overrun &&
           stamps[count - 1].number - stamps[0].number == wanted - 1;
  }
};

/// Empties the socket's error queue. Ignores datagrams before `first`, which a busy device reported
/// late.
Answers readAnswers(int descriptor, std::uint32_t first, std::size_t wanted) {
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
      if (!stamp || static_cast<std::int32_t>(stamp->number - first) < 0) continue;
      if (answers.count == wanted) {
        answers.overrun = true;
      } else {
        answers.stamps[answers.count++] = *stamp;
      }
    }
    // A short batch means that the queue is empty; reading again would cost another call.
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
  const std::uint32_t first = next_number_;
  next_number_ += static_cast<std::uint32_t>(sent_at.size());
  if (asking_ && sent_at.size() <= kMostStamps) {
    const Answers answers = readAnswers(descriptor_, first, sent_at.size());
    if (answers.areWhole(sent_at.size())) {
      const Nanoseconds offset = steadyMinusWall();
      for (std::size_t i = 0; i < sent_at.size(); ++i) {
        sent_at[i] = SteadyTime(answers.stamps[i].wall + offset);
      }
      stamped_ += sent_at.size();
      // A datagram that the system first refused also used a number.
      next_number_ = answers.stamps[answers.count - 1].number + 1;
      return;
    }
    if (answers.count == 0 && stamped_ == 0 && ++fruitless_ == kFruitlessCalls) asking_ = false;
  }
  unstamped_ += sent_at.size();
}

}  // namespace rocinante
