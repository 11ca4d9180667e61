#pragma once

#include <fmt/format.h>
#include <time.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/base/result.h"

namespace rocinante::bench {

inline double secondsOf(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}
/// CPU time in seconds: of the calling thread, and of the whole process.
inline double threadSeconds() { return secondsOf(CLOCK_THREAD_CPUTIME_ID); }
inline double processSeconds() { return secondsOf(CLOCK_PROCESS_CPUTIME_ID); }

/// Time on the wall in seconds, since some moment.
inline double wallSeconds() { return secondsOf(CLOCK_MONOTONIC); }

/// The value; an error ends the bench.
template <class T>
T need(Result<T> result) {
  if (result) return std::move(*result);
  fmt::print(stderr, "{}\n", result.error().text());
  std::exit(2);
}
inline void need(const Status& status) {
  if (status) return;
  fmt::print(stderr, "{}\n", status.error().text());
  std::exit(2);
}

/// Writes cell.toml and arm.urdf: devices arm0, arm1 ... with revolute joints j0, j1 ..., each
/// moved at 1 kHz by a source control0, control1 ...
inline void writeArms(const std::filesystem::path& folder, std::size_t arms, std::size_t joints) {
  std::ofstream urdf(folder / "arm.urdf");
  urdf << "<robot name=\"arm\"> <link name=\"link0\"/>\n";
  for (std::size_t i = 0; i < joints; ++i) {
    urdf << fmt::format(
        "<link name=\"link{1}\"/> <joint name=\"j{0}\" type=\"revolute\"> <parent "
        "link=\"link{0}\"/> <child link=\"link{1}\"/> <axis xyz=\"0 0 1\"/> <limit lower=\"-3\" "
        "upper=\"3\" effort=\"1\" velocity=\"3\"/> </joint>\n",
        i, i + 1);
  }
  urdf << "</robot>\n";
  std::ofstream cell(folder / "cell.toml");
  cell << "format = 1\n";
  for (std::size_t arm = 0; arm < arms; ++arm) {
    cell << fmt::format(
        "[[device]]\nname = \"arm{0}\"\nmodel = \"arm.urdf\"\n[[source]]\nname = \"control{0}\"\n"
        "rate_hz = [900, 1100]\njitter_ms = 5\ndevices = [\"arm{0}\"]\n",
        arm);
  }
}

}  // namespace rocinante::bench
