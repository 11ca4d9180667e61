#pragma once

#include <poll.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "player/control/command_slot.h"

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

/// Listens for commands in its own thread while a player runs.
class ControlThread {
 public:
  /// `slot` must outlive this.
  ControlThread(CommandSlot& slot, std::vector<std::unique_ptr<ControlInput>> inputs);
  /// Closes the slot.
  ~ControlThread();
  ControlThread(const ControlThread&) = delete;
  ControlThread& operator=(const ControlThread&) = delete;

 private:
  void serveUntilClosed();

  CommandSlot& slot_;
  std::vector<std::unique_ptr<ControlInput>> inputs_;
  std::thread thread_;
};

}  // namespace rocinante
