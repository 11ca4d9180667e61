#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace rocinante::test {

/// A network of the test's own: while it lives, this thread and what it starts see a fresh network
/// name space, in which only `lo` exists, and is up. Needs root.
class NetworkNamespace {
 public:
  NetworkNamespace() : outside_(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)) {
    entered_ = outside_ >= 0 && ::unshare(CLONE_NEWNET) == 0;
    if (entered_) entered_ = run("ip link set lo up");
  }
  ~NetworkNamespace() {
    if (outside_ < 0) return;
    if (::setns(outside_, CLONE_NEWNET) != 0) std::abort();  // other tests would run in it
    ::close(outside_);
  }
  NetworkNamespace(const NetworkNamespace&) = delete;
  NetworkNamespace& operator=(const NetworkNamespace&) = delete;

  bool entered() const { return entered_; }

  /// A shell command inside; false when it fails.
  static bool run(const std::string& command) {
    return std::system(("{ " + command + "\n} >/dev/null 2>&1").c_str()) == 0;
  }

 private:
  int outside_ = -1;
  bool entered_ = false;
};

}  // namespace rocinante::test

/// Second line of a test that makes a NetworkNamespace: skips with a clear line where it may not.
#define ROCINANTE_NEEDS_NETWORK_NAMESPACE(network) \
  if (!(network).entered())                        \
  GTEST_SKIP() << "no network name space here: needs root and ip (iproute2)"
