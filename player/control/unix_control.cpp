#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <list>
#include <utility>

#include "core/base/unfinished_path.h"
#include "core/net/system_socket.h"
#include "player/control/control_socket.h"
#include "player/playhead/playhead_command.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxConnections = 8;

struct Connection {
  explicit Connection(SystemSocket its_socket) : socket(std::move(its_socket)) {}
  SystemSocket socket;
  std::string unread;  ///< the beginning of a line
  bool over = false;

  void say(const std::string& line) {
    const std::string text = line + "\n";
    const ssize_t sent =
        ::send(socket.descriptor(), text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    // After half a line all later answers would be misread.
    if (sent != static_cast<ssize_t>(text.size())) over = true;
  }
};

class UnixControl final : public ControlInput {
 public:
  UnixControl(SystemSocket socket, std::filesystem::path path)
      : socket_(std::move(socket)), path_(std::move(path)) {}

  void addDescriptors(std::vector<pollfd>& descriptors) const override {
    // Further ones wait in the kernel's queue.
    if (connections_.size() < kMaxConnections) {
      descriptors.push_back({socket_.descriptor(), POLLIN, 0});
    }
    for (const Connection& each : connections_) {
      descriptors.push_back({each.socket.descriptor(), POLLIN, 0});
    }
  }

  void serve(const Ask& ask) override {
    while (connections_.size() < kMaxConnections) {
      const int accepted =
          ::accept4(socket_.descriptor(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
      if (accepted < 0) break;
      connections_.emplace_back(SystemSocket(accepted));
    }
    for (Connection& each : connections_) {
      read(each, ask);
      if (!each.over) continue;
      if (speaker_ == &each) speaker_ = nullptr;
    }
    connections_.remove_if([](const Connection& each) { return each.over; });
  }

  void tell(const std::string& line) override {
    if (speaker_ != nullptr) {
      speaker_->say(line);
    } else {
      unsent_ = line;
    }
  }

 private:
  void read(Connection& from, const Ask& ask) {
    std::array<char, 4096> buffer;
    const ssize_t size =
        ::recv(from.socket.descriptor(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) from.over = true;
    if (size <= 0) return;
    from.unread.append(buffer.data(), static_cast<std::size_t>(size));
    for (std::size_t end = 0; !from.over && (end = from.unread.find('\n')) != std::string::npos;) {
      const std::string line = from.unread.substr(0, end);
      from.unread.erase(0, end + 1);
      speaker_ = &from;
      if (!unsent_.empty()) from.say(std::exchange(unsent_, {}));
      const std::string answer = ask(line);
      if (!answer.empty()) from.say(answer);
    }
    if (from.unread.size() > kMaxCommandBytes) {
      from.say("error a command has at most " + std::to_string(kMaxCommandBytes) + " bytes");
      from.over = true;
    }
  }

  SystemSocket socket_;
  UnfinishedPath path_;
  std::list<Connection> connections_;
  Connection* speaker_ = nullptr;  ///< the client of the last command
  std::string unsent_;
};

Error unixError(std::string_view what, const std::filesystem::path& path) {
  return {ErrorKind::refused, std::string(what) + ": " + std::strerror(errno), path.string()};
}

/// True when the socket exists but no process listens on it.
bool isLeftOver(const std::filesystem::path& path, const sockaddr_un& address) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || !S_ISSOCK(status.st_mode)) return false;
  const SystemSocket probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  return ::connect(probe.descriptor(), reinterpret_cast<const sockaddr*>(&address),
                   sizeof address) != 0 &&
         errno == ECONNREFUSED;
}

}  // namespace

Result<ControlSocket> openUnixControl(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.native().size());
  SystemSocket socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (socket.descriptor() < 0) return unixError("cannot make a Unix socket", path);
  if (isLeftOver(path, address)) ::unlink(path.c_str());
  // Private to the user from its creation on.
  const mode_t former = ::umask(0177);
  const int bound =
      ::bind(socket.descriptor(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  ::umask(former);
  if (bound != 0 || ::listen(socket.descriptor(), static_cast<int>(kMaxConnections)) != 0) {
    return unixError("cannot listen for commands", path);
  }
  ControlSocket control;
  control.where = "unix:" + path.string();
  control.input = std::make_unique<UnixControl>(std::move(socket), path);
  return control;
}

}  // namespace rocinante
