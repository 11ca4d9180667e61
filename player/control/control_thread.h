#pragma once

#include <memory>
#include <thread>
#include <vector>

#include "player/control/command_slot.h"
#include "player/control/control_input.h"

namespace rocinante {

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
