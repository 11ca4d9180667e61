#include "core/cli/load_progress.h"

#include <memory>

#include "core/cli/progress_line.h"

namespace rocinante::cli {

TellLoadProgress loadProgress(const std::string& name) {
  return [line = std::make_shared<ProgressLine>("loading " + name)](const LoadProgress& now) {
    if (now.files_done == now.files_total) return line->clear();
    const auto total = static_cast<double>(now.bytes_total);
    line->show(total > 0 ? static_cast<double>(now.bytes_done) / total : 1.0);
  };
}

}  // namespace rocinante::cli
