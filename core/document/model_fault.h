#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rocinante {

enum class Severity : std::uint8_t { note, warning, error };
std::string_view nameOf(Severity severity);

/// A fault of a model or cell file. Reading continues after it: all faults are listed.
struct ModelFault {
  Severity severity = Severity::error;
  std::string rule;  ///< stable id: "urdf.unknown-link"
  std::string file;
  int line = 0;  ///< from 1; 0 when there is none
  int column = 0;
  std::string text;  ///< one sentence
  std::string hint;  ///< what to do about it; may be empty

  /// "cell.toml:12:3: error: unknown key `colour` (did you mean `color`?) [cell.unknown-key]"
  std::string print() const;
};

using ModelFaults = std::vector<ModelFault>;

}  // namespace rocinante
