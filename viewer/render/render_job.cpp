#include "viewer/render/render_job.h"

#include <fmt/format.h>

#include <charconv>

#include "core/atomic_file.h"
#include "core/bundle/attached_cell.h"
#include "core/duration_text.h"
#include "viewer/render/contact_sheet.h"

namespace rocinante {
namespace {

/// Beyond this, --every is surely a slip of the hand.
constexpr std::int64_t kMaxFrames = 1'000'000;

Error badJob(std::string what) { return Error{ErrorKind::bad_argument, std::move(what), {}}; }

struct Moment {
  std::string text;
  LogTime time{};
};

Status checkJob(const RenderJob& job) {
  const bool any_time = !job.at.empty() || !job.every.empty();
  if (job.log.empty() && any_time) return badJob("a time means nothing without a log");
  if (!job.log.empty() && !any_time) return badJob("which moment? (--at T, or --every D)");
  if (!job.at.empty() && !job.every.empty()) return badJob("--at and --every exclude each other");
  if (!job.output.empty() && (job.at.size() > 1 || !job.every.empty())) {
    return badJob("-o holds one frame; for several there are --sheet FILE and --frames DIR");
  }
  for (const auto* file : {&job.output, &job.sheet}) {
    if (!file->empty() && file->extension() != ".png" && file->extension() != ".PNG") {
      return Error{ErrorKind::bad_argument, "pictures are written as .png", file->string()};
    }
  }
  return {};
}

Result<std::vector<Moment>> momentsOf(const RenderJob& job, const Timeline* session) {
  if (session == nullptr) return std::vector<Moment>{{"rest", {}}};
  std::vector<Moment> moments;
  for (const std::string& text : job.at) {
    const auto time = parseSessionTime(text, session->origin(), session->end());
    if (!time) return time.error();
    moments.push_back({text, *time});
  }
  if (!job.every.empty()) {
    const auto step = parseDuration(job.every);
    if (!step) return step.error();
    if (step->count() <= 0) return badJob("--every needs a duration above zero");
    const Nanoseconds span = session->end() - session->start();
    if (span / *step >= kMaxFrames) {
      return badJob(fmt::format("--every {} asks for more than {} frames", job.every, kMaxFrames));
    }
    // From the origin, not from the start, so that cutting a log does not shift the moments.
    const Nanoseconds before = session->start() - session->origin();
    const std::int64_t first =
        before.count() <= 0 ? 0 : (before.count() + step->count() - 1) / step->count();
    for (std::int64_t i = first; session->origin() + *step * i <= session->end(); ++i) {
      moments.push_back({secondsText(*step * i, 3), session->origin() + *step * i});
    }
  }
  for (const Moment& moment : moments) {
    if (moment.time < session->start() || moment.time > session->end()) {
      const auto shown = [&](LogTime time) { return secondsText(time - session->origin(), 3); };
      return Error{ErrorKind::bad_argument,
                   fmt::format("{} is outside the log, which has {} to {} s", moment.text,
                               shown(session->start()), shown(session->end())),
                   job.log.string()};
    }
  }
  if (moments.empty()) return badJob("no moment lies in the log");
  return moments;
}

std::filesystem::path frameFile(const RenderJob& job, std::size_t number) {
  return job.frames / fmt::format("frame-{:05}.png", number + 1);
}

/// The files to come: none may be there already.
Status checkOutputs(const RenderJob& job, std::size_t count) {
  std::vector<std::filesystem::path> files;
  if (!job.output.empty()) files.push_back(job.output);
  if (!job.sheet.empty()) files.push_back(job.sheet);
  if (!job.frames.empty()) {
    for (std::size_t i = 0; i < count; ++i) files.push_back(frameFile(job, i));
  }
  std::error_code ignored;
  for (const auto& file : files) {
    if (!job.overwrite && std::filesystem::exists(file, ignored)) {
      return Error{ErrorKind::refused, "the file exists; --force replaces it", file.string()};
    }
  }
  return {};
}

Status writePicture(const std::filesystem::path& file, const Picture& picture, bool overwrite) {
  return writeFileWhole(file, encodePng(picture), overwrite);
}

std::vector<std::string> warningsOf(const FrameMaker& maker) {
  std::vector<std::string> warnings;
  for (const ModelFault& fault : maker.cell().faults) {
    if (fault.severity != Severity::note) warnings.push_back(fault.print());
  }
  for (const std::string& warning : maker.warnings()) {
    warnings.push_back(maker.cell().shown(warning));
  }
  return warnings;
}

}  // namespace

Result<std::pair<int, int>> parseSize(const std::string& text) {
  const auto side = [](std::string_view digits) {
    int value = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = fault == std::errc() && end == digits.data() + digits.size();
    return whole && value >= 1 && value <= 16384 ? value : 0;
  };
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const int width = side(std::string_view(text).substr(0, cross));
    const int height = side(std::string_view(text).substr(cross + 1));
    if (width > 0 && height > 0) return std::pair(width, height);
  }
  return badJob("`" + text + "` is no size: WIDTHxHEIGHT in pixels, as 640x480");
}

Result<RenderReport> render(const RenderJob& given,
                            const std::function<bool(std::size_t, std::size_t)>& progress) {
  RenderJob job = given;
  if (job.log.empty() && isLog(job.cell)) job.log = job.cell;
  if (Status fit = checkJob(job); !fit) return fit.error();
  std::optional<Timeline> session;
  if (!job.log.empty()) {
    auto opened = Timeline::open(job.log);
    if (!opened) return opened.error();
    session = std::move(*opened);
  }
  const auto moments = momentsOf(job, session ? &*session : nullptr);
  if (!moments) return moments.error();
  if (Status free = checkOutputs(job, moments->size()); !free) return free.error();

  CellOptions options;
  options.search = job.search;
  options.search_environment = job.search_environment;
  auto cell = loadCellOrLog(job.cell, options);
  if (!cell) return cell.error();
  auto maker = FrameMaker::open(std::move(*cell), std::move(session), job.profile);
  if (!maker) return maker.error();
  if (!job.frames.empty()) {
    std::error_code fault;
    std::filesystem::create_directories(job.frames, fault);
    if (fault) return Error{ErrorKind::refused, fault.message(), job.frames.string()};
  }

  RenderReport report;
  report.key = maker->key();
  report.inputs = maker->inputsHash();
  report.warnings = warningsOf(*maker);
  std::vector<SheetFrame> sheet;
  for (std::size_t i = 0; i < moments->size(); ++i) {
    const Moment& moment = (*moments)[i];
    FrameRequest request = job.look;
    request.time = moment.time;
    auto picture = maker->frame(request);
    if (!picture) return picture.error();
    RenderedFrame frame{moment.text, moment.time, pictureSha256(*picture), {}};
    if (!job.frames.empty()) frame.file = frameFile(job, i);
    if (!job.output.empty()) frame.file = job.output;
    if (!frame.file.empty()) {
      Status written = writePicture(frame.file, *picture, job.overwrite);
      if (!written) return written.error();
    }
    if (!job.sheet.empty()) {
      const bool bare_number = moment.text.find_first_not_of("0123456789.-") == std::string::npos;
      sheet.push_back({std::move(*picture), moment.text + (bare_number ? " s" : "")});
    }
    report.frames.push_back(std::move(frame));
    if (!progress(i + 1, moments->size())) {
      return Error{ErrorKind::refused,
                   fmt::format("stopped after {} of {} frames", i + 1, moments->size()),
                   {}};
    }
  }
  if (!job.sheet.empty()) {
    const auto picture = contactSheet(sheet, TextAtlas(18));
    if (!picture) return picture.error();
    Status written = writePicture(job.sheet, *picture, job.overwrite);
    if (!written) return written.error();
  }
  return report;
}

}  // namespace rocinante
