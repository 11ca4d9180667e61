#pragma once

#include <filesystem>

namespace rocinante {

/// Prints on standard error what of a log, or of a recording that it was imported from, is not
/// judged (LogAccount::note()); nothing where all is, or the log cannot be read.
void tellLogNote(const std::filesystem::path& log);

}  // namespace rocinante
