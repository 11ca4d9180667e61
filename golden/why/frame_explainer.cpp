#include "golden/why/frame_explainer.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_folder.h"
#include "core/cell/posed_scene.h"
#include "core/log/log_reader.h"
#include "golden/compare/pixel_difference.h"
#include "golden/judge/frame_coverage.h"
#include "golden/why/golden_texts.h"
#include "golden/why/model_change.h"

namespace rocinante {
namespace {

/// `frame` with the golden's pixels where another renderer only rounded differently: those pixels
/// are spread over the picture and would outweigh the change. Unchanged when nothing else differs.
Picture withoutRounding(const Picture& frame, const Picture& golden, int level) {
  Picture kept = frame;
  for (std::size_t i = 0; i < kept.rgba.size(); i += 4) {
    if (pixelDifference(&frame.rgba[i], &golden.rgba[i]) > level) continue;
    std::copy_n(&golden.rgba[i], 4, &kept.rgba[i]);
  }
  return kept == golden ? frame : kept;
}

}  // namespace

Result<CellBundle> collectSessionCell(const SuiteSession& session, const SuiteOptions& options) {
  CellOptions cell_options;
  if (!isLog(session.suite().cell)) static_cast<ModelSearch&>(cell_options) = options;
  return collectCellOrLog(session.suite().cell, cell_options, BundleRoots::all);
}

FrameExplainer::FrameExplainer(SuiteSession& session, std::filesystem::path suite_file,
                               SuiteOptions options)
    : now_(session), suite_file_(std::move(suite_file)), options_(std::move(options)) {
  options_.selection = {};
}

void FrameExplainer::findCandidates() {
  looked_ = true;
  if (options_.cell || options_.log || !options_.logs.empty()) {
    Candidate own;
    own.options = options_;
    own.options.cell.reset();
    own.options.log.reset();
    own.options.logs.clear();
    candidates_.push_back(std::move(own));
  }
  const auto suite = readSuite(suite_file_);
  if (!suite.ok() || !suite->log || suite->cell.empty()) return;
  const auto reader = LogReader::open(*suite->log);
  if (!reader.ok()) return;
  const auto carried = readAttachedCell(*reader);
  if (!carried.ok() || !*carried) return;
  Candidate attached;
  attached.options = options_;
  attached.options.log.reset();
  attached.options.logs.clear();
  attached.options.cell = *suite->log;
  // An attached cell is complete: search roots do not apply.
  static_cast<ModelSearch&>(attached.options) = {};
  candidates_.push_back(std::move(attached));
}

SuiteSession* FrameExplainer::opened(Candidate& candidate) {
  if (!candidate.session && !candidate.is_unusable) {
    auto session = SuiteSession::open(suite_file_, candidate.options);
    if (session.ok()) candidate.session = std::make_unique<SuiteSession>(std::move(*session));
    candidate.is_unusable = !candidate.session;
    if (candidate.session) {
      auto bundle = collectSessionCell(*candidate.session, candidate.options);
      if (bundle.ok()) candidate.bundle = std::move(*bundle);
    }
  }
  return candidate.session.get();
}

Result<FrameExplainer::Found> FrameExplainer::findGolden(const JudgedFrame& judged) {
  if (!looked_) findCandidates();
  Found best;
  for (Candidate& candidate : candidates_) {
    SuiteSession* session = opened(candidate);
    if (session == nullptr) continue;
    const auto& frames = session->allFrames();
    const auto frame = std::ranges::find(frames, judged.frame.name, &SuiteFrame::name);
    if (frame == frames.end() || !frame->time) continue;
    const auto drawer = session->drawer();
    if (!drawer.ok()) return drawer.error();
    const FrameRequest request = session->request(*frame);
    const auto drawn = (*drawer)->frame(request);
    if (drawn.ok() && pictureXxh3(*drawn) == judged.golden->pixels) {
      return Found{*drawer, &candidate, request, GoldenBasis::redrawn};
    }
    const bool is_its = session->sessionHash() == judged.golden->session &&
                        (*drawer)->inputsHash() == judged.golden->inputs &&
                        hasFilesOf(candidate, *judged.golden);
    if (drawn.ok() && is_its && best.drawer == nullptr) {
      best = {*drawer, &candidate, request, GoldenBasis::inputs};
    }
  }
  if (best.drawer != nullptr) return best;
  return findRebuilt(judged);
}

bool FrameExplainer::hasFilesOf(const Candidate& candidate, const AcceptedPicture& golden) const {
  const FileHashes* const before = now_.manifest().cellOf(golden);
  if (before == nullptr || !candidate.bundle) return true;
  // By content: an attached cell may have other folders.
  const auto contentsOf = [](const FileHashes& files) {
    std::multiset<std::string> contents;
    for (const auto& [name, hash] : files) contents.insert(hash);
    return contents;
  };
  return contentsOf(*before) == contentsOf(hashesOf(*candidate.bundle));
}

FrameExplainer::Rebuilt* FrameExplainer::rebuilt(const AcceptedPicture& golden) {
  const auto [place, is_new] = rebuilt_.try_emplace(golden.cell);
  Rebuilt& its = place->second;
  const FileHashes* const before = now_.manifest().cellOf(golden);
  if (is_new && before != nullptr && bundleToday() != nullptr) {
    const GoldenTexts put_back(*bundleToday(), *before, now_.manifest().texts);
    if (put_back.any() && put_back.unknown() == 0) {
      CellOptions options;
      options.parallel = options_.parallel;
      auto cell = loadBundle(*bundleToday(), "", options);
      if (cell.ok()) its.cell = std::move(*cell);
    }
  }
  return its.cell ? &its : nullptr;
}

Result<FrameExplainer::Found> FrameExplainer::findRebuilt(const JudgedFrame& judged) {
  Rebuilt* const its = options_.drawers ? nullptr : rebuilt(*judged.golden);
  if (its == nullptr) return Found{};
  std::vector<const SuiteSession*> sessions = {&now_};
  for (const Candidate& candidate : candidates_) {
    if (candidate.session) sessions.push_back(candidate.session.get());
  }
  for (const SuiteSession* session : sessions) {
    if (session->sessionHash() != judged.golden->session) continue;
    const auto& frames = session->allFrames();
    const auto frame = std::ranges::find(frames, judged.frame.name, &SuiteFrame::name);
    if (frame == frames.end() || !frame->time) continue;
    const std::optional<std::filesystem::path> log =
        session->log() == nullptr ? std::nullopt : std::optional(session->log()->log);
    std::unique_ptr<FrameDrawer>& drawer = its->drawers[log.value_or("").string()];
    if (!drawer) {
      auto made = sceneDrawers(*its->cell, log)();
      if (!made.ok()) return made.error();
      drawer = std::move(*made);
    }
    const FrameRequest request = session->request(*frame);
    const auto drawn = drawer->frame(request);
    if (!drawn.ok()) continue;
    const bool is_redrawn = pictureXxh3(*drawn) == judged.golden->pixels;
    if (!is_redrawn && drawer->inputsHash() != judged.golden->inputs) continue;
    return Found{drawer.get(), nullptr, request,
                 is_redrawn ? GoldenBasis::redrawn : GoldenBasis::inputs};
  }
  return Found{};
}

/// The golden may show today's cell and session by another of its cameras, which the suite named.
Result<FrameExplainer::Found> FrameExplainer::findByCamera(const JudgedFrame& judged) {
  constexpr std::size_t kMostInVain = 3;  // frames: each is drawn once more for each camera
  if (judged.golden->session != judged.session || in_vain_ == kMostInVain) return Found{};
  const auto drawer = now_.drawer();
  if (!drawer.ok()) return drawer.error();
  FrameRequest request = now_.request(judged.frame);
  const std::string today = cameraName({**drawer, request});
  for (const CellCamera& camera : (*drawer)->cell().cameras) {
    if (camera.name == today) continue;
    request.camera = camera.name;
    const auto drawn = (*drawer)->frame(request);
    if (drawn.ok() && pictureXxh3(*drawn) == judged.golden->pixels) {
      return Found{*drawer, nullptr, request, GoldenBasis::redrawn};
    }
  }
  ++in_vain_;
  return Found{};
}

CellBundle* FrameExplainer::bundleToday() {
  // Only once: meshes are large, and many frames may fail.
  if (!collected_) {
    collected_ = true;
    auto bundle = collectSessionCell(now_, options_);
    if (bundle.ok()) bundle_today_ = std::move(*bundle);
  }
  return bundle_today_ ? &*bundle_today_ : nullptr;
}

const ModelChanges& FrameExplainer::changesSince(Candidate& candidate) {
  if (!candidate.changes) {
    candidate.changes = modelChanges(candidate.session->cell(), now_.cell());
    if (candidate.bundle && bundleToday() != nullptr) {
      FileTexts texts = recordedTexts(*candidate.bundle);
      texts.merge(recordedTexts(*bundleToday()));
      for (ModelChange& change :
           changedFiles(hashesOf(*candidate.bundle), hashesOf(*bundleToday()), texts)) {
        candidate.changes->push_back(std::move(change));
      }
    }
  }
  return *candidate.changes;
}

const ModelChanges& FrameExplainer::changesSince(const AcceptedPicture& golden) {
  const auto [place, is_new] = changes_.try_emplace(golden.cell);
  if (!is_new) return place->second;
  place->second = cellFaults(now_.cell());
  const FileHashes* const before = now_.manifest().cellOf(golden);
  if (before != nullptr && bundleToday() != nullptr) {
    FileContents at_hand;
    for (const Candidate& candidate : candidates_) {
      if (candidate.bundle) at_hand.merge(contentsOf(*candidate.bundle));
    }
    place->second =
        modelChanges(*before, now_.manifest().texts, *bundleToday(), now_.cell(), at_hand);
  }
  return place->second;
}

namespace {

/// The cameras that a frame is seen by.
std::vector<std::string> camerasOf(const DrawableSide& side) {
  std::vector<std::string> cameras{cameraName(side)};
  for (const CellInset& inset : side.drawer.cell().insets) cameras.push_back(inset.camera);
  return cameras;
}

/// Devices that the golden covers and the frame does not show, and why one that it shows is not
/// judged.
std::vector<std::string> goneSentences(const JudgedFrame& judged, const Cell& cell,
                                       const SessionState& state) {
  std::vector<std::string> gone;
  if (!judged.coverage || !judged.golden->coverage) return gone;
  const PosedScene scene = poseScene(cell, state);
  const std::set<std::string>& lost = judged.coverage->lost;
  for (const std::string& item : lost) {
    const bool is_device = item.find('/') == std::string::npos;
    if (is_device && scene.findDevice(item) == nullptr) {
      gone.push_back(fmt::format("device {} is gone from this frame", item));
    }
  }
  if (gone.empty() && !lost.empty()) gone.push_back(lostSentence(*judged.coverage));
  SuiteCase unmasked = *judged.frame.suite_case;
  unmasked.mask.clear();
  unmasked.judge_only.clear();
  const RunCoverage now = frameCoverage(unmasked, cell, state, LogTime{});
  for (const std::string& item : *judged.golden->coverage) {
    if (!now.masked.contains(item)) continue;
    gone.push_back(fmt::format("device {} is gone from this frame: the suite hides it", item));
  }
  return gone;
}

}  // namespace

Result<std::shared_ptr<const FrameWhy>> FrameExplainer::explain(const JudgedFrame& judged) {
  std::shared_ptr<const FrameWhy> nothing;
  if (!judged.drawn || !judged.accepted || !judged.golden || !judged.frame.time) return nothing;
  if (judged.drawn->width != judged.accepted->width ||
      judged.drawn->height != judged.accepted->height || judged.compared() == *judged.accepted) {
    return nothing;
  }
  const auto drawer = now_.drawer();
  if (!drawer.ok()) return drawer.error();
  const Picture compared =
      judged.tolerance.limitsPixels()
          ? withoutRounding(judged.compared(), *judged.accepted, judged.tolerance.level)
          : judged.compared();
  const DrawableSide today{**drawer, now_.request(judged.frame)};
  auto golden = findGolden(judged);
  if (golden.ok() && golden->drawer == nullptr) golden = findByCamera(judged);
  if (!golden.ok()) return golden.error();
  auto why =
      golden->drawer == nullptr
          ? explainByGuess(*judged.accepted, compared, today)
          : explainBoth(*judged.accepted, {*golden->drawer, golden->request}, compared, today);
  if (!why.ok()) return why.error();
  why->basis = golden->basis;
  Candidate* candidate = nullptr;
  for (Candidate& one : candidates_) {
    if (&one == golden->candidate && hasFilesOf(one, *judged.golden)) candidate = &one;
  }
  const ModelChanges& changes =
      candidate != nullptr ? changesSince(*candidate) : changesSince(*judged.golden);
  why->files = textsOf(changes);
  if (golden->drawer == *drawer) {
    const std::string camera = cameraName(today);
    std::string text = fmt::format("camera {} in place of {}", camera, golden->request.camera);
    why->state.insert(why->state.begin(), {"camera " + camera, std::move(text), {}, false, {}});
  }
  const auto state = (*drawer)->state(today.request);
  if (!state.ok()) return state.error();
  findCauses(changes, camerasOf(today), goneSentences(judged, (*drawer)->cell(), *state), *why);
  return std::make_shared<const FrameWhy>(std::move(*why));
}

Status explainFailures(FrameExplainer& explainer, std::vector<JudgedFrame>& frames,
                       std::size_t most) {
  for (JudgedFrame& judged : frames) {
    if (isFine(judged.verdict) || judged.verdict == FrameVerdict::missing) continue;
    auto why = explainer.explain(judged);
    if (!why.ok()) return why.error();
    judged.why = std::move(*why);
    if (judged.why && --most == 0) break;
  }
  return {};
}

}  // namespace rocinante
