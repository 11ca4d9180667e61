#include <fmt/format.h>

#include <algorithm>

#include "core/base/plain_text.h"
#include "core/cell/disabled_collisions.h"
#include "core/check/judges/clearance_report.h"
#include "core/cli/text_table.h"
#include "core/report/json_text.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

/// Every two devices, and each device with itself.
void addAll(Cell& cell) {
  CellClearance apart;
  apart.name = "devices";
  apart.between = {"*", "*"};
  CellClearance within;
  within.name = "self";
  within.between = {"*", "*"};
  within.is_self = true;
  exceptDisabledCollisions(cell, within, {}, srdfOnDisk, [](const std::filesystem::path&) {});
  cell.clearances = {apart, within};
}

std::string figure(const CheckedClearance& checked) {
  return checked.least_m > 0 ? fmt::format("{:.2f}", checked.least_m * 1e3) : "penetrating";
}

}  // namespace

bool PoseClearance::areKept() const {
  return std::ranges::all_of(clearances,
                             [](const CheckedClearance& each) { return each.violations == 0; });
}

Result<PoseClearance> poseClearance(Cell& cell, const PoseRequest& request, StateDamage* damage) {
  const Result<SessionState> state = posedState(cell, request, damage);
  if (!state) return state.error();
  const bool are_own = !cell.clearances.empty();
  if (!are_own) addAll(cell);
  const PosedScene scene = poseScene(cell, *state);
  ClearanceJudge judge(cell);
  judge.begin({}, scene, placementOf(scene, *state));
  PoseClearance measured;
  Findings findings;
  reportClearances(cell, judge, measured.clearances, findings);
  if (!request.device.empty()) {
    std::erase_if(measured.clearances, [&](const CheckedClearance& each) {
      return each.device_a != request.device && each.device_b != request.device;
    });
  }
  if (measured.clearances.empty()) {
    return Error{ErrorKind::bad_argument, "no two links with geometry are to be kept apart",
                 cell.shown(cell.file)};
  }
  for (const Finding& finding : findings) {
    if (are_own && finding.rule == "clearance.unjudged") measured.warnings.push_back(finding.text);
  }
  return measured;
}

std::string poseClearanceText(const PoseClearance& measured) {
  cli::TextTable table;
  table.is_number = {false, true, true, false, false};
  table.rows.push_back({"clearance", "mm", "at least", "from", "to"});
  for (const CheckedClearance& each : measured.clearances) {
    table.rows.push_back({plainText(each.name), figure(each), fmt::format("{:g}", each.min_m * 1e3),
                          plainText(each.link_a), plainText(each.link_b)});
  }
  return table.text();
}

std::string poseClearanceJson(const PoseClearance& measured,
                              const std::vector<std::string>& warnings) {
  Json json;
  json["format"] = 1;
  if (!warnings.empty()) json["warnings"] = warnings;
  json["clearances"] = Json::array();
  for (const CheckedClearance& each : measured.clearances) {
    json["clearances"].push_back({{"name", each.name},
                                  {"devices", {each.device_a, each.device_b}},
                                  {"min_m", each.min_m},
                                  {"least_m", each.least_m},
                                  {"penetrating", !(each.least_m > 0)},
                                  {"kept", each.violations == 0},
                                  {"links", {each.link_a, each.link_b}},
                                  {"points", {each.on_a, each.on_b}}});
  }
  return jsonText(json);
}

}  // namespace rocinante
