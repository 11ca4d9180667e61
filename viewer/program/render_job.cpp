#include "viewer/program/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/session/log_pieces.h"
#include "viewer/backdrop/backdrop.h"
#include "viewer/bake/cell_cache.h"
#include "viewer/picture/picture_options.h"
#include "viewer/program/measured_files.h"
#include "viewer/program/render_files.h"
#include "viewer/program/render_run.h"
#include "viewer/view/missing_meshes.h"
#include "viewer/view/view_choice.h"

namespace rocinante {
namespace {

Error badJob(std::string what) { return Error{ErrorKind::bad_argument, std::move(what), {}}; }

Status checkMoments(const RenderJob& job) {
  const MomentChoice& chosen = job.moments;
  const bool any_at = !chosen.at.empty() || !chosen.at_file.empty();
  const bool any_event = chosen.all_events || !chosen.events.empty();
  const bool any_span = !chosen.from.empty() || !chosen.until.empty();
  const bool any = chosen.any() || any_span || !job.video.empty();
  if (job.log.empty() && any) return badJob("a time needs a log");
  if (!job.log.empty() && !job.joints.empty()) {
    return badJob("--joints poses a cell without a session");
  }
  if (job.log.empty()) return {};
  const int ways = (any_at ? 1 : 0) + (chosen.every.empty() ? 0 : 1) + (any_event ? 1 : 0);
  if (ways > 1) return badJob("only one of --at, --every and --events can be given");
  if (!chosen.rate.empty() && job.video.empty()) return badJob("--fps needs --video");
  if (ways == 0 && job.video.empty()) return badJob("a moment is required: --at T or --every D");
  if (any_span && any_at) return badJob("--from and --until need --every, --events or --fps");
  return {};
}

Status checkEndings(const RenderJob& job) {
  for (const auto* file : {&job.output, &job.sheet}) {
    if (file->empty()) continue;
    if (Status fit = mayEncodePicture(*file); !fit) return fit;
  }
  if (!job.frame_type.empty()) {
    if (job.frames.empty()) return badJob("--frame-type needs --frames");
    if (Status fit = mayEncodePicture("frame." + job.frame_type); !fit) {
      return Error{fit.error().kind, fit.error().what, "--frame-type " + job.frame_type};
    }
  }
  for (const auto* file : {&job.identity, &job.depth}) {
    if (file->empty() || isPngName(*file)) continue;
    if (!isExrName(*file)) {
      return Error{ErrorKind::bad_argument, "the picture's name must end with .png or .exr",
                   file->string()};
    }
    if (Status fit = mayEncodePicture(*file); !fit) return fit;
  }
  return {};
}

Status checkJob(const RenderJob& job) {
  if (!job.beside.empty() && job.log.empty()) return badJob("--beside needs a LOG");
  if (Status fit = checkMoments(job); !fit) return fit;
  if (Status fit = checkEndings(job); !fit) return fit;
  if (!job.video.empty() && !VideoFile::isVideo(job.video)) {
    return Error{ErrorKind::bad_argument,
                 "the video's name must end with .mp4, .mkv, .mov or .webm", job.video.string()};
  }
  return {};
}

/// Frames per second of the video, by docs/programs/render.md.
Result<FrameRate> videoRate(const MomentChoice& chosen) {
  if (!chosen.rate.empty()) return parseFrameRate(chosen.rate);
  if (chosen.every.empty()) return chosen.any() ? FrameRate{1, 1} : FrameRate{};
  const auto step = parseDuration(chosen.every);
  if (!step) return step.error();
  if (step->count() <= 0) return badJob("--every needs a duration greater than zero");
  const std::int64_t common = std::gcd(std::int64_t{1'000'000'000}, step->count());
  return FrameRate{1'000'000'000 / common, step->count() / common};
}

Result<std::vector<RenderMoment>> momentsOf(const RenderJob& job, Timeline* session,
                                            const FrameRate& rate, StateDamage& hiding) {
  if (session == nullptr) return std::vector<RenderMoment>{{"rest", {}, {}}};
  MomentChoice chosen = job.moments;
  chosen.rate.clear();
  // Without other moments, the video's frame rate selects them.
  if (!chosen.any()) chosen.rate = rate.text();
  return renderMoments(chosen, *session, hiding);
}

std::vector<std::string> warningsOf(const FrameMaker& maker, const RenderStyle& style) {
  std::vector<std::string> warnings;
  const bool has_collisions = !style.collision.empty() || !style.collision_over.empty();
  for (const Finding& fault : maker.cell().faults) {
    // Whoever asked for the collisions has seen it.
    if (has_collisions && fault.rule == "model.no-visual") continue;
    if (fault.severity != Severity::note) warnings.push_back(fault.print());
  }
  for (const std::string& warning : maker.warnings()) {
    warnings.push_back(maker.cell().shown(warning));
  }
  return warnings;
}

/// Reports the effect of the log's damage on the frames.
void warnOfDamage(const StateDamage& hiding, RenderReport& report) {
  if (!hiding.empty()) {
    report.warnings.insert(report.warnings.begin(), "an event may be missing: " + hiding.text());
  }
  StateDamage all;
  std::size_t count = 0;
  for (const RenderedFrame& frame : report.frames) {
    all.add(frame.damage);
    count += frame.damage.empty() ? 0 : 1;
  }
  if (count > 0) {
    report.warnings.insert(
        report.warnings.begin(),
        fmt::format("{}; {} of {} may show an older state ({})", all.what(), count,
                    countText(report.frames.size(), "frame"), all.where()));
  }
  if (!hiding.empty() || count > 0) report.is_whole = false;
}

Status showBeside(const RenderJob& job, FrameMaker& maker, StateDamage& hiding) {
  if (job.beside.empty()) return {};
  auto beside = Timeline::open(job.beside);
  if (!beside) return beside.error();
  auto alignment = alignBeside(job.align, *maker.session(), *beside, hiding);
  if (!alignment) return alignment.error();
  maker.showBeside(std::move(*beside), std::move(*alignment));
  return {};
}

/// Pictures are from the backdrop's camera unless the job names others, one of which must be it.
Status openBackdrop(const RenderJob& job, const FrameRequest& look, const Cell& cell,
                    const Timeline* session, std::vector<std::string>& cameras,
                    std::shared_ptr<Backdrop>& opened) {
  if (job.backdrop.file.empty()) return {};
  auto backdrop =
      Backdrop::open(job.backdrop, cell, session != nullptr ? session->origin() : LogTime{},
                     session != nullptr ? session->end() : LogTime{});
  if (!backdrop) return backdrop.error();
  const std::string& camera = backdrop->camera();
  if (job.cameras.empty()) cameras = {camera};
  const std::vector<CellInset>& insets = look.insets ? *look.insets : cell.insets;
  if (std::ranges::find(cameras, camera) == cameras.end() &&
      std::ranges::find(insets, camera, &CellInset::camera) == insets.end()) {
    return badJob("no picture is from `" + camera + "`, the backdrop's camera: add --camera " +
                  shellWord(camera));
  }
  opened = std::make_shared<Backdrop>(std::move(*backdrop));
  return {};
}

void showBackdrop(const std::shared_ptr<Backdrop>& backdrop, double opacity, FrameMaker& maker) {
  if (backdrop == nullptr) return;
  const LogTime origin = maker.session() != nullptr ? maker.session()->origin() : LogTime{};
  maker.showBackdrop(
      backdrop->camera(), opacity,
      [backdrop, origin](LogTime time) -> Result<std::shared_ptr<const BackdropPicture>> {
        const auto number = backdrop->numberAt(time - origin);
        if (!number) return std::shared_ptr<const BackdropPicture>();
        return backdrop->picture(*number, {});
      });
}

Status makeFolders(const RenderFiles& files) {
  if (files.frames.empty()) return {};
  for (std::size_t camera = 0; camera < files.cameras.size(); ++camera) {
    std::error_code fault;
    const std::filesystem::path folder = files.frame(0, camera).parent_path();
    std::filesystem::create_directories(folder, fault);
    if (fault) return Error{ErrorKind::refused, fault.message(), folder.string()};
  }
  return {};
}

}  // namespace

Result<RenderReport> render(const RenderJob& given,
                            const std::function<bool(std::size_t, std::size_t)>& progress) {
  RenderJob job = given;
  if (job.log.empty() && isLog(job.cell)) job.log = job.cell;
  if (Status fit = checkJob(job); !fit) return fit.error();
  const auto rate = videoRate(job.moments);
  if (!rate) return rate.error();
  FrameRequest look = job.look;
  std::optional<Timeline> session;
  if (!job.log.empty()) {
    auto opened = Timeline::open(job.log);
    if (!opened) return opened.error();
    session = std::move(*opened);
  }
  RenderReport report;
  StateDamage hiding;
  auto moments = momentsOf(job, session ? &*session : nullptr, *rate, hiding);
  if (!moments) return moments.error();
  if (!job.output.empty() && moments->size() > 1) {
    return badJob("-o takes one frame; use --sheet FILE or --frames DIR for several");
  }
  RenderFiles files{job.output, job.sheet,  job.video,   job.identity,
                    job.depth,  job.frames, job.cameras, std::move(*moments)};
  if (!job.frame_type.empty()) files.frame_type = job.frame_type;
  if (files.cameras.empty()) files.cameras.emplace_back();
  if (Status free = files.check(job.overwrite); !free) return free.error();

  CellOptions options;
  static_cast<ModelSearch&>(options) = job;
  options.parallel = job.parallel;
  options.progress = job.load_progress;
  auto cell = CellCache::ofUser().load(job.cell, options);
  if (!cell) return cell.error();
  std::shared_ptr<Backdrop> backdrop;
  if (Status opened =
          openBackdrop(job, look, *cell, session ? &*session : nullptr, files.cameras, backdrop);
      !opened) {
    return opened.error();
  }
  if (!job.layers.empty()) chooseLayers(job.layers, look.hide, look.show);
  for (const std::string& text : job.joints) {
    if (Status set = setJoints(look.joints, *cell, text); !set) {
      return Error{set.error().kind, set.error().what, "--joints " + text};
    }
  }
  if (session) {
    report.account = logAccount(*session, &*cell);
    report.goes_on = NextPiece::missing(session->log());
  }
  auto maker = FrameMaker::open(std::move(*cell), std::move(session), job.profile);
  if (!maker) return maker.error();
  if (Status shown = showBeside(job, *maker, hiding); !shown) return shown.error();
  showBackdrop(backdrop, job.backdrop.opacity, *maker);
  if (Status made = makeFolders(files); !made) return made.error();

  report.key = maker->key();
  report.inputs = maker->inputsHash();
  report.warnings = warningsOf(*maker, job.look.style);
  if (std::string incomplete = incompleteText(maker->cell()); !incomplete.empty()) {
    report.warnings.insert(report.warnings.begin(), std::move(incomplete));
    report.is_whole = false;
  }
  std::vector<std::size_t> by_time(files.moments.size());
  std::iota(by_time.begin(), by_time.end(), std::size_t{0});
  std::stable_sort(by_time.begin(), by_time.end(), [&](std::size_t a, std::size_t b) {
    return files.moments[a].time < files.moments[b].time;
  });
  const std::size_t of = by_time.size() * files.cameras.size();
  for (std::size_t i = 0; i < files.cameras.size() && !job.video.empty(); ++i) {
    report.videos.push_back(files.ofCamera(job.video, i));
  }
  const std::size_t cameras = files.cameras.size();
  RenderRun run(job, look, std::move(files), *maker);
  if (Status begun = run.begin(*rate); !begun) return begun.error();
  std::size_t done = 0;
  for (const std::size_t moment : by_time) {
    for (std::size_t camera = 0; camera < cameras; ++camera) {
      if (Status drawn = run.draw(moment, camera); !drawn) return drawn.error();
      if (!progress(++done, of)) {
        return Error{
            ErrorKind::refused, fmt::format("stopped after {} of {} frames", done, of), {}};
      }
    }
  }
  if (Status finished = run.finish(); !finished) return finished.error();
  report.frames = run.takeFrames();
  warnOfDamage(hiding, report);
  return report;
}

}  // namespace rocinante
