#pragma once

#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace rocinante::test {

/// The memory of a process that no file stands behind (RssAnon), bytes; 0 when it is gone.
inline std::uint64_t anonymousBytes(::pid_t process = ::getpid()) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  std::string word;
  while (status >> word) {
    std::uint64_t kibibytes = 0;
    if (word == "RssAnon:" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

}  // namespace rocinante::test
