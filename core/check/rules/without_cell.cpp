#include "core/check/rules/without_cell.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/check/rules/rule_list.h"

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 5> kOfSession{"baseline", "log", "packet", "signal",
                                                     "source"};
/// Of those: rules that compare what is said with the cell.
constexpr std::array<std::string_view, 10> kOfBoth{
    "packet.before-add",       "packet.joint-count",    "packet.other-kinematics",
    "packet.undrivable-joint", "packet.unknown-device", "packet.unknown-joint",
    "packet.unknown-layer",    "packet.unknown-link",   "packet.unknown-model",
    "signal.missing"};

std::string_view firstPart(std::string_view rule) { return rule.substr(0, rule.find('.')); }

}  // namespace

bool judgesWithoutCell(std::string_view rule) {
  return std::ranges::find(kOfSession, firstPart(rule)) != kOfSession.end() &&
         std::ranges::find(kOfBoth, rule) == kOfBoth.end();
}

void concludeWithoutCell(CheckReport& report) {
  const std::string why = "there is no cell";
  report.has_cell = false;
  std::erase_if(report.findings,
                [](const Finding& finding) { return !judgesWithoutCell(finding.rule); });
  for (const Rule& rule : allRules()) {
    if (judgesWithoutCell(rule.id)) continue;
    const std::string_view part = firstPart(rule.id);
    const bool is_whole = std::ranges::find(kOfSession, part) == kOfSession.end();
    report.unjudged[std::string(is_whole ? part : rule.id)] = why;
  }
  conclude(report);
}

std::string_view withoutCellSentence() {
  return "There is no cell: packets, signals, sources and the log are judged by themselves, and "
         "nothing by devices, joints, limits, clearances or the cell's [[signal]]s and "
         "[[source]]s.";
}

}  // namespace rocinante
