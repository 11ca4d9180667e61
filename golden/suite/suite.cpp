#include "golden/suite/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/atomic_file.h"
#include "golden/store/git_store.h"
#include "golden/suite/merge_conflict.h"
#include "golden/suite/suite_case.h"
#include "golden/suite/suite_table.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxSuiteBytes = 16U << 20U;

void readFiles(SuiteTable& root, Suite& suite) {
  const std::filesystem::path folder = suite.file.parent_path();
  if (const auto cell = root.text("cell")) suite.cell = folder / *cell;
  if (const auto log = root.text("log")) suite.log = folder / *log;
  if (suite.cell.empty() && !suite.log) {
    root.complainHere("a suite needs a `cell`, or a `log` that carries one");
  }
  suite.goldens = folder / root.text("goldens").value_or("goldens");
  const auto store = root.text("store");
  if (!store) return;
  if (!store->starts_with(kGitStorePrefix)) {
    suite.store = folder / *store;
    return;
  }
  auto ref = storeRef(*store);
  if (ref.ok()) {
    suite.store_ref = std::move(*ref);
  } else {
    root.complain(*root.node("store"), ref.error().what);
  }
}

void readTolerances(SuiteTable& root, Suite& suite) {
  const TomlNode* tolerances = root.table("tolerance");
  if (tolerances == nullptr) return;
  for (const TomlNode::Entry& entry : tolerances->entries) {
    if (entry.value.kind != TomlNode::Kind::table || !isCaseName(entry.key)) {
      root.complain(entry.value, "tolerances must be tables: [tolerance.NAME]");
    } else if (Tolerance::named(entry.key).ok()) {
      root.complain(entry.value, fmt::format("`{}` is a tier: choose another name", entry.key));
    } else {
      SuiteTable limits(entry.value, root.file(), root.fault());
      suite.tolerances[entry.key] = readLimits(limits, entry.key);
    }
  }
}

void readCases(SuiteTable& root, const SuiteCase& defaults, Suite& suite) {
  const TomlNode* cases = root.node("case");
  if (cases == nullptr) return;
  if (cases->kind != TomlNode::Kind::array ||
      !std::ranges::all_of(
          cases->items, [](const TomlNode& item) { return item.kind == TomlNode::Kind::table; })) {
    root.complain(*cases, "cases must be tables: [[case]]");
    return;
  }
  std::set<std::string> names;
  for (const TomlNode& item : cases->items) {
    SuiteTable table(item, root.file(), root.fault());
    SuiteCase& made = suite.cases.emplace_back(defaults);
    made.line = item.place.line;
    readCase(table, suite, made);
    if (!names.insert(made.name).second) {
      root.complain(item, fmt::format("two cases are named `{}`", made.name));
    }
  }
}

void readRuns(SuiteTable& root, Suite& suite) {
  const TomlNode* runs = root.node("run");
  if (runs == nullptr) return;
  if (runs->kind != TomlNode::Kind::array ||
      !std::ranges::all_of(
          runs->items, [](const TomlNode& item) { return item.kind == TomlNode::Kind::table; })) {
    root.complain(*runs, "runs must be tables: [[run]]");
    return;
  }
  std::set<std::string> names;
  for (const SuiteCase& made : suite.cases) names.insert(made.name);
  for (const TomlNode& item : runs->items) {
    SuiteTable table(item, root.file(), root.fault());
    SuiteRun& made = suite.runs.emplace_back(readSuiteRun(table));
    made.line = item.place.line;
    if (!names.insert(made.name).second) {
      root.complain(item, fmt::format("two cases or runs are named `{}`", made.name));
    }
  }
}

}  // namespace

std::string PictureArea::text() const { return rectangle ? rectangle->text() : path; }

Result<Suite> parseSuite(std::string_view text, const std::filesystem::path& path) {
  const std::string file = path.string();
  const auto root_node = parseToml(text, file);
  if (!root_node.ok()) {
    return mergeConflictIn(text, file, "the suite", "keep what you want of both sides")
        .value_or(root_node.error());
  }

  std::optional<Error> fault;
  SuiteTable root(*root_node, file, fault);
  root.onlyKeys(
      {"format", "cell", "log", "goldens", "store", "defaults", "tolerance", "case", "run"});
  if (root.integer("format").value_or(0) != 1) {
    root.complainHere("a suite must begin with `format = 1`");
  }
  Suite suite;
  suite.file = path;
  readFiles(root, suite);
  readTolerances(root, suite);
  SuiteCase defaults;
  if (const TomlNode* node = root.table("defaults")) {
    SuiteTable table(*node, file, fault);
    readDefaults(table, suite, defaults);
  }
  readCases(root, defaults, suite);
  readRuns(root, suite);
  if (suite.cases.empty() && suite.runs.empty()) {
    root.complainHere("a suite needs at least one [[case]] or [[run]]");
  }
  if (fault) return *fault;
  return suite;
}

Result<Suite> readSuite(const std::filesystem::path& path) {
  const auto text = readFile(path, kMaxSuiteBytes);
  if (!text.ok()) return text.error();
  return parseSuite(*text, path);
}

}  // namespace rocinante
