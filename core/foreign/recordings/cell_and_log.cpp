#include "core/foreign/recordings/cell_and_log.h"

#include <utility>

#include "core/bundle/cell_or_log.h"
#include "core/foreign/recordings/recording_kind.h"

namespace rocinante {

bool isRecording(const std::filesystem::path& path) {
  std::error_code fault;
  const auto status = std::filesystem::status(path, fault);
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status)) {
    return false;
  }
  return isLog(path) || isForeign(recordingKindOf(path));
}

namespace {

bool isExchanged(const std::filesystem::path& cell, const std::filesystem::path& log) {
  return !cell.empty() && !log.empty() && isRecording(cell) && !isRecording(log);
}

}  // namespace

bool orderCellAndLog(std::filesystem::path& cell, std::filesystem::path& log) {
  if (!isExchanged(cell, log)) return false;
  std::swap(cell, log);
  return true;
}

bool orderCellAndLog(std::string& cell, std::string& log) {
  if (!isExchanged(cell, log)) return false;
  std::swap(cell, log);
  return true;
}

Status orderLogAndItsCell(std::filesystem::path& cell, std::filesystem::path& log) {
  if (log.empty()) {
    log = std::exchange(cell, {});
  } else if (!orderCellAndLog(cell, log)) {
    // Of a missing log behind which a cell stands, the error is to name the log.
    std::error_code fault;
    if (!std::filesystem::exists(cell, fault) && !isRecording(log)) std::swap(cell, log);
  }
  if (log.empty()) return Error{ErrorKind::bad_argument, "LOG is required", {}};
  return {};
}

}  // namespace rocinante
