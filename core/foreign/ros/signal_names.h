#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace rocinante::ros {

/// Gives each thing of a bag a name for its signals that no other one has: bytes that a name writes
/// percent-encoded, and dots, become `_`, and where two things would have one name the later gets a
/// number, NAME:2. Names have at most 85 bytes. A plain value.
class SignalNames {
 public:
  /// The name of `what`, which is written as `text`; the same each time. `/left/imu` is `left:imu`.
  const std::string& of(std::string_view what, std::string_view text);
  const std::string& of(std::string_view what) { return of(what, what); }
  /// Whether its name has a number.
  bool isNumbered(std::string_view what) const { return numbered_.contains(what); }

 private:
  std::map<std::string, std::string, std::less<>> names_;
  std::set<std::string, std::less<>> taken_, numbered_;
};

}  // namespace rocinante::ros
