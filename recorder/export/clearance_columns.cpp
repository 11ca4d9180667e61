#include "recorder/export/clearance_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/pattern.h"
#include "core/clearance/clearance_gauge.h"
#include "core/foreign/table/table_column.h"

namespace rocinante {
namespace {

ClearanceGauge::Chosen chosenBy(const std::vector<std::string>& devices) {
  if (devices.empty()) return {};
  return [devices](std::string_view a, std::string_view b) {
    return anyPatternMatches(devices, a) || anyPatternMatches(devices, b);
  };
}

}  // namespace

ClearanceColumns::ClearanceColumns(const Cell& cell, const std::vector<std::string>& devices)
    : cell_(cell), has_patterns_(!devices.empty()), gauge_(cell, chosenBy(devices)) {}

void ClearanceColumns::layOut() {
  columns_.clear();
  for (const ClearanceGap& gap : gauge_.gaps()) {
    columns_.push_back(fmt::format("{}{}/{}/{}", kClearanceColumn,
                                   cell_.clearances[gap.clearance].name, gap.device_a,
                                   gap.device_b));
  }
}

void ClearanceColumns::fill(const SessionState& state, std::span<double> row) {
  gauge_.measure(state, distances_m_);
  for (std::size_t i = 0; i < row.size() && i < distances_m_.size(); ++i) {
    row[i] = std::isnan(distances_m_[i]) ? distances_m_[i] : roundedClearance(distances_m_[i]);
  }
}

std::vector<std::string> ClearanceColumns::gaps() const {
  std::vector<std::string> sentences;
  if (!has_patterns_) {
    for (const std::size_t i : gauge_.unmeasured()) {
      sentences.push_back(fmt::format("no two links with geometry are those of the clearance `{}`",
                                      cell_.clearances[i].name));
    }
  }
  if (gauge_.hadTooMany()) {
    sentences.push_back(
        fmt::format("the clearances name more than {} pairs of links: the rest is not measured",
                    kMaxClearancePairs));
  }
  return sentences;
}

}  // namespace rocinante
