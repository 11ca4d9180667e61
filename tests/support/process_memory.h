#pragma once

#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace rocinante::test {

/// A size of /proc/PROCESS/status, bytes; 0 when the process is gone.
inline std::uint64_t statusBytes(::pid_t process, std::string_view field) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  std::string word;
  while (status >> word) {
    std::uint64_t kibibytes = 0;
    if (word == field && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

/// The memory of a process that no file stands behind (RssAnon), bytes; 0 when it is gone.
inline std::uint64_t anonymousBytes(::pid_t process = ::getpid()) {
  return statusBytes(process, "RssAnon:");
}

/// The most memory that a process ever held (VmHWM), bytes; 0 when it is gone.
inline std::uint64_t mostBytes(::pid_t process) { return statusBytes(process, "VmHWM:"); }

}  // namespace rocinante::test
