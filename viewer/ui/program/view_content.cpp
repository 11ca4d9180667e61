#include "viewer/ui/program/view_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/bundle/attached_cell.h"
#include "core/cell/bare_cell.h"
#include "core/check/log_account.h"
#include "core/cli/load_progress.h"
#include "core/cli/program.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/live/received_decoder.h"
#include "core/foreign/recordings/opened_recording.h"
#include "core/report/account.h"
#include "core/session/moment_name.h"
#include "core/signing/trust_judge.h"
#include "viewer/bake/cell_cache.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

Result<std::optional<LiveFeed>> openFeed(const ContentRequest& request, const Cell& cell,
                                         std::vector<std::string>& warnings) {
  if (!request.live) return std::optional<LiveFeed>();
  auto trust = TrustJudge::open(request.trust);
  if (!trust.ok()) return trust.error();
  auto decoders = decodersFor(request.decoders, cell);
  if (!decoders.ok()) return decoders.error();
  auto feed = LiveFeed::start(*request.live, std::move(*trust), request.keep, std::move(*decoders));
  if (!feed.ok()) return feed.error();
  if (!feed->keepingFault().empty()) {
    warnings.push_back("this session is not kept, so its past cannot be shown: " +
                       feed->keepingFault());
  }
  return std::optional<LiveFeed>(std::move(*feed));
}

bool hasGeometry(const Model& model) {
  return std::ranges::any_of(model.links, [](const Link& link) {
    const auto has_mesh = [](const Visual& visual) { return visual.mesh != nullptr; };
    return std::ranges::any_of(link.visuals, has_mesh) ||
           std::ranges::any_of(link.collisions, has_mesh);
  });
}

/// The log, which is made of a recording of another program first. Names its joints by the cell.
Result<OpenedRecording> openRecordingOf(const ContentRequest& request, const fs::path& recording,
                                        const fs::path& cell, const TellLoadProgress& progress,
                                        const std::stop_token& stop) {
  constexpr std::uint64_t kWhole = 1'000'000;
  RecordingRequest wanted;
  wanted.recording = recording;
  wanted.cell = cell;
  wanted.search = request.where;
  wanted.progress = [&](double part) -> Status {
    if (cli::stopRequested() || stop.stop_requested()) {
      return Error{ErrorKind::refused, "stopped while importing", {}};
    }
    const auto done = static_cast<std::uint64_t>(part * static_cast<double>(kWhole));
    if (progress) progress({0, 1, done, kWhole});
    return {};
  };
  auto opened = openedRecording(wanted);
  if (opened.ok() && opened->imported && progress) progress({1, 1, kWhole, kWhole});
  return opened;
}

/// What a cell that nobody described is shown with.
void nameBareCell(const ContentRequest& request, Cell& cell, std::vector<PictureNote>& notes) {
  if (request.log.empty()) {
    cell.file = endpointsText(request);
    notes.push_back(
        {"no cell is open: what packets say is shown, poses as axes; open a cell or model to see "
         "more",
         false});
    return;
  }
  cell.file = request.log.string();
  notes.push_back(
      {"this log carries no cell: what its packets say is shown, poses as axes; open "
       "it together with its cell or model to see more",
       false});
}

/// The file that has the cell. Of a log without one it is the cell that was shown before, and empty
/// where there was none.
Result<fs::path> cellFile(const ContentRequest& request, const OpenedRecording& opened) {
  if (request.log.empty()) return request.cell;
  if (!request.cell.empty() && request.cell != request.log) return request.cell;
  const auto log = LogReader::open(opened.log);
  if (!log.ok()) return log.error();
  const auto carried = readAttachedCell(*log);
  if (!carried.ok()) return carried.error();
  if (*carried) return opened.log;
  return request.fallback_cell;
}

/// A recording that continues, in this log or in a later piece, is followed; any other log is read
/// as it is. Its events are found here, where the window can show how far that is.
Result<Timeline> openSession(const fs::path& log, const TellLoadProgress& progress,
                             const std::stop_token& stop) {
  auto session = Timeline::follow(log);
  if (session.ok() && !session->log().growing()) session = Timeline::open(log);
  if (!session.ok()) return session;
  session->useStop(stop);
  StateDamage hiding;  // the panel counts all places of damage
  if (auto events = session->events(&hiding, progress); !events.ok()) return events.error();
  return session;
}

/// The log beside, with what showing it will ask of it: that may take a while.
Result<BesideLog> readBeside(const ContentRequest& request, const fs::path& cell,
                             const TellLoadProgress& progress, const std::stop_token& stop) {
  auto opened = openRecordingOf(request, request.beside, cell, progress, stop);
  if (!opened.ok()) return opened.error();
  auto session = Timeline::open(opened->log);
  if (!session.ok()) return opened->named(session.error());
  session->useStop(stop);
  StateDamage hiding;  // the panel counts all places of damage
  if (request.align.starts_with("event")) {
    if (auto events = session->events(&hiding, progress); !events.ok()) return events.error();
  }
  if (auto last = session->stateAt(session->end(), &hiding); !last.ok()) {
    return opened->named(last.error());
  }
  BesideLog beside{std::move(*session), std::move(opened->warnings), std::move(opened->folder)};
  if (!opened->not_kept.empty()) beside.warnings.push_back(opened->not_kept);
  return beside;
}

/// The log beside, if one is wanted: none any more where it is none of the cell.
Status showBeside(ContentRequest& request, const fs::path& cell, const TellLoadProgress& progress,
                  const std::stop_token& stop, ViewContent& content) {
  if (request.beside.empty()) return {};
  auto beside = readBeside(request, cell, progress, stop);
  if (!beside.ok()) return beside.error();
  auto added = addBeside(std::move(*beside), request, content);
  if (!added.ok()) return added.error();
  std::ranges::move(added->warnings, std::back_inserter(content.warnings));
  if (added->refusal.empty()) return {};
  content.warnings.push_back(added->refusal);
  content.model->viewer.panels.notes.push_back({std::move(added->refusal), true});
  request.beside.clear();
  request.align.clear();
  return {};
}

/// Real pictures behind the model, and the camera that has them unless another was asked for.
Status openBackdrop(const ContentRequest& request, ViewContent& content) {
  if (request.backdrop.file.empty()) return {};
  ViewModel& model = *content.model;
  const LogTime end = model.cursor() != nullptr ? model.cursor()->end() : LogTime{};
  auto opened = Backdrop::open(request.backdrop, model.cell(), model.origin(), end);
  if (!opened.ok()) return opened.error();
  content.backdrop = std::make_unique<Backdrop>(std::move(*opened));
  model.backdrop.emplace();
  model.backdrop->camera = content.backdrop->camera();
  model.backdrop->opacity = request.backdrop.opacity;
  model.backdrop->offset = content.backdrop->offset();
  content.backdrop->setOffset(Nanoseconds(0));  // the model's counts
  if (request.camera.empty()) model.useCamera(model.backdrop->camera);
  return {};
}

/// The options that move joints by hand, and those that send.
Status moveByHand(const ContentRequest& request, ViewModel& model) {
  HandJoints hand;
  for (const std::string& text : request.joints) {
    if (model.session() != nullptr || model.isLive()) {
      return Error{ErrorKind::bad_argument, "--joints poses a cell without a session",
                   "--joints " + text};
    }
    if (auto set = setJoints(hand, model.cell(), text); !set) {
      return Error{set.error().kind, set.error().what, "--joints " + text};
    }
  }
  if (!hand.empty()) model.hand.take(std::move(hand));
  if (!request.publish.empty()) {
    const Status begun =
        model.publishing.begin(request.publish, request.publish_as, SteadyTime{}, WallTime{});
    if (!begun) return begun;
  }
  if (request.drive.empty()) return {};
  return model.hand.drive(request.drive,
                          request.drive_as.empty() ? DriveSettings().source : request.drive_as);
}

/// Looks, camera and moment of the program's arguments.
Status applyArguments(const ContentRequest& request, ViewModel& model,
                      std::vector<std::string>& warnings) {
  RenderStyle style;
  for (const std::string& word : request.styles) {
    if (auto set = setStyle(style, word); !set) return set.error();
  }
  if (auto known = model.names().check(style); !known) return known.error();
  model.setStyle(style);
  for (const auto* paths : {&request.hide, &request.show}) {
    for (const std::string& path : *paths) {
      const std::string doubt = model.names().doubtAbout(path);
      if (!doubt.empty()) warnings.push_back(doubt);
    }
  }
  if (!request.camera.empty()) {
    if (auto known = model.names().checkCamera(request.camera); !known) return known.error();
    model.useCamera(request.camera);
  }
  if (auto posed = moveByHand(request, model); !posed) return posed.error();
  if (request.at.empty()) return {};
  TimelineCursor* cursor = model.cursor();
  if (cursor == nullptr) {
    const std::string option = request.at_event ? "--event" : "--at";
    return Error{ErrorKind::bad_argument, option + " needs a log", option + " " + request.at};
  }
  if (model.session() == nullptr) return {};
  const auto moment = request.at_event ? momentOfEvent(request.at, *model.session())
                                       : parseMoment(request.at, *model.session());
  if (!moment.ok()) return moment.error();
  cursor->seek(*moment, SteadyTime{});
  return {};
}

}  // namespace

std::vector<PictureNote> notesOf(const Cell& cell) {
  std::vector<PictureNote> notes;
  std::size_t errors = 0;
  for (const Finding& fault : cell.faults) {
    if (fault.severity != Severity::error) continue;
    if (++errors <= 3) notes.push_back({fault.print(), true});
  }
  if (errors > 3) {
    notes.push_back({fmt::format("{} errors in all; rocinante check lists them", errors), true});
  }
  const std::string left_out = accountBrief(accountOf(cell.faults));
  if (!left_out.empty()) {
    notes.push_back({left_out + "; rocinante check lists what and why", false});
  }
  return notes;
}

bool isHopeless(const Cell& cell) {
  const bool has_errors = std::ranges::any_of(
      cell.faults, [](const Finding& fault) { return fault.severity == Severity::error; });
  if (!has_errors) return false;
  const bool draws =
      std::ranges::any_of(cell.models,
                          [](const auto& named) {
                            return named.second != nullptr && hasGeometry(*named.second);
                          }) ||
      std::ranges::any_of(cell.devices, [&](const CellDevice& device) {
        const Model* const model = cell.modelOf(device);
        return model != nullptr && hasGeometry(*model);
      });
  return !draws;
}

Result<ViewContent> loadContent(ContentRequest request, const TellLoadProgress& progress,
                                const std::stop_token& stop) {
  if (request.beside_alone) {
    auto beside = readBeside(request, request.cell, progress, stop);
    if (!beside.ok()) return beside.error();
    ViewContent alone;
    alone.request = std::move(request);
    alone.beside = std::move(*beside);
    return alone;
  }
  if (auto read = readEndpoints(request); !read) return read.error();
  if (request.empty()) {
    ViewContent nothing = emptyContent();
    nothing.request = std::move(request);
    return nothing;
  }
  OpenedRecording recording;
  if (!request.log.empty()) {
    auto opened = openRecordingOf(request, request.log, request.cell, progress, stop);
    if (!opened.ok()) return opened.error();
    recording = std::move(*opened);
  }
  const auto file = cellFile(request, recording);
  if (!file.ok()) return recording.named(file.error());
  const bool is_own_cell = !recording.log.empty() && *file == recording.log;
  const bool is_bare = file->empty();
  if (recording.imported && request.cell.empty() && !is_own_cell && !is_bare) {
    // Of the cell that is shown: its names are meant.
    auto opened = openRecordingOf(request, request.log, *file, progress, stop);
    if (!opened.ok()) return opened.error();
    recording = std::move(*opened);
  }
  CellOptions options;
  // A cell in a log is complete; an import has looked for its files.
  if (!recording.imported || !is_own_cell) {
    static_cast<ModelSearch&>(options) = request.where;
  }
  request.cell = is_own_cell ? request.log : *file;
  options.parallel = cli::workerThreads();
  options.progress = progress;
  Result<Cell> cell = is_bare ? bareCell() : CellCache::ofUser().load(*file, options);
  if (!cell.ok()) return recording.named(cell.error());
  if (recording.folder) {
    // A temporary log lasts as long as the cell that is shown with it.
    cell->keeps_files = std::make_shared<
        const std::pair<std::shared_ptr<const void>, std::shared_ptr<const PrivateFolder>>>(
        cell->keeps_files, recording.folder);
  }
  ViewContent content;
  std::vector<PictureNote> notes = notesOf(*cell);
  if (is_bare) nameBareCell(request, *cell, notes);
  for (const std::string& warning : recording.warnings) notes.push_back({warning, false});
  if (!recording.not_kept.empty()) notes.push_back({recording.not_kept, false});
  for (const PictureNote& note : notes) content.warnings.push_back(note.text);

  std::optional<Timeline> session;
  if (!request.log.empty()) {
    auto opened = openSession(recording.log, progress, stop);
    if (!opened.ok()) return recording.named(opened.error());
    session = std::move(*opened);
    if (!session->growing()) {
      const std::string note = logAccount(*session, is_bare ? nullptr : &*cell).note();
      if (!note.empty()) {
        content.warnings.push_back(note);
        notes.push_back({note, false});
      }
    }
  }
  auto feed = openFeed(request, *cell, content.warnings);
  if (!feed.ok()) return feed.error();
  auto model = ViewModel::make(std::move(*cell), std::move(session), std::move(*feed), request.hide,
                               request.show);
  if (!model.ok()) return model.error();
  content.model = std::make_unique<ViewModel>(std::move(*model));
  content.model->viewer.panels.notes = std::move(notes);
  if (auto shown = showBeside(request, *file, progress, stop, content); !shown) {
    return shown.error();
  }
  constexpr const char* kBareStyle = "axes=*";
  if (is_bare && std::ranges::find(request.styles, kBareStyle) == request.styles.end()) {
    request.styles.insert(request.styles.begin(), kBareStyle);
  }
  if (auto applied = applyArguments(request, *content.model, content.warnings); !applied) {
    return applied.error();
  }
  if (auto opened = openBackdrop(request, content); !opened) return opened.error();
  content.request = std::move(request);
  return content;
}

ViewContent emptyContent() {
  ViewContent content;
  auto model = ViewModel::make(Cell(), std::nullopt, std::nullopt, {}, {});
  content.model = std::make_unique<ViewModel>(std::move(*model));
  content.model->viewer.is_empty = true;
  return content;
}

void ContentLoader::start(ContentRequest request) {
  name_ = request.title();
  busy_ = true;
  progress_ = {};
  const auto load = [this](ContentRequest& asked, const std::stop_token& stop) {
    const TellLoadProgress on_terminal =
        cli::loadProgress(asked.named().empty() ? asked.title() : asked.named().string());
    const TellLoadProgress tell = [&](const LoadProgress& now) {
      on_terminal(now);
      const std::lock_guard lock(mutex_);
      progress_ = now;
    };
    return loadContent(std::move(asked), tell, stop);
  };
  if (!worker_) worker_.emplace(load, nullptr, ThreadPriority::normal);
  worker_->ask(std::move(request));
}

std::optional<Result<ViewContent>> ContentLoader::waitFor(Nanoseconds most) {
  if (!busy_ || !worker_->waitFor(most)) return std::nullopt;
  busy_ = false;
  return std::move(*worker_->found());
}

LoadProgress ContentLoader::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

}  // namespace rocinante
