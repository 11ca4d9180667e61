#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace rocinante::test {

/// Datagrams to a port of this machine from 65,536 addresses of loopback, 127.77.0.0 to
/// 127.77.255.255, in turn: each address sends one of `texts`, always the same. What comes back is
/// counted by address. Two threads of its own, ended by the destructor.
class ForgedFlood {
 public:
  static constexpr std::size_t kAddresses = 65'536;
  /// Bytes that an address sent, and got.
  struct Traffic {
    std::atomic<std::uint64_t> sent{0}, received{0};
  };

  /// `a_second`: datagrams; 0: as many as it can.
  ForgedFlood(std::uint16_t to, std::vector<std::string> texts, double a_second = 0)
      : texts_(std::move(texts)), a_second_(a_second), traffic_(kAddresses) {
    socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const int on = 1, bytes = 4 << 20;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
    to_.sin_family = AF_INET;
    sockaddr_in any = to_;
    if (socket_ < 0 || ::setsockopt(socket_, IPPROTO_IP, IP_PKTINFO, &on, sizeof on) != 0 ||
        ::bind(socket_, reinterpret_cast<sockaddr*>(&any), sizeof any) != 0) {
      throw std::runtime_error("no socket for a flood");
    }
    to_.sin_port = htons(to);
    to_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    receiver_ = std::thread([this] { receive(); });
    sender_ = std::thread([this] { send(); });
  }
  ~ForgedFlood() {
    stopSending();
    receiving_ = false;
    receiver_.join();
    ::close(socket_);
  }
  ForgedFlood(const ForgedFlood&) = delete;
  ForgedFlood& operator=(const ForgedFlood&) = delete;

  /// Sends no more; answers are still counted.
  void stopSending() {
    sending_ = false;
    if (sender_.joinable()) sender_.join();
  }
  std::uint64_t sent() const { return sent_; }
  std::uint64_t answers() const { return answers_; }
  const std::vector<Traffic>& traffic() const { return traffic_; }

 private:
  static constexpr std::size_t kBatch = 64;
  static constexpr std::uint32_t kFirstAddress = 127U << 24U | 77U << 16U;
  struct Slot {
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(in_pktinfo))> control{};
    std::array<char, 2048> bytes{};
    iovec piece{};
  };

  void send() {
    std::vector<Slot> slots(kBatch);
    std::array<mmsghdr, kBatch> messages{};
    const auto began = std::chrono::steady_clock::now();
    while (sending_) {
      const std::uint64_t first = sent_;
      for (std::size_t i = 0; i < kBatch; ++i) {
        const std::size_t address = (first + i) % kAddresses;
        std::string& text = texts_[address % texts_.size()];
        msghdr& message = messages[i].msg_hdr;
        slots[i].piece = {text.data(), text.size()};
        message = {
            &to_, sizeof to_, &slots[i].piece, 1, slots[i].control.data(), slots[i].control.size(),
            0};
        cmsghdr* const control = CMSG_FIRSTHDR(&message);
        *control = {CMSG_LEN(sizeof(in_pktinfo)), IPPROTO_IP, IP_PKTINFO};
        in_pktinfo info{};
        info.ipi_spec_dst.s_addr = htonl(kFirstAddress + static_cast<std::uint32_t>(address));
        std::memcpy(CMSG_DATA(control), &info, sizeof info);
        // Before it is sent: the answer may be here before the call returns.
        traffic_[address].sent += text.size();
      }
      for (std::size_t done = 0; done < kBatch && sending_;) {
        const int count =
            ::sendmmsg(socket_, messages.data() + done, static_cast<unsigned>(kBatch - done), 0);
        if (count > 0) done += static_cast<std::size_t>(count);
      }
      sent_ += kBatch;
      if (a_second_ > 0) {
        std::this_thread::sleep_until(
            began + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                        std::chrono::duration<double>(static_cast<double>(sent_) / a_second_)));
      }
    }
  }

  void receive() {
    std::vector<Slot> slots(kBatch);
    std::array<mmsghdr, kBatch> messages{};
    while (receiving_) {
      pollfd waiting{socket_, POLLIN, 0};
      if (::poll(&waiting, 1, 5) <= 0) continue;
      for (std::size_t i = 0; i < kBatch; ++i) {
        slots[i].piece = {slots[i].bytes.data(), slots[i].bytes.size()};
        messages[i].msg_hdr = {
            nullptr, 0, &slots[i].piece, 1, slots[i].control.data(), slots[i].control.size(), 0};
      }
      const int count = ::recvmmsg(socket_, messages.data(), kBatch, MSG_DONTWAIT, nullptr);
      for (int i = 0; i < count; ++i) {
        mmsghdr& message = messages[static_cast<std::size_t>(i)];
        in_pktinfo info{};
        const cmsghdr* const control = CMSG_FIRSTHDR(&message.msg_hdr);
        if (control == nullptr) continue;
        std::memcpy(&info, CMSG_DATA(control), sizeof info);
        const std::size_t address = ntohl(info.ipi_addr.s_addr) - kFirstAddress;
        if (address >= kAddresses) continue;  // not meant for this socket
        traffic_[address].received += message.msg_len;
        ++answers_;
      }
    }
  }

  std::vector<std::string> texts_;
  double a_second_;
  int socket_ = -1;
  sockaddr_in to_{};
  std::vector<Traffic> traffic_;
  std::atomic<std::uint64_t> sent_{0}, answers_{0};
  std::atomic<bool> sending_{true}, receiving_{true};
  std::thread receiver_, sender_;
};

}  // namespace rocinante::test
