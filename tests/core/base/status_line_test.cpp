#include "core/cli/status_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <string>

namespace rocinante::cli {
namespace {

void withStandardError(int file, const std::function<void()>& work) {
  const int before = ::dup(STDERR_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::close(file);
  work();
  ::dup2(before, STDERR_FILENO);
  ::close(before);
}

/// The bytes that a terminal gets while it is standard error.
std::string onTerminal(const std::function<void()>& work) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  EXPECT_GE(terminal, 0);
  EXPECT_EQ(::grantpt(terminal), 0);
  EXPECT_EQ(::unlockpt(terminal), 0);
  withStandardError(::open(::ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC), work);
  // Nobody has the other end open: reading ends behind the last byte.
  std::string bytes;
  std::array<char, 256> part{};
  for (ssize_t got = 0; (got = ::read(terminal, part.data(), part.size())) > 0;) {
    bytes.append(part.data(), static_cast<std::size_t>(got));
  }
  ::close(terminal);
  return bytes;
}

TEST(StatusLine, ReplacesItselfAndDoesNotWrap) {
  const std::string bytes = onTerminal([] {
    StatusLine line;
    EXPECT_TRUE(line.isVisible());
    line.show("1 packet");
    line.show("2 packets");
    line.clear();
    line.clear();
  });
  EXPECT_EQ(bytes,
            "\r\033[K\033[?7l1 packet\033[?7h"
            "\r\033[K\033[?7l2 packets\033[?7h"
            "\r\033[K");
}

TEST(StatusLine, DisappearsWithItsOwner) {
  EXPECT_EQ(onTerminal([] { StatusLine().show("busy"); }),
            "\r\033[K\033[?7lbusy\033[?7h"
            "\r\033[K");
  EXPECT_EQ(onTerminal([] { const StatusLine line; }), "");
}

TEST(StatusLine, IsSilentWhereItIsNotVisible) {
  EXPECT_EQ(onTerminal([] { StatusLine(false).show("busy"); }), "");
  withStandardError(::open("/dev/null", O_WRONLY | O_CLOEXEC),
                    [] { EXPECT_FALSE(StatusLine().isVisible()); });
}

}  // namespace
}  // namespace rocinante::cli
