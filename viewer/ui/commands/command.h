#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/window/frame_input.h"

namespace rocinante {

/// What a command acts on. Whatever the model cannot do itself becomes a request, which the program
/// answers directly after the command.
struct CommandStage {
  ViewModel& model;
  SteadyTime now;
  int height_px = 1;  ///< of the picture: drags are relative to it
  ViewerRequests& requests;
  FrameInput* input = nullptr;  ///< of a script: what its coming frames see of mouse and keyboard
};

using CommandWords = std::span<const std::string>;

/// A key that runs a command with these words.
struct Shortcut {
  std::string_view key;    ///< as parseKey() takes it: "shift+H"
  std::string_view words;  ///< separated by spaces; may be empty
  std::string_view means;  ///< for help and palette; empty: what the command means
};

enum class CommandGroup { time, camera, picture, program, script };

/// One command of the window. Keys, scripts, the command palette, the help panel and
/// docs/programs/view.md all take it from this one description. The texts outlive it.
struct Command {
  std::string_view name{};
  /// One word each, optional ones in brackets and last: "DX DY", "[on|off]"; "[TEXT...]" and
  /// "TEXT..." take any number.
  std::string_view arguments{};
  std::string_view means{};
  CommandGroup group = CommandGroup::program;
  /// bad_argument, without a place, when the words are invalid. Their number is right.
  Status (*run)(CommandWords, const CommandStage&) = nullptr;
  std::vector<Shortcut> shortcuts{};
  bool needs_log = false;
  /// Whether the palette offers it now; null: always.
  bool (*offered)(const ViewModel&) = nullptr;
  bool repeats = false;           ///< while its key is held
  std::string_view keys_shown{};  ///< one text for all shortcuts: "1 to 9"
  /// Values that its first argument may have now, for the palette; null: unknown.
  std::vector<std::string> (*choices)(const ViewModel&) = nullptr;

  std::size_t leastWords() const;
  std::size_t mostWords() const;
};

/// All commands, group by group in the order of CommandGroup; made once.
const std::vector<Command>& allCommands();

/// Null for an unknown name.
const Command* findCommand(std::string_view name);

/// Checks name and number of the words. bad_argument without a place.
Result<const Command*> checkCommand(std::string_view name, std::size_t words);

/// Runs one command: checkCommand(), whether it needs a log, then its own checks.
Status runCommand(std::string_view name, CommandWords words, const CommandStage& stage);

/// Words separated by blanks.
std::vector<std::string> splitWords(std::string_view line);

}  // namespace rocinante
