#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "player/control/control_thread.h"

namespace rocinante {

/// Translates keys to commands: space toggles, the right and left arrows step a message forwards
/// and back, up and down a second, + and - change the speed, n and p go to the next and the
/// previous event, q quits. The bytes of an arrow may come separately.
class KeyReader {
 public:
  /// The command that `key` completes; empty for none (yet).
  std::string_view take(char key);

 private:
  std::string sequence_;  ///< the beginning of an escape sequence
};

/// Restores the terminal if TerminalKeys are open. Safe in signal handlers.
void restoreTerminal();

/// The keyboard of the controlling terminal. While this lives the terminal delivers each key at
/// once without echo; its former mode is restored at the end, including after a second Ctrl-C or
/// another signal, and while the program is stopped (Ctrl-Z).
class TerminalKeys final : public ControlInput {
 public:
  /// Null without a terminal, or when the program runs in its background. One at a time. Call after
  /// cli::catchStopSignals().
  static std::unique_ptr<TerminalKeys> open();
  ~TerminalKeys() override;

  void addDescriptors(std::vector<pollfd>& descriptors) const override;
  void serve(const Ask& ask) override;
  void tell(const std::string& line) override;

 private:
  TerminalKeys() = default;

  KeyReader reader_;
  bool over_ = false;  ///< the terminal is gone
};

}  // namespace rocinante
