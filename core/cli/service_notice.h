#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace rocinante::cli {

/// Tells a service manager how this program is: systemd's protocol (sd_notify(3), "Notes"), one
/// datagram of VARIABLE=VALUE lines to the socket that $NOTIFY_SOCKET names, a path or an abstract
/// name ("@..."). Does nothing without that variable; a manager that does not listen is no error.
/// Never blocks. One thread.
class ServiceNotice {
 public:
  /// Reads $NOTIFY_SOCKET, $WATCHDOG_USEC and $WATCHDOG_PID, and takes them out of the environment:
  /// children are not the service.
  static ServiceNotice fromEnvironment();
  ServiceNotice(ServiceNotice&& other) noexcept;
  ServiceNotice& operator=(ServiceNotice&&) = delete;
  ~ServiceNotice();

  void ready() { send("READY=1"); }
  void stopping() { send("STOPPING=1"); }
  /// A line that `systemctl status` shows.
  void status(std::string_view text);
  /// To be called in the loop whose progress proves that the program lives: tells the watchdog
  /// twice in its period.
  void alive(SteadyTime now);

  bool isOpen() const { return socket_ >= 0; }
  /// How long the manager waits for a sign of life; empty: it has no watchdog for this process.
  std::optional<Nanoseconds> watchdog() const { return watchdog_; }

 private:
  ServiceNotice() = default;
  void send(std::string_view text);

  int socket_ = -1;
  std::optional<Nanoseconds> watchdog_;
  std::optional<SteadyTime> notified_at_;
};

}  // namespace rocinante::cli
