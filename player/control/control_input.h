#pragma once

#include <poll.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// An input for commands to a running player: a socket or a keyboard. One thread.
class ControlInput {
 public:
  virtual ~ControlInput() = default;

  /// Executes one command line and returns its answer; empty for none.
  using Ask = std::function<std::string(std::string)>;

  /// Adds the descriptors to poll, none of them negative.
  virtual void addDescriptors(std::vector<pollfd>& descriptors) const = 0;
  /// Serves pending input without waiting. Called when any input is ready.
  virtual void serve(const Ask& ask) = 0;
  /// Sends an unrequested line to the last client, or to the next one if there is none yet.
  virtual void tell(const std::string& line) = 0;
};

}  // namespace rocinante
