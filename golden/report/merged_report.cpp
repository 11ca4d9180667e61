#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "golden/judge/housekeeping.h"
#include "golden/report/report_reader.h"

namespace rocinante {
namespace {

/// A command of one shard, changed to one of the whole suite.
std::string withoutShard(std::string command, const SuiteReport& part) {
  const std::string option = fmt::format(" --shard {}/{}", part.shard, part.shards);
  const std::size_t at = command.find(option);
  if (part.shards > 1 && at != std::string::npos) command.erase(at, option.size());
  return command;
}

Status checkShards(const std::vector<SuiteReport>& parts) {
  std::map<std::string, std::set<int>> seen;
  std::map<std::string, const SuiteReport*> first;
  for (const SuiteReport& part : parts) {
    const auto refuse = [&](std::string what) {
      return Error{ErrorKind::refused, std::move(what), part.suite};
    };
    const SuiteReport& one = *first.emplace(part.suite, &part).first->second;
    if (part.shards != one.shards) {
      return refuse(fmt::format("shards come from different runs (of {} and of {} shards)",
                                one.shards, part.shards));
    }
    if (part.session != one.session) return refuse("the shards judged different sessions");
    if (part.renderer != one.renderer) {
      return refuse(fmt::format("the shards were drawn by different renderers: {} and {}",
                                one.renderer, part.renderer));
    }
    if (!seen[part.suite].insert(part.shard).second) {
      return refuse(fmt::format("shard {}/{} was given twice", part.shard, part.shards));
    }
  }
  for (const auto& [suite, shards] : seen) {
    for (int shard = 1; shard <= first[suite]->shards; ++shard) {
      if (shards.contains(shard)) continue;
      return Error{ErrorKind::refused,
                   fmt::format("shard {}/{} is missing", shard, first[suite]->shards), suite};
    }
  }
  return {};
}

}  // namespace

Result<SuiteReport> mergeReports(std::vector<SuiteReport> parts) {
  if (auto whole = checkShards(parts); !whole) return whole.error();
  std::ranges::stable_sort(
      parts, {}, [](const SuiteReport& part) { return std::pair(part.suite, part.shard); });
  const bool is_one_suite = parts.front().suite == parts.back().suite;
  SuiteReport merged = parts.front();
  merged.frames.clear();
  merged.runs.clear();
  merged.notes.clear();
  merged.shard = merged.shards = 1;
  for (std::string* command : {&merged.run_command, &merged.approve_command}) {
    *command = is_one_suite ? withoutShard(*command, parts.front()) : std::string();
  }
  // Runs are in the command of the shard that judged them.
  for (const SuiteReport& part : parts) {
    if (!is_one_suite) break;
    std::string command = withoutShard(part.approve_command, part);
    if (command.size() > merged.approve_command.size()) merged.approve_command = std::move(command);
  }
  // A list of approvals belongs to one suite.
  if (!is_one_suite) {
    merged.run_one_command.clear();
    merged.approve_one_command.clear();
    merged.approve_from_command.clear();
  }
  for (const SuiteReport& part : parts) {
    if (merged.cell_files.empty() && is_one_suite) merged.cell_files = part.cell_files;
  }
  std::set<std::string> names;
  for (auto part = parts.begin(); part != parts.end();) {
    const std::string suite = part->suite;
    if (suite != parts.front().suite) merged.suite += ", " + suite;
    const std::size_t first = merged.frames.size();
    const std::size_t first_run = merged.runs.size();
    // A shard's notes on masks and limits hold only for its own frames.
    const bool is_whole = part->shards == 1;
    for (; part != parts.end() && part->suite == suite; ++part) {
      if (is_whole) std::ranges::move(part->notes, std::back_inserter(merged.notes));
      for (JudgedFrame& judged : part->frames) {
        if (!names.insert(judged.frame.name).second) {
          return Error{ErrorKind::refused,
                       is_one_suite
                           ? fmt::format("two reports have a frame {}", judged.frame.name)
                           : fmt::format("two suites have a frame {}; a report needs unique "
                                         "names: rename one, or write two reports",
                                         judged.frame.name),
                       suite};
        }
        if (!is_one_suite) {
          judged.run_command = part->run_one_command;
          judged.approve_command = part->approve_one_command;
        }
        merged.frames.push_back(std::move(judged));
      }
      for (JudgedRun& run : part->runs) {
        if (!names.insert("run " + run.name).second) {
          return Error{ErrorKind::refused, fmt::format("two reports have a run {}", run.name),
                       suite};
        }
        merged.runs.push_back(std::move(run));
      }
    }
    std::ranges::stable_sort(merged.runs.begin() + static_cast<std::ptrdiff_t>(first_run),
                             merged.runs.end(), {}, &JudgedRun::place);
    std::ranges::stable_sort(merged.frames.begin() + static_cast<std::ptrdiff_t>(first),
                             merged.frames.end(), {},
                             [](const JudgedFrame& judged) { return judged.frame.place; });
    if (!is_whole) {
      std::ranges::move(suiteNotes(std::span(merged.frames).subspan(first)),
                        std::back_inserter(merged.notes));
    }
  }
  return merged;
}

}  // namespace rocinante
