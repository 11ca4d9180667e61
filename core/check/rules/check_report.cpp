#include "core/check/rules/check_report.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <tuple>

namespace rocinante {
namespace {

bool hasFile(const Cell& cell, std::initializer_list<std::string_view> endings) {
  return std::ranges::any_of(cell.files, [&](const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return std::ranges::find(endings, ending) != endings.end();
  });
}

bool hasJoint(const Cell& cell) {
  return std::ranges::any_of(cell.models, [](const auto& each) {
    return each.second != nullptr && !each.second->joints.empty();
  });
}

}  // namespace

std::map<std::string, std::string, std::less<>> unjudgedRules(const Cell& cell, bool has_session) {
  std::map<std::string, std::string, std::less<>> unjudged;
  if (!has_session) {
    for (const char* const part :
         {"packet", "device", "joint", "signal", "source", "log", "clearance", "drift"}) {
      unjudged[part] = "no session was given";
    }
  } else {
    if (!hasJoint(cell)) unjudged["joint"] = "no model of the cell has a joint";
    if (cell.clearances.empty()) unjudged["clearance"] = "the cell has no [[clearance]]";
    unjudged["drift"] = "no cell of the recording was compared";
  }
  unjudged["baseline"] = "no --baseline was given";
  const auto needs = [&](const char* part, std::initializer_list<std::string_view> endings,
                         const char* what) {
    if (!hasFile(cell, endings)) unjudged[part] = std::string("the cell has no file of ") + what;
  };
  needs("urdf", {".urdf", ".xacro", ".xml"}, "URDF");
  needs("sdf", {".sdf", ".world"}, "SDF");
  needs("obj", {".obj"}, "OBJ");
  needs("mtl", {".mtl"}, "MTL");
  needs("stl", {".stl"}, "STL");
  needs("collada", {".dae"}, "COLLADA");
  needs("mesh", {".stl", ".obj", ".dae", ".gltf", ".glb"}, "a mesh");
  return unjudged;
}

std::string_view nameOf(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::compatible:
      return "compatible";
    case CheckVerdict::incompatible:
      return "incompatible";
    case CheckVerdict::nothing_judged:
      return "nothing_judged";
    case CheckVerdict::interrupted:
      return "interrupted";
  }
  return "";
}

std::size_t CheckReport::countOf(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(),
      [&](const Finding& finding) { return finding.severity == severity && !finding.accepted; }));
}

std::size_t CheckReport::countOfAccepted() const {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(), [](const Finding& finding) { return finding.accepted; }));
}

void conclude(CheckReport& report) {
  report.rules.apply(report.findings);
  const auto key = [](const Finding& f) {
    // Errors first; model faults before session faults.
    return std::tuple(-static_cast<int>(f.severity), f.first.has_value(),
                      f.first.value_or(LogTime{}), std::string_view(f.file), f.line, f.column,
                      std::string_view(f.rule), std::string_view(f.subject),
                      std::string_view(f.text));
  };
  std::sort(report.findings.begin(), report.findings.end(),
            [&](const Finding& a, const Finding& b) { return key(a) < key(b); });
  const bool failed = std::any_of(report.findings.begin(), report.findings.end(),
                                  [&](const Finding& f) { return report.isFailure(f); });
  if (report.interrupted) {
    report.verdict = CheckVerdict::interrupted;
  } else if (report.has_session && report.packets == 0) {
    report.verdict = CheckVerdict::nothing_judged;
  } else {
    report.verdict = failed ? CheckVerdict::incompatible : CheckVerdict::compatible;
  }
}

}  // namespace rocinante
