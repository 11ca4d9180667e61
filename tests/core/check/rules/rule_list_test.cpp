#include "core/check/rules/rule_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// Every string literal of the form "family.some-rule" in the code that finds faults.
std::set<std::string> rulesInTheSource() {
  const auto isWord = [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; };
  // Of files, and of the class that JUnit shows.
  const std::set<std::string, std::less<>> endings = {
      "toml", "urdf", "json", "html", "xacro", "sdf", "dae", "gltf", "glb", "xml", "check"};
  std::set<std::string> found;
  for (const char* folder :
       {"core/check", "core/cell", "core/document", "core/kinematics", "core/mesh"}) {
    const fs::path path = fs::path(ROCINANTE_SOURCE_DIR) / folder;
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.path().filename() == "rule_list.cpp") continue;
      std::ifstream file(entry.path());
      std::string line;
      while (std::getline(file, line)) {
        // A comment may give an example of a rule that does not exist.
        if (line.find("//") < line.find('"')) continue;
        for (std::size_t from = line.find('"'); from != std::string::npos;) {
          const std::size_t until = line.find('"', from + 1);
          if (until == std::string::npos) break;
          const std::string text = line.substr(from + 1, until - from - 1);
          const std::size_t dot = text.find('.');
          const bool is_rule =
              dot != std::string::npos && dot > 0 && dot + 1 < text.size() &&
              std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(dot), isWord) &&
              std::all_of(text.begin() + static_cast<std::ptrdiff_t>(dot) + 1, text.end(), isWord);
          if (is_rule && !endings.contains(text.substr(dot + 1))) found.insert(text);
          from = line.find('"', until + 1);
        }
      }
    }
  }
  return found;
}

TEST(RuleList, HasEveryRuleThatTheCodeFinds) {
  const std::set<std::string> in_source = rulesInTheSource();
  EXPECT_GT(in_source.size(), 100U);  // else the search itself is broken
  for (const std::string& id : in_source) {
    EXPECT_NE(findRule(id), nullptr)
        << id << " is found, and not in core/check/rules/rule_list.cpp";
  }
}

TEST(RuleList, FindsEachRuleByItsIdAndNothingElse) {
  for (const Rule& rule : allRules()) EXPECT_EQ(findRule(rule.id), &rule) << rule.id;
  for (const char* id : {"", "packet", "packet.", "a.a", "zzz.z", "joint.limits", "Joint.limit"}) {
    EXPECT_EQ(findRule(id), nullptr) << id;
  }
}

TEST(RuleList, KnowsWhatConcernsPicturesOnly) {
  for (const char* id :
       {"mesh.texture", "obj.bad-number", "mtl.no-material", "model.missing-file"}) {
    EXPECT_TRUE(isOfPicturesOnly(id)) << id;
  }
  for (const char* id : {"cell.missing-file", "urdf.xml", "joint.limit", "meshes.x", ""}) {
    EXPECT_FALSE(isOfPicturesOnly(id)) << id;
  }
}

TEST(RuleList, IsWrittenForPeople) {
  for (const Rule& rule : allRules()) {
    EXPECT_FALSE(rule.title.empty()) << rule.id;
    EXPECT_FALSE(rule.title.ends_with('.')) << rule.id;
    EXPECT_LE(rule.title.size(), 70U) << rule.id;
    EXPECT_GE(rule.threshold.value, 0.0) << rule.id;
  }
}

}  // namespace
}  // namespace rocinante
