#include "golden/command/log_note.h"

#include <string>

#include "core/check/log_account.h"
#include "core/cli/program.h"

namespace rocinante {

void tellLogNote(const std::filesystem::path& log) {
  const auto account = logAccount(log, nullptr);
  const std::string note = account ? account->note() : std::string();
  if (!note.empty()) cli::warn(note);
}

}  // namespace rocinante
