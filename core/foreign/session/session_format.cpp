#include "core/foreign/session/session_format.h"

namespace rocinante {

std::string topicOf(std::string_view prefix, std::string_view name) {
  return std::string(prefix) + "/" + std::string(name);
}

std::vector<std::vector<double>> connectedRuns(const Drawing& drawing) {
  std::vector<std::vector<double>> runs(1);
  for (const auto& part : drawing.parts) {
    if (part) {
      runs.back().insert(runs.back().end(), part->begin(), part->end());
    } else if (!runs.back().empty()) {
      runs.emplace_back();
    }
  }
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

}  // namespace rocinante
