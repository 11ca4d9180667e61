#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante::test {

/// One example of a rule's page: a cell and a session. docs/rules/README.md, section "How a page is
/// written", defines the notation.
struct RuleExample {
  std::map<std::string, std::string> files;  ///< by name, as bytes
  std::string cell = "cell.toml";            ///< which of them is the cell
  std::string session;                       ///< text of the `session` block
  bool has_session = false;
  std::vector<std::string> also;  ///< other rules that the example fires too
  std::string cannot_show;        ///< why there is no example; empty where there is one
};

/// docs/rules/ID.md.
struct RulePage {
  std::string rule;      ///< the heading
  std::string severity;  ///< "error", as the page's second paragraph begins
  std::string text;      ///< the whole page
  RuleExample fires, silent;
};

/// Reads a page. `defaults` are the blocks that a page does not have itself: those of
/// docs/rules/README.md. An error names the page and line.
Result<RulePage> readRulePage(const std::filesystem::path& path, const RuleExample& defaults);

/// The blocks of docs/rules/README.md before its first section.
Result<RuleExample> readRuleDefaults(const std::filesystem::path& readme);

}  // namespace rocinante::test
