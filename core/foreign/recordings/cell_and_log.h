#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace rocinante {

/// True for a log, and for a recording that an import reads, by its content; false for a cell or a
/// model, what does not exist, and what can be read only once (a pipe).
bool isRecording(const std::filesystem::path& path);

/// CELL and LOG may be given in either order: their content tells which is which. Exchanges them
/// when the first is a recording and the second is not; of one kind they stay as they were given.
/// True when it exchanged them.
bool orderCellAndLog(std::filesystem::path& cell, std::filesystem::path& log);
bool orderCellAndLog(std::string& cell, std::string& log);

/// The same for a program that needs a LOG and may take its cell from it: one word alone, in the
/// place of the cell, is the log. bad_argument when there is none.
Status orderLogAndItsCell(std::filesystem::path& cell, std::filesystem::path& log);

}  // namespace rocinante
