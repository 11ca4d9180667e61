#include "golden/judge/housekeeping.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/plain_text.h"
#include "golden/approval/staging_folder.h"
#include "golden/suite/suite_neighbours.h"

namespace rocinante {
namespace {

constexpr double kLooseFactor = 4;

/// The largest figures of any frame judged by one tolerance.
struct Need {
  Tolerance tolerance;
  double tile_mean = 0;
  std::int64_t tile_over = 0;
};

void addLooseLimits(std::span<const JudgedFrame> judged, std::vector<std::string>& notes) {
  std::map<std::string, Need> needs;
  for (const JudgedFrame& one : judged) {
    if (one.verdict != FrameVerdict::same || one.tolerance.exact) continue;
    if (one.tolerance.limitsPixels()) continue;  // not chosen by the suite
    Need& need = needs[one.limit_from];
    need.tolerance = one.tolerance;
    need.tile_mean = std::max(need.tile_mean, one.comparison.worst_tile_mean);
    need.tile_over = std::max(need.tile_over, one.comparison.worst_tile_over);
  }
  for (const auto& [from, need] : needs) {
    const Tolerance& limits = need.tolerance;
    if (limits.tile_mean <= kLooseFactor * need.tile_mean ||
        static_cast<double>(limits.tile_over) <
            kLooseFactor * static_cast<double>(need.tile_over)) {
      continue;
    }
    notes.push_back(fmt::format(
        "tolerance {} ({}) is loose: tile_mean {:.2f}, needed at most {:.2f}; tile_over {}, "
        "needed at most {}",
        limits.name, from, limits.tile_mean, need.tile_mean, limits.tile_over, need.tile_over));
  }
}

void addIdleMasks(std::span<const JudgedFrame> judged, std::vector<std::string>& notes) {
  std::map<std::pair<std::string, std::string>, std::int64_t> hidden;  // by case and mask
  for (const JudgedFrame& one : judged) {
    const std::size_t own = std::min(one.masks.size(), one.own_masks);
    for (std::size_t i = 0; i < own; ++i) {
      hidden[{one.frame.case_name, one.masks[i].name}] += one.masks[i].pixels;
    }
  }
  for (const auto& [mask, pixels] : hidden) {
    if (pixels == 0) {
      notes.push_back(fmt::format("mask {} of case {} hides nothing", mask.second, mask.first));
    }
  }
}

void addCoverageNotes(std::span<const JudgedFrame> judged, std::vector<std::string>& notes) {
  const auto isJoint = [](const std::string& item) { return item.find('/') != item.npos; };
  std::size_t without = 0, without_joints = 0;
  std::set<std::string> masked;
  Account left_out;
  for (const JudgedFrame& one : judged) {
    if (!one.coverage) continue;
    for (LeftOut item : one.coverage->left_out.leftOut()) {
      item.count = 1;  // frames restate it
      const auto isKnown = [&](const LeftOut& known) {
        return known.name == item.name && known.reason == item.reason;
      };
      if (std::ranges::none_of(left_out.leftOut(), isKnown)) left_out.leaveOut(std::move(item));
    }
    if (!one.golden) continue;
    if (!one.golden->coverage) {
      if (!one.coverage->judged.empty()) ++without;
      continue;
    }
    without_joints += std::ranges::any_of(one.coverage->judged, isJoint) &&
                      std::ranges::none_of(*one.golden->coverage, isJoint);
    for (const std::string& device : *one.golden->coverage) {
      if (one.coverage->masked.contains(device)) masked.insert(device);
    }
  }
  const auto addUncovered = [&](std::size_t frames, const char* without_what, const char* what) {
    if (frames == 0) return;
    notes.push_back(fmt::format(
        "{} judged without {}: that a {} is no longer judged is not "
        "noticed until they are approved again",
        frames == 1 ? "1 frame is" : fmt::format("{} frames are", frames), without_what, what));
  };
  addUncovered(without, "coverage", "device");
  addUncovered(without_joints, "coverage of joints", "joint");
  for (const std::string& device : masked) {
    notes.push_back(fmt::format("all of {} is masked or hidden, which was judged when accepted",
                                plainText(device)));
  }
  if (!left_out.empty()) notes.push_back(accountSentence(left_out));
}

/// Each once, though all pictures of a cell lack it.
void addLackNotes(std::span<const JudgedFrame> judged, std::vector<std::string>& notes) {
  for (const JudgedFrame& one : judged) {
    for (const std::string& lack : one.lacks) {
      if (std::ranges::find(notes, lack) == notes.end()) notes.push_back(lack);
    }
  }
}

bool isLeftOver(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return (name.starts_with(".") && name.ends_with(".png.new")) || isManifestPart(file) ||
         isAbandonedStaging(file);
}

void addStrayFiles(const std::filesystem::path& folder, const std::set<std::string>& known,
                   std::vector<std::string>& faults) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (isLeftOver(entry.path())) {
      faults.push_back(
          fmt::format("{} was left by an interrupted approve; the next approve removes it",
                      plainText(entry.path().string())));
    } else if ((name.ends_with(".png") || name.ends_with(".mcap")) && !known.contains(name)) {
      faults.push_back(
          fmt::format("file {} is not a golden of the manifest", plainText(entry.path().string())));
    }
  }
}

void addRunFaults(const Manifest& manifest, const GoldenFolder& folder,
                  std::span<const SuiteRun> runs, std::span<const Suite> neighbours, bool verify,
                  std::vector<std::string>& faults) {
  std::error_code ignored;
  for (const auto& [name, logs] : manifest.runs) {
    const auto isNamed = [&, &run_name = name](const SuiteRun& run) {
      return run.name == run_name;
    };
    const bool is_run = std::ranges::any_of(runs, isNamed) ||
                        std::ranges::any_of(neighbours, [&](const Suite& other) {
                          return std::ranges::any_of(other.runs, isNamed);
                        });
    for (const AcceptedRun& accepted : logs) {
      const std::string file = folder.fileOf(accepted).string();
      if (!is_run) {
        faults.push_back(fmt::format("accepted log {} is stale: the suite has no run {}", file,
                                     plainText(name)));
      } else if (!std::filesystem::exists(file, ignored)) {
        faults.push_back(fmt::format("accepted log {} is missing", file));
      } else if (verify) {
        if (Status read = folder.verify(accepted); !read) faults.push_back(read.error().text());
      }
    }
  }
}

}  // namespace

std::vector<std::string> folderFaults(const Manifest& manifest, const GoldenFolder& folder,
                                      std::span<const SuiteFrame> frames, bool verify,
                                      std::span<const SuiteRun> runs,
                                      std::span<const Suite> neighbours) {
  std::set<std::string> names;
  for (const SuiteFrame& frame : frames) names.insert(frame.name);
  std::vector<std::string> faults;
  for (const auto& [name, pictures] : manifest.cases) {
    const bool is_frame = names.contains(name) ||
                          std::ranges::any_of(neighbours, [&, &frame = name](const Suite& other) {
                            return mayHaveFrame(other, frame);
                          });
    for (const AcceptedPicture& accepted : pictures) {
      const std::string file = folder.fileOf(accepted.picture, accepted.pixels).string();
      if (!is_frame) {
        faults.push_back(
            fmt::format("golden {} is stale: the suite has no frame {}", file, plainText(name)));
      } else if (!folder.has(accepted)) {
        faults.push_back(fmt::format("golden {} is missing", file));
      } else if (verify) {
        if (auto read = folder.read(accepted); !read.ok()) faults.push_back(read.error().text());
        if (accepted.areas.empty()) continue;
        if (auto read = folder.readAreas(accepted); !read.ok())
          faults.push_back(read.error().text());
      }
    }
  }
  addRunFaults(manifest, folder, runs, neighbours, verify, faults);
  std::set<std::string> known = manifest.files();
  known.merge(manifest.runFiles());
  addStrayFiles(folder.goldens(), known, faults);
  std::ranges::sort(faults);
  return faults;
}

std::vector<std::string> suiteNotes(std::span<const JudgedFrame> judged) {
  std::vector<std::string> notes;
  addIdleMasks(judged, notes);
  addLooseLimits(judged, notes);
  addCoverageNotes(judged, notes);
  addLackNotes(judged, notes);
  return notes;
}

}  // namespace rocinante
