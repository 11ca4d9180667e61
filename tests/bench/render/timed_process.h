#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rocinante::bench {

/// What a program took from its start to its end.
struct ProcessTimes {
  double wall_s = 0;
  double cpu_s = 0;  ///< of it and its children, system included
};

/// Runs a program to its end, silently; empty when it cannot be run or does not answer 0.
std::optional<ProcessTimes> timedRun(const std::vector<std::string>& words,
                                     const std::map<std::string, std::string>& environment = {});

/// An X server without a screen, on a display of its own; gone with the object.
class VirtualDisplay {
 public:
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  /// ":7"; empty when there is no Xvfb.
  const std::string& name() const { return name_; }

 private:
  int pid_ = -1;
  std::string name_;
};

/// The path of an installed program; empty when it is not.
std::string installed(const std::string& name);

}  // namespace rocinante::bench
