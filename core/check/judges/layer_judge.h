#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/check/judges/tally.h"

namespace rocinante {

/// Judges `layer/NAME`: the layers of a cell are those that it lists and those of its devices.
class LayerJudge {
 public:
  explicit LayerJudge(const Cell& cell);

  void judge(std::string_view layer, const PacketPlace& place);
  void report(Findings& findings) const;
  /// Forgets what was found.
  void dropFindings() { unknown_.clear(); }

 private:
  std::set<std::string, std::less<>> layers_;
  std::map<std::string, Tally, std::less<>> unknown_;
};

}  // namespace rocinante
