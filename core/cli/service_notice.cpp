#include "core/cli/service_notice.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace rocinante::cli {
namespace {

/// Takes a variable out of the environment; empty when it is not set.
std::string takeVariable(const char* name) {
  const char* const value = std::getenv(name);
  std::string text = value == nullptr ? "" : value;
  ::unsetenv(name);
  return text;
}

std::optional<std::uint64_t> numberIn(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// A socket that sends to `name`; -1 when there is none.
int connectTo(std::string_view name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const bool is_valid = name.size() > 1 && (name[0] == '/' || name[0] == '@') &&
                        name.size() < sizeof address.sun_path;
  if (!is_valid) return -1;
  std::memcpy(address.sun_path, name.data(), name.size());
  if (name[0] == '@') address.sun_path[0] = '\0';  // an abstract name
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  const int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return -1;
  if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), size) == 0) {
    return descriptor;
  }
  ::close(descriptor);
  return -1;
}

}  // namespace

ServiceNotice ServiceNotice::fromEnvironment() {
  constexpr std::uint64_t kDayUs = 86'400'000'000;
  ServiceNotice notice;
  const std::string name = takeVariable("NOTIFY_SOCKET");
  const auto period_us = numberIn(takeVariable("WATCHDOG_USEC"));
  const std::string process = takeVariable("WATCHDOG_PID");
  notice.socket_ = connectTo(name);
  const bool is_ours =
      process.empty() || numberIn(process) == static_cast<std::uint64_t>(::getpid());
  if (is_ours && period_us && *period_us > 0 && *period_us <= kDayUs) {
    notice.watchdog_ = std::chrono::microseconds(*period_us);
  }
  return notice;
}

ServiceNotice::ServiceNotice(ServiceNotice&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      watchdog_(other.watchdog_),
      notified_at_(other.notified_at_) {}

ServiceNotice::~ServiceNotice() {
  if (socket_ >= 0) ::close(socket_);
}

void ServiceNotice::status(std::string_view text) {
  if (socket_ >= 0) send("STATUS=" + std::string(text));
}

void ServiceNotice::alive(SteadyTime now) {
  if (!watchdog_ || (notified_at_ && now - *notified_at_ < *watchdog_ / 2)) return;
  notified_at_ = now;
  send("WATCHDOG=1");
}

void ServiceNotice::send(std::string_view text) {
  if (socket_ >= 0) ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
}

}  // namespace rocinante::cli
