#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/ui/commands/command.h"

/// The parts of allCommands(), one file each, and what their actions share. Only they include this.
namespace rocinante {

std::vector<Command> timeCommands();
/// A growing session: live, or a log that is still written.
std::vector<Command> liveCommands();
/// Endpoints, and live sessions behind what is shown.
std::vector<Command> connectCommands();
/// Plots and findings.
std::vector<Command> plotCommands();
std::vector<Command> cameraCommands();
std::vector<Command> pictureCommands();
/// Joints moved by hand.
std::vector<Command> handCommands();
/// Devices moved by hand.
std::vector<Command> moveCommands();
/// Poses, distances and the packets behind values.
std::vector<Command> inspectCommands();
/// Pictures of a real camera.
std::vector<Command> backdropCommands();
/// What other windows see of this one.
std::vector<Command> publishCommands();
std::vector<Command> programCommands();
/// What only a script needs.
std::vector<Command> scriptCommands();
/// Mouse and keyboard of a script.
std::vector<Command> inputCommands();

/// "next" or "previous", as true or false. bad_argument without a place.
Result<bool> isNext(const std::string& word);

/// A finite number. bad_argument without a place.
Result<double> numberOf(const std::string& word);

/// "on" or "off"; without a word, the opposite of `now`. bad_argument without a place.
Result<bool> switched(CommandWords words, bool now);

/// A key as a script names it: as parseKey() does, but in any case, Ctrl and Shift in any order,
/// and as tables of keys have it (Esc, comma, full-stop). bad_argument without a place.
Result<KeyPress> keyOf(const std::string& word);

/// bad_argument without a place.
Error badWord(std::string what);

}  // namespace rocinante
