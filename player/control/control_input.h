#pragma once

#include <poll.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// A way by which commands come to a running player: a socket, or a keyboard. One thread.
class ControlInput {
 public:
  virtual ~ControlInput() = default;

  /// Does one line's command and gives its answer; empty when there is none.
  using Ask = std::function<std::string(std::string)>;

  /// What to wait for. A descriptor may not be negative.
  virtual void addDescriptors(std::vector<pollfd>& descriptors) const = 0;
  /// Something has come, here or elsewhere: serves what there is without waiting.
  virtual void serve(const Ask& ask) = 0;
  /// Says something unasked to who spoke last, or as soon as somebody does.
  virtual void tell(const std::string& line) = 0;
};

}  // namespace rocinante
