#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>
#include <optional>
#include <utility>

#include "core/net/interfaces.h"
#include "core/net/port_holder.h"
#include "core/net/system_socket.h"
#include "player/control/control_socket.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxLines = 16;
/// Datagrams served at a time, so that a flood does not delay other inputs.
constexpr int kMaxDatagrams = 64;

class UdpControl final : public ControlInput {
 public:
  UdpControl(SystemSocket socket, AddressFilter allowed, std::function<void(std::string)> notify)
      : socket_(std::move(socket)), allowed_(std::move(allowed)), notify_(std::move(notify)) {}

  void addDescriptors(std::vector<pollfd>& descriptors) const override {
    descriptors.push_back({socket_.descriptor(), POLLIN, 0});
  }

  void serve(const Ask& ask) override {
    for (int i = 0; i < kMaxDatagrams; ++i) {
      sockaddr_storage from{};
      socklen_t length = sizeof from;
      const ssize_t size = ::recvfrom(socket_.descriptor(), buffer_.data(), buffer_.size(),
                                      MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from), &length);
      if (size < 0 && errno == ECONNREFUSED) continue;  // the client is gone
      if (size < 0) return;
      const std::string_view text(buffer_.data(), static_cast<std::size_t>(size));
      if (mayControl(fromSystem(from))) {
        peer_ = {from, length};
        if (!unsent_.empty()) send(std::exchange(unsent_, {}), from, length);
        const std::string answers = answer(text, ask);
        if (!answers.empty()) send(answers, from, length);
        continue;
      }
      if (notify_) {
        // Once only: other hosts must not fill the terminal.
        std::exchange(notify_, {})("refused a command from " +
                                   withoutMapping(fromSystem(from)).hostText() +
                                   ": allow its address with --control-allow");
      }
      if (const auto now = std::chrono::steady_clock::now(); now >= refuse_again_) {
        refuse_again_ = now + std::chrono::seconds(1);
        send("error only this machine may control this player (see --control-allow)\n", from,
             length);
      }
    }
  }

  void tell(const std::string& line) override {
    if (peer_) {
      send(line + "\n", peer_->address, peer_->length);
    } else {
      unsent_ = line + "\n";
    }
  }

 private:
  struct Peer {
    sockaddr_storage address;
    socklen_t length;
  };

  bool mayControl(const SocketAddress& from) const {
    // An empty filter would allow every host.
    return isOwnAddress(from) || (!allowed_.empty() && allowed_.allows(from));
  }

  std::string answer(std::string_view text, const Ask& ask) {
    std::string answers;
    std::size_t lines = 0;
    do {
      const std::size_t end = std::min(text.find('\n'), text.size());
      if (++lines > kMaxLines) return answers + "error a datagram holds at most 16 commands\n";
      const std::string answer = ask(std::string(text.substr(0, end)));
      if (!answer.empty()) answers += answer + "\n";
      text.remove_prefix(std::min(end + 1, text.size()));
    } while (!text.empty());
    return answers;
  }

  void send(const std::string& text, const sockaddr_storage& to, socklen_t length) {
    // An answer that cannot be sent is dropped.
    [[maybe_unused]] const auto sent =
        ::sendto(socket_.descriptor(), text.data(), text.size(), MSG_DONTWAIT,
                 reinterpret_cast<const sockaddr*>(&to), length);
  }

  SystemSocket socket_;
  AddressFilter allowed_;
  std::function<void(std::string)> notify_;  ///< empty after the first call
  std::array<char, 65'536> buffer_{};
  std::optional<Peer> peer_;
  std::string unsent_;
  std::chrono::steady_clock::time_point refuse_again_{};
};

}  // namespace

Result<ControlSocket> openUdpControl(const Endpoint& endpoint, AddressFilter allowed,
                                     std::function<void(std::string)> notify) {
  Result<SystemSocket> socket = SystemSocket::open(endpoint);
  if (!socket) return socket.error();
  sockaddr_storage system{};
  const socklen_t length = toSystem(endpoint.address, system);
  if (::bind(socket->descriptor(), reinterpret_cast<sockaddr*>(&system), length) != 0) {
    if (errno != EADDRINUSE) return systemError("cannot listen for commands", endpoint);
    const std::optional<PortHolder> holder = portHolder(endpoint.address);
    return Error{ErrorKind::refused,
                 "port " + std::to_string(endpoint.address.port) + " is held by " +
                     (holder ? holder->name + " (pid " + std::to_string(holder->pid) + ")"
                             : std::string("another process")),
                 endpoint.text()};
  }
  Result<SocketAddress> bound = socket->localAddress(endpoint);
  if (!bound) return bound.error();
  ControlSocket control;
  control.where = "udp://" + bound->text();
  control.input =
      std::make_unique<UdpControl>(std::move(*socket), std::move(allowed), std::move(notify));
  return control;
}

}  // namespace rocinante
