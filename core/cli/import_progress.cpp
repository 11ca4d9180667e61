#include "core/cli/import_progress.h"

#include <memory>

#include "core/cli/program.h"
#include "core/cli/progress_line.h"

namespace rocinante::cli {

std::function<Status(double)> importProgress(const std::string& name) {
  return [line = std::make_shared<ProgressLine>("importing " + name)](double part) -> Status {
    line->show(part);
    if (stopRequested()) return Error{ErrorKind::refused, "stopped while importing", {}};
    return {};
  };
}

}  // namespace rocinante::cli
