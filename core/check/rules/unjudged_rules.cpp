#include "core/check/rules/unjudged_rules.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

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
         {"packet", "device", "joint", "source", "log", "clearance", "drift"}) {
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

}  // namespace rocinante
