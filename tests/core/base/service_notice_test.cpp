#include "core/cli/service_notice.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/support/temporary_folder.h"

namespace rocinante::cli {
namespace {

using namespace std::chrono_literals;

/// A service manager's socket.
class Manager {
 public:
  /// `name` as $NOTIFY_SOCKET gives it.
  explicit Manager(const std::string& name) : socket_(::socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name.data(), name.size());
    if (name[0] == '@') address.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0) << name;
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  }
  ~Manager() {
    ::close(socket_);
    for (const char* each : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) ::unsetenv(each);
  }

  /// The next datagram that waits; empty: none does.
  std::string next() {
    std::array<char, 256> bytes{};
    const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    return size > 0 ? std::string(bytes.data(), static_cast<std::size_t>(size)) : std::string();
  }

 private:
  int socket_;
};

void setWatchdog(const char* period_us, const std::string& process) {
  ::setenv("WATCHDOG_USEC", period_us, 1);
  ::setenv("WATCHDOG_PID", process.c_str(), 1);
}

TEST(ServiceNotice, TellsAtAPathAndAtAnAbstractName) {
  const test::TemporaryFolder folder;
  for (const std::string& name :
       {(folder.path() / "notify").string(), "@rocinante-test-" + std::to_string(::getpid())}) {
    SCOPED_TRACE(name);
    Manager manager(name);
    ServiceNotice notice = ServiceNotice::fromEnvironment();
    EXPECT_TRUE(notice.isOpen());
    EXPECT_EQ(std::getenv("NOTIFY_SOCKET"), nullptr) << "children are not the service";
    notice.ready();
    notice.status("all is well");
    notice.stopping();
    EXPECT_EQ(manager.next(), "READY=1");
    EXPECT_EQ(manager.next(), "STATUS=all is well");
    EXPECT_EQ(manager.next(), "STOPPING=1");
    EXPECT_EQ(manager.next(), "");
    EXPECT_FALSE(notice.watchdog());
  }
}

TEST(ServiceNotice, TellsTheWatchdogTwiceAPeriod) {
  Manager manager("@rocinante-watchdog-" + std::to_string(::getpid()));
  setWatchdog("10000000", std::to_string(::getpid()));
  ServiceNotice notice = ServiceNotice::fromEnvironment();
  ASSERT_EQ(notice.watchdog(), Nanoseconds(10s));
  int told = 0;
  for (SteadyTime now(1h); now < SteadyTime(1h + 60s); now += 100ms) {
    notice.alive(now);
    while (manager.next() == "WATCHDOG=1") ++told;
  }
  EXPECT_EQ(told, 12);
}

TEST(ServiceNotice, AnothersWatchdogAndNonsenseAreNotOurs) {
  for (const auto& [period, process] :
       {std::pair("1000000", "1"), {"0", ""}, {"-5", ""}, {"12x", ""}, {"99999999999999", ""}}) {
    SCOPED_TRACE(period);
    Manager manager("@rocinante-nonsense-" + std::to_string(::getpid()));
    setWatchdog(period, process);
    ServiceNotice notice = ServiceNotice::fromEnvironment();
    EXPECT_FALSE(notice.watchdog());
    notice.alive(SteadyTime(1h));
    EXPECT_EQ(manager.next(), "");
  }
}

TEST(ServiceNotice, WithoutAManagerItSaysNothing) {
  const std::string long_name = "/" + std::string(200, 'x');
  for (const char* name : {"", "relative", "@", "/no/such/socket", long_name.c_str()}) {
    SCOPED_TRACE(name);
    ::setenv("NOTIFY_SOCKET", name, 1);
    ServiceNotice notice = ServiceNotice::fromEnvironment();
    EXPECT_FALSE(notice.isOpen());
    notice.ready();
    notice.alive(SteadyTime(1h));
  }
  ::unsetenv("NOTIFY_SOCKET");
  EXPECT_FALSE(ServiceNotice::fromEnvironment().isOpen());
}

TEST(ServiceNotice, AManagerThatDoesNotReadStopsNothing) {
  Manager manager("@rocinante-full-" + std::to_string(::getpid()));
  ServiceNotice notice = ServiceNotice::fromEnvironment();
  // More than any queue of a socket holds.
  for (int i = 0; i < 5'000; ++i) notice.ready();
  EXPECT_EQ(manager.next(), "READY=1");
}

}  // namespace
}  // namespace rocinante::cli
