#include "golden/why/run_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "viewer/render/frame_maker.h"

namespace rocinante {
namespace {

/// Of what is covered: who covers less than this stays.
constexpr double kLeastPart = 0.02;

bool isDevice(const IdentityFrame& frame, std::uint32_t id, const std::string& device) {
  return id != 0 && frame.names[id - 1].device == device;
}

constexpr int kWidth = 640, kHeight = 400;
/// Findings of one device that are closer together show the same.
constexpr Nanoseconds kOneMoment = std::chrono::seconds(1);

/// What to draw, without the pixels.
std::vector<RunPicture> chosenPictures(const Cell& cell, const RunJudgement& judgement) {
  std::vector<RunPicture> chosen;
  for (const RunFinding& finding : judgement.findings) {
    const bool moves = finding.kind == RunFinding::Kind::joint ||
                       finding.kind == RunFinding::Kind::pose ||
                       finding.kind == RunFinding::Kind::signal;
    if (!moves || !finding.largest) continue;
    RunPicture picture;
    picture.device = deviceOfItem(finding.item);
    // A signal may be of none.
    if (cell.findDevice(picture.device) == nullptr) continue;
    picture.at_run = finding.at_run;
    picture.at_accepted = finding.at_accepted;
    const bool is_shown = std::ranges::any_of(chosen, [&](const RunPicture& other) {
      const Nanoseconds apart = other.at_run - picture.at_run;
      return other.device == picture.device && std::chrono::abs(apart) < kOneMoment;
    });
    if (!is_shown) chosen.push_back(std::move(picture));
    if (chosen.size() == kMaxRunPictures) break;
  }
  return chosen;
}

LogTime within(const Timeline& session, LogTime time) {
  return std::clamp(time, session.start(), session.end());
}

Status drawInto(const Cell& cell, const std::filesystem::path& log,
                const std::filesystem::path& accepted, std::vector<RunPicture>& pictures) {
  auto shown = Timeline::open(log);
  if (!shown.ok()) return shown.error();
  auto maker = FrameMaker::open(cell, std::move(*shown), Profile::reproducible);
  if (!maker.ok()) return maker.error();
  for (RunPicture& picture : pictures) {
    auto beside = Timeline::open(accepted);
    if (!beside.ok()) return beside.error();
    FrameRequest request;
    request.time = within(*maker->session(), maker->session()->origin() + picture.at_run);
    request.camera = "fit:" + picture.device;
    request.width = kWidth;
    request.height = kHeight;
    request.insets.emplace();
    // The judge has matched these two moments already.
    EventAlignment alignment;
    alignment.anchor_a = request.time;
    alignment.anchor_b = within(*beside, beside->origin() + picture.at_accepted);
    maker->showBeside(std::move(*beside), std::move(alignment));
    auto in_front = devicesInFront(*maker, request, picture.device);
    if (!in_front.ok()) return in_front.error();
    request.hide = picture.left_out = std::move(*in_front);
    auto drawn = maker->frame(request);
    if (!drawn.ok()) return drawn.error();
    picture.picture = std::move(*drawn);
  }
  return {};
}

}  // namespace

Result<std::vector<std::string>> devicesInFront(FrameMaker& maker, const FrameRequest& request,
                                                const std::string& device) {
  const auto whole = maker.identity(request);
  if (!whole.ok()) return whole.error();
  std::set<std::string> others;
  for (const IdentityName& name : whole->names) {
    if (name.device != device && name.device != "drawing") others.insert(name.device);
  }
  if (others.empty()) return std::vector<std::string>{};
  FrameRequest without = request;
  without.hide.insert(without.hide.end(), others.begin(), others.end());
  const auto alone = maker.identity(without);
  if (!alone.ok()) return alone.error();
  std::size_t pixels = 0, covered = 0;
  std::vector<std::size_t> covered_by(whole->names.size());
  for (std::size_t i = 0; i < alone->ids.size(); ++i) {
    if (!isDevice(*alone, alone->ids[i], device)) continue;
    ++pixels;
    const std::uint32_t owner = whole->ids[i];
    if (owner == 0 || isDevice(*whole, owner, device)) continue;
    ++covered;
    ++covered_by[owner - 1];
  }
  if (2 * covered <= pixels) return std::vector<std::string>{};
  std::map<std::string, std::size_t> by_device;
  for (std::size_t i = 0; i < covered_by.size(); ++i) {
    by_device[whole->names[i].device] += covered_by[i];
  }
  std::vector<std::string> in_front;
  for (const auto& [name, count] : by_device) {
    const bool much = static_cast<double>(count) >= kLeastPart * static_cast<double>(covered);
    if (much && others.contains(name)) in_front.push_back(name);
  }
  return in_front;
}

std::string runPictureFile(const JudgedRun& run, std::size_t index) {
  return fmt::format("{}.run-{}.png", run.name, index + 1);
}

void drawRunPictures(const Cell& cell, const std::filesystem::path& log,
                     const std::filesystem::path& accepted, JudgedRun& run) {
  if (run.verdict != FrameVerdict::different) return;
  std::vector<RunPicture> pictures = chosenPictures(cell, run.judgement);
  if (pictures.empty()) return;
  if (Status drawn = drawInto(cell, log, accepted, pictures); !drawn) {
    run.judgement.notes.push_back("no pictures: " + drawn.error().text());
    return;
  }
  run.pictures = std::move(pictures);
}

void drawRunPictures(const SuiteSession& session, JudgedRun& run) {
  const auto wanted = std::ranges::find(session.runs(), run.name, &SuiteRun::name);
  const auto& accepted = session.manifest().runsOf(run.name);
  if (wanted == session.runs().end() || accepted.empty()) return;
  if (const OpenedRecording* const log = session.logOf(**wanted)) {
    drawRunPictures(session.cell(), log->log, session.folder().fileOf(accepted.front()), run);
  }
}

}  // namespace rocinante
