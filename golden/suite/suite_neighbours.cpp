#include "golden/suite/suite_neighbours.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/base/plain_text.h"
#include "golden/suite/suite_plan.h"

namespace rocinante {
namespace {

/// More files in one folder are not read.
constexpr std::size_t kMaxFiles = 1'000;

bool isSameFolder(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code fault_a, fault_b;
  const auto whole_a = std::filesystem::weakly_canonical(a, fault_a);
  const auto whole_b = std::filesystem::weakly_canonical(b, fault_b);
  return !fault_a && !fault_b && whole_a == whole_b;
}

bool mayHaveFrame(const SuiteCase& made, std::string_view name) {
  if (!name.starts_with(made.name)) return false;
  name.remove_prefix(made.name.size());
  const bool has_moments = made.moment.events || made.moment.every;
  const auto isMoment = [&](std::string_view rest) {
    return rest.empty() || (has_moments && rest.front() == '-');
  };
  if (made.cameras.size() < 2) return isMoment(name);
  return std::ranges::any_of(made.cameras, [&](const std::string& camera) {
    const std::string word = "." + fileWord(camera);
    return name.starts_with(word) && isMoment(name.substr(word.size()));
  });
}

}  // namespace

std::vector<Suite> neighboursOf(const Suite& suite) {
  std::vector<Suite> neighbours;
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = suite.file.parent_path();
  std::error_code fault;
  std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, fault);
  for (const std::filesystem::directory_iterator end; !fault && entries != end;
       entries.increment(fault)) {
    const std::filesystem::path& file = entries->path();
    std::error_code ignored;
    if (file.extension() != ".toml" || !entries->is_regular_file(ignored)) continue;
    if (file.filename() == suite.file.filename()) continue;
    if (files.size() == kMaxFiles) break;
    files.push_back(file);
  }
  std::ranges::sort(files);
  for (const std::filesystem::path& file : files) {
    auto other = readSuite(file);
    if (other.ok() && isSameFolder(other->goldens, suite.goldens)) {
      neighbours.push_back(std::move(*other));
    }
  }
  return neighbours;
}

std::string sharedGolden(const std::vector<Suite>& neighbours, GoldenKind kind,
                         std::string_view name) {
  const auto has = [&](const auto& list) {
    return std::ranges::any_of(list, [&](const auto& one) { return one.name == name; });
  };
  for (const Suite& other : neighbours) {
    if (!(kind == GoldenKind::run ? has(other.runs) : has(other.cases))) continue;
    return fmt::format(
        "{} {} of {} has the same goldens; a suite has its own with `goldens = "
        "\"FOLDER\"`",
        kind == GoldenKind::run ? "run" : "case", plainText(name),
        plainText(other.file.filename().string()));
  }
  return {};
}

bool mayHaveFrame(const Suite& suite, std::string_view name) {
  return std::ranges::any_of(suite.cases,
                             [&](const SuiteCase& made) { return mayHaveFrame(made, name); });
}

}  // namespace rocinante
