#include "core/relay/fan_out.h"

#include <algorithm>
#include <cerrno>

#include "core/net/system_socket.h"

namespace rocinante {

SendOutcome sendInOrder(DatagramSink& sink, std::span<const ByteView> payloads,
                        const std::function<bool()>& wait_for_room) {
  SendOutcome outcome;
  while (!payloads.empty()) {
    const Result<std::size_t> sent = sink.sendWithoutWaiting(payloads);
    if (sent && *sent == 0) {
      if (!wait_for_room()) break;
      continue;
    }
    if (!sent) {
      ++outcome.dropped;
      if (!outcome.trouble) outcome.trouble = sent.error();
    } else {
      outcome.sent += *sent;
    }
    payloads = payloads.subspan(sent ? *sent : 1);
  }
  outcome.dropped += payloads.size();
  return outcome;
}

FanOut::Destination::Destination(const SocketAddress& address)
    : bytes_(toSystem(address, address_)) {}

void FanOut::add(ByteView payload, const Destination& to) {
  // sendmmsg only reads what the pieces and names point to.
  pieces_.push_back({const_cast<std::byte*>(payload.data()), payload.size()});
  mmsghdr message{};
  message.msg_hdr.msg_name = const_cast<sockaddr_storage*>(&to.address_);
  message.msg_hdr.msg_namelen = to.bytes_;
  message.msg_hdr.msg_iovlen = 1;
  messages_.push_back(message);
}

FanOut::Outcome FanOut::flush(const std::function<bool()>& wait_for_room) {
  for (std::size_t i = 0; i < messages_.size(); ++i) messages_[i].msg_hdr.msg_iov = &pieces_[i];
  Outcome outcome;
  std::span<mmsghdr> left(messages_);
  while (!left.empty()) {
    const auto some = static_cast<unsigned>(std::min(left.size(), kMessages));
    const int sent = ::sendmmsg(socket_, left.data(), some, MSG_DONTWAIT);
    if (sent >= 0) {
      outcome.sent += static_cast<std::uint64_t>(sent);
      left = left.subspan(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN || errno == ENOBUFS) {
      if (!wait_for_room()) break;
    } else if (errno != EINTR && errno != ECONNREFUSED) {
      ++outcome.dropped;
      left = left.subspan(1);
    }
  }
  outcome.dropped += left.size();
  pieces_.clear();
  messages_.clear();
  return outcome;
}

}  // namespace rocinante
