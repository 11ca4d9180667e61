#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Runs git, `line` from its name on: what it prints. refused, with its complaint, when it fails;
/// `place` is where that is said to be.
Result<std::string> gitOutput(std::vector<std::string> line, const std::filesystem::path& place);
/// The same in a folder; empty: this one.
Result<std::string> gitIn(const std::filesystem::path& folder, std::vector<std::string> words);

std::string firstLineOf(const std::string& text);
/// What git complained of: the line that says so, as hints and progress may come first.
std::string complaintIn(const std::string& text);
/// What lies between the ends, without empty parts.
std::vector<std::string> partsOf(const std::string& text, char end);

}  // namespace rocinante
