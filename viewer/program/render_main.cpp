#include <cstdio>
#include <map>
#include <optional>
#include <tuple>

#include "core/cli/load_progress.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/cli/progress_line.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "core/report/json_text.h"
#include "core/session/log_pieces.h"
#include "viewer/backdrop/backdrop_options.h"
#include "viewer/detail/detail_level.h"
#include "viewer/gl/context_option.h"
#include "viewer/gl/shader_cache.h"
#include "viewer/picture/picture_options.h"
#include "viewer/program/render_job.h"
#include "viewer/view/scene_options.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante render cell.toml session.mcap --at 12.5s -o frame.png\n"
    "  rocinante render session.mcap --at 12.5s -o frame.png   a log that carries its cell\n"
    "  rocinante render robot.urdf bag.mcap --every 1s --sheet sheet.png   a ROS bag\n"
    "  rocinante render panda.urdf -o panda.png --size 1280x720\n"
    "  rocinante render cell.toml session.mcap --at 1 --at 2.5 --at -1s --sheet sheet.png\n"
    "  rocinante render cell.toml session.mcap --every 0.04s --frames frames/\n"
    "  rocinante render cell.toml session.mcap --at 12.5s --hash\n"
    "  rocinante render cell.toml session.mcap --at 3 --hide layer/labels --camera side -o f.png\n"
    "  rocinante render cell.toml session.mcap --events --overlay --frames events/\n"
    "  rocinante render cell.toml session.mcap --video out.mp4 --inset map:bottom-left\n"
    "  rocinante render cell.toml session.mcap --at 3 --identity ids.png --depth depth.png\n";

/// Faults shown; further ones are only counted.
constexpr std::size_t kWarningsShown = 5;

void printWarnings(const RenderReport& report) {
  if (const std::string note = report.account.note(); !note.empty()) cli::warn(note);
  if (report.goes_on) cli::warn(kGoesOn);
  for (std::size_t i = 0; i < report.warnings.size() && i < kWarningsShown; ++i) {
    cli::warn(report.warnings[i]);
  }
  if (report.warnings.size() > kWarningsShown) {
    cli::warn("... and " + std::to_string(report.warnings.size() - kWarningsShown) +
              " more faults of the model (rocinante check lists all)");
  }
}

/// Makes logs of other programs' recordings, and lets the job read those.
Result<OpenedRecording> openRecordingOf(RenderJob& job) {
  auto opened = cli::openCellAndLog(job.cell, job.log, job);
  if (opened) cli::warnOf(*opened);
  return opened;
}

/// The same for the log beside.
Result<OpenedRecording> openBeside(RenderJob& job) {
  if (job.beside.empty()) return OpenedRecording{};
  auto opened = cli::openWithinDeadline(job.beside, job.cell, job);
  if (!opened) return opened;
  cli::warnOfAccount(opened->log, nullptr);
  job.beside = opened->log;
  return opened;
}

void printJson(const RenderReport& report) {
  Json json;
  json["format"] = 1;
  json["renderer"] = report.key.text();
  json["inputs"] = report.inputs;
  json["frames"] = Json::array();
  for (const RenderedFrame& frame : report.frames) {
    Json one;
    one["time"] = frame.time;
    one["log_time_ns"] = frame.log_time.time_since_epoch().count();
    if (!frame.event.empty()) one["event"] = frame.event;
    if (!frame.camera.empty()) one["camera"] = frame.camera;
    one["sha256"] = frame.sha256;
    if (!frame.file.empty()) one["file"] = frame.file.string();
    if (!frame.identity.empty()) one["identity"] = frame.identity.string();
    if (!frame.depth.empty()) one["depth"] = frame.depth.string();
    if (!frame.damage.empty()) one["damage"] = frame.damage.text();
    json["frames"].push_back(std::move(one));
  }
  if (!report.videos.empty()) json["videos"] = Json::array();
  for (const auto& video : report.videos) json["videos"].push_back(video.string());
  json["warnings"] = report.warnings;
  json["at_rest"] = report.account.at_rest;
  json["not_in_cell"] = report.account.not_in_cell;
  json["left_out"] = leftOutJson(report.account.left_out);
  std::fputs(jsonText(json).c_str(), stdout);
}

void printHashes(const RenderReport& report, bool several_cameras) {
  for (const RenderedFrame& frame : report.frames) {
    std::string line = report.frames.size() > 1 ? frame.time + " " : "";
    if (several_cameras) line += frame.camera + " ";
    std::printf("%s%s\n", line.c_str(), frame.sha256.c_str());
  }
}

/// Given values of each look, by key.
using Looks = std::map<std::string, std::vector<std::string>>;

/// Adds one option per look: "--shadows", "--edges=only", "--trail arm/hand@5".
void addLooks(cli::CommandLine app, Looks& looks) {
  for (const StyleKey& key : styleKeys()) {
    const std::string name = "--" + std::string(key.key);
    const std::string means = std::string(key.means) + (key.repeats ? "; repeatable" : "");
    std::vector<std::string>& values = looks[std::string(key.key)];
    // A switch takes a value only with `=`: the next word may be the cell.
    const cli::Option option = key.values.starts_with("on|")
                                   ? app.addFlag(name + "{on}", values, means)
                                   : app.addOption(name, values, means).oneEach();
    option.valueText(std::string(key.values)).group("Looks");
  }
}

/// Joins "--shadows on" to "--shadows=on". A file named `on` can be given as "./on".
std::vector<std::string> withJoinedSwitches(int argc, char** argv) {
  std::vector<std::string> words;
  const StyleKey* last_switch = nullptr;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    if (last_switch != nullptr && !word.empty() && word.find('|') == std::string::npos &&
        ("|" + std::string(last_switch->values) + "|").find("|" + word + "|") !=
            std::string::npos) {
      words.back() += "=" + word;
      last_switch = nullptr;
      continue;
    }
    last_switch = nullptr;
    for (const StyleKey& key : styleKeys()) {
      if (key.values.starts_with("on|") && word == "--" + std::string(key.key)) last_switch = &key;
    }
    words.push_back(word);
  }
  return words;
}

Status setLooks(const Looks& looks, RenderStyle& style) {
  for (const auto& [key, values] : looks) {
    for (const std::string& value : values) {
      if (Status fit = setStyle(style, key, value); !fit) return fit;
    }
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app("Draws frames of a cell and a session without a window.", "rocinante-render");
  RenderJob job;
  std::string size = "640x480", backdrop_text;
  std::string caps = pinnableCaps().front();
  std::string profile = "reproducible";
  std::vector<std::string> insets;
  bool without_insets = false;
  bool hash = false;
  bool json = false;
  Looks looks;
  app.addOption("CELL", job.cell,
                "a .cell.toml, a .urdf, an .obj, or a log or bag that carries its cell")
      .required();
  app.addOption("LOG", job.log,
                "the session: a log, or a bag, capture or table; without one, the cell at rest");
  addBesideOptions(app, job.beside, job.align);
  app.addOption(
         "--at", job.moments.at,
         "a moment: 12.5, 1m02.5s, -1s from the end, RFC 3339, or an event's text; repeatable")
      .oneEach();
  app.addOption("--every", job.moments.every,
                "one frame per period, from the log's start to its end");
  app.addOption("--at-file", job.moments.at_file,
                "a file of moments, one per line; # begins a comment");
  app.addFlag("--events", job.moments.all_events, "every event and mark of the log");
  app.addOption("--event", job.moments.events,
                "events whose text matches this pattern (* and ?); repeatable")
      .valueText("PATTERN")
      .oneEach();
  app.addOption("--from", job.moments.from, "start of the range for --every, --events and --fps");
  app.addOption("--until", job.moments.until, "end of that range, exclusive");
  app.addOption(
      "-o,--output", job.output,
      "one frame: .png, or what OpenImageIO writes by the ending (.jpg, .tif, .webp, .exr)");
  app.addOption("--sheet", job.sheet, "all moments on one picture, with their times below");
  app.addOption("--frames", job.frames, "a folder for frame-00001.png and the following");
  app.addOption("--frame-type", job.frame_type,
                "ending of the files in --frames: png, jpg, exr ...")
      .valueText("ENDING [png]");
  app.addOption("--video", job.video, "all moments as .mp4, .mkv, .mov or .webm, by ffmpeg");
  app.addOption("--fps", job.moments.rate, "of --video: frames per second, 25 or 30000/1001");
  app.addOption("--identity", job.identity,
                "devices and links as colours (.png) or numbers (.exr), and a JSON legend");
  app.addOption("--depth", job.depth,
                "depth along the view: 16-bit .png, its unit in JSON, or .exr in metres");
  app.addOption("--camera", job.cameras,
                "a camera of the cell, a `view` of the session, map, fit or fit:DEVICE; "
                "repeatable")
      .valueText("NAME")
      .oneEach();
  app.addOption("--inset", insets, "an inset that replaces the cell's; repeatable")
      .valueText("CAMERA[:CORNER][:SIZE]")
      .oneEach();
  app.addFlag("--no-insets", without_insets, "leave out the cell's insets");
  const cli::Option backdrop = addBackdropOptions(app, backdrop_text, job.backdrop);
  app.addFlag("--overlay", job.look.panel, "time, devices, joint values and rates in a corner");
  app.addOption("--size", size, "size in pixels").showDefault();
  app.addOption("--scale", job.look.scale,
                "scale of text, lines and everything sized in pixels; 2 for twice as many pixels")
      .within(kLeastScale, kLargestScale)
      .showDefault();
  app.addOption("--samples", job.look.samples, "MSAA samples: 1 or 4 on llvmpipe").showDefault();
  app.addOption("--detail", job.look.detail,
                "level of detail: 0 (everything) to 9, as in `rocinante view`")
      .within(0, kCoarsestRung)
      .showDefault();
  addJointsOption(app, job.joints);
  addVisibilityOptions(app, job.look.hide, job.look.show);
  addLayersOption(app, job.layers);
  addLooks(app, looks);
  addProfileOption(app, profile);
  app.addOption("--caps", caps, "the processor features that the reproducible profile uses")
      .oneOf(pinnableCaps())
      .showDefault();
  addContextOption(app);
  cli::addSearchOptions(app, job);
  app.addFlag("--hash", hash,
              "print the SHA-256 of the RGBA rows, top to bottom, one line per frame");
  app.addFlag("--force", job.overwrite, "replace existing files");
  app.addFlag("--json", json, "print a report as JSON");

  std::vector<std::string> words = withJoinedSwitches(argc, argv);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return cli::run(
      app, static_cast<int>(words.size()), arguments.data(), kExamples, [&]() -> Result<cli::Exit> {
        // Mesa reads the environment when the first context is made.
        job.profile = profile == "fast" ? Profile::fast : Profile::reproducible;
        if (job.profile == Profile::reproducible) {
          pinRendererEnvironment(caps);
        } else {
          avoidShaderCacheOnFullDisk();
        }
        orderCellAndLog(job.cell, job.log);
        const auto pixels = parsePictureSize(size);
        if (!pixels) return pixels.error();
        std::tie(job.look.width, job.look.height) = *pixels;
        if (Status set = setLooks(looks, job.look.style); !set) return set.error();
        if (backdrop.given()) {
          if (Status read = readBackdrop(backdrop_text, job.backdrop); !read) return read.error();
        }
        job.hashes = hash || json;
        if (job.output.empty() && job.sheet.empty() && job.frames.empty() && job.video.empty() &&
            job.identity.empty() && job.depth.empty() && !job.hashes) {
          return Error{ErrorKind::bad_argument,
                       "no output: give -o FILE, --sheet FILE, --frames DIR, --video FILE, "
                       "--identity FILE, --depth FILE, --hash or --json",
                       {}};
        }
        if (without_insets && !insets.empty()) {
          return Error{
              ErrorKind::bad_argument, "--inset and --no-insets cannot be used together", {}};
        }
        auto chosen_insets = parseInsets(insets, without_insets);
        if (!chosen_insets) return chosen_insets.error();
        job.look.insets = std::move(*chosen_insets);
        job.parallel = cli::workerThreads();
        cli::catchStopSignals();
        const cli::StopDeadline until_stopped("stopped");
        const Result<OpenedRecording> recording = openRecordingOf(job);
        if (!recording) return recording.error();
        const Result<OpenedRecording> beside = openBeside(job);
        if (!beside) return beside.error();
        job.load_progress = cli::loadProgress(recording->imported && job.cell == job.log
                                                  ? recording->recording.string()
                                                  : job.cell.string());
        std::optional<cli::ProgressLine> line;
        const auto report = render(job, [&](std::size_t done, std::size_t of) {
          if (!line) line.emplace("drawing");
          line->show(static_cast<double>(done) / static_cast<double>(of));
          return !cli::stopRequested();
        });
        line.reset();
        if (!report) return recording->named(report.error());
        printWarnings(*report);
        if (json) {
          printJson(*report);
        } else if (hash) {
          printHashes(*report, job.cameras.size() > 1);
        }
        return report->is_whole ? cli::Exit::done : cli::Exit::no;
      });
}
