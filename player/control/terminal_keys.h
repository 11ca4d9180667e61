#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "player/control/control_input.h"

namespace rocinante {

/// What a person typed, as commands: space toggles, the arrows right and left step a message on and
/// back, up and down a second, + and - change the speed, n and p go to the next event and the one
/// before, q quits. An arrow may come in pieces.
class KeyReader {
 public:
  /// The command that `key` completes; empty when there is none (yet).
  std::string_view take(char key);

 private:
  std::string sequence_;  ///< the beginning of an escape sequence
};

/// Makes the terminal what it was before TerminalKeys, if they are open. For signal handlers too.
void giveTerminalBack();

/// The keyboard of the terminal that the program runs in. While this lives the terminal gives each
/// key at once and shows none; what it was like before comes back at the end, however that comes:
/// also by a second Ctrl-C, another signal, or while the program is stopped (Ctrl-Z).
class TerminalKeys final : public ControlInput {
 public:
  /// Null when there is no terminal to read from, or the program runs in its background. One at a
  /// time. After cli::catchStopSignals().
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
