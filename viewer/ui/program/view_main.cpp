// rocinante-view: the interactive viewer (docs/programs/view.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/base/atomic_file.h"
#include "core/bundle/cell_or_log.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "core/foreign/recordings/opened_recording.h"
#include "viewer/gl/shader_cache.h"
#include "viewer/ui/live/kept_folder.h"
#include "viewer/ui/program/frame_journal.h"
#include "viewer/ui/program/view_program.h"

namespace rocinante {
namespace {

using cli::Exit;

constexpr char kExamples[] =
    "  rocinante view                                   open or drop files in the window\n"
    "  rocinante view examples/demo/demo.cell.toml out/demo/live.mcap\n"
    "  rocinante view session.mcap                      a log that carries its cell\n"
    "  rocinante view cell.toml today.mcap --beside accepted.mcap --align events\n"
    "  rocinante view puma.urdf                         every joint has a slider\n"
    "  rocinante view puma.urdf --live\n"
    "  rocinante view puma.urdf --live --drive 127.0.0.1:19960 --as me"
    "    move it by hand\n"
    "  rocinante view cell.toml --live --publish udp://239.255.86.10:19960?interface=lo --as ann\n"
    "    others see where ann looks and points; Z watches another\n"
    "  rocinante view cell.toml --live --keep 1h,8GB\n"
    "  rocinante view cell.toml --live :49152 --decoders kuka.decoders.toml\n"
    "  rocinante view cell.toml --live 0.0.0.0:19960 --camera overview\n"
    "  rocinante view cell.toml session.mcap --profile reproducible --script look.txt\n"
    "  rocinante view cell.toml session.mcap --record-input bug.txt"
    "   --script bug.txt does it again\n";

/// Hours of recorded input.
constexpr std::size_t kMostScriptBytes = 16U << 20U;

struct Arguments {
  std::filesystem::path cell, log, beside, script;
  std::string align;
  std::vector<std::string> live;
  std::string keep = "10m,2GB";
  bool leftovers = false, forget_leftovers = false;
  std::string trust, decoders;
  std::vector<std::string> joints;
  std::string drive, publish, as;
  std::string backdrop;
  BackdropRequest backdrop_terms;
  std::string profile = "fast", camera, at, event, size, detail = "auto";
  std::vector<std::string> styles;
  double target_fps = 30;
  std::vector<std::string> hide, show;
  ModelSearch where;
  bool is_live = false, fresh = false;
  int samples = 4;
  std::optional<double> scale;
  std::filesystem::path frame_times, record_input;
};

Result<ContentRequest> contentRequest(const Arguments& arguments) {
  if (!arguments.publish.empty() && arguments.as.empty()) {
    return Error{ErrorKind::bad_argument, "others need a name for this window: add --as NAME",
                 "--publish " + arguments.publish};
  }
  if (!arguments.as.empty() && arguments.publish.empty() && arguments.drive.empty()) {
    return Error{ErrorKind::bad_argument, "this needs --publish or --drive",
                 "--as " + arguments.as};
  }
  ContentRequest request;
  request.cell = arguments.cell;
  request.log = arguments.log;
  request.beside = arguments.beside;
  request.align = arguments.align;
  request.trust = arguments.trust;
  request.decoders = arguments.decoders;
  request.hide = arguments.hide;
  request.show = arguments.show;
  request.styles = arguments.styles;
  request.camera = arguments.camera;
  request.at_event = !arguments.event.empty();
  request.at = request.at_event ? arguments.event : arguments.at;
  request.joints = arguments.joints;
  if (!arguments.backdrop.empty()) {
    auto backdrop = parseBackdrop(arguments.backdrop);
    if (!backdrop.ok()) return backdrop.error();
    backdrop->offset = arguments.backdrop_terms.offset;
    backdrop->opacity = arguments.backdrop_terms.opacity;
    request.backdrop = std::move(*backdrop);
  }
  request.drive = arguments.drive;
  request.publish = arguments.publish;
  request.publish_as = arguments.as;
  // Two sources of one name would be taken for one that begins anew again and again.
  const bool both = !arguments.publish.empty() && !arguments.drive.empty();
  request.drive_as = both ? arguments.as + "-hand" : arguments.as;
  request.where = arguments.where;
  if (!arguments.is_live) return request;
  if (!arguments.log.empty()) {
    return Error{ErrorKind::bad_argument, "a log and --live cannot be used together", ""};
  }
  if (arguments.cell.empty()) {
    return Error{ErrorKind::bad_argument, "--live needs a CELL", ""};
  }
  request.live.emplace();
  for (const std::string& text : arguments.live) {
    if (text.empty()) continue;
    auto endpoint = Endpoint::parse(text);
    if (!endpoint.ok()) return endpoint.error();
    request.live->push_back(*endpoint);
  }
  if (request.live->empty()) request.live->push_back(Endpoint::standard());
  const auto keep = parseKeepLimits(arguments.keep);
  if (!keep.ok()) return keep.error();
  request.keep = *keep;
  return request;
}

Result<ViewOptions> viewOptions(const Arguments& arguments) {
  ViewOptions options;
  char end = 0;
  options.fresh = arguments.fresh;
  if (!arguments.size.empty() &&
      (std::sscanf(arguments.size.c_str(), "%dx%d%c", &options.width, &options.height, &end) != 2 ||
       options.width < 64 || options.height < 64 || options.width > 8192 ||
       options.height > 8192)) {
    return Error{ErrorKind::bad_argument, "the size must be WIDTHxHEIGHT, each from 64 to 8192",
                 "--size " + arguments.size};
  }
  options.samples = arguments.samples;
  options.scale = arguments.scale;
  options.frame_times = arguments.frame_times;
  options.record_input = arguments.record_input;
  if (!options.frame_times.empty()) {
    if (Status begun = FrameJournal::begin(options.frame_times); !begun) return begun.error();
  }
  options.target_fps = arguments.target_fps;
  if (arguments.detail != "auto") {
    options.detail = parseDetailRung(arguments.detail);
    if (!options.detail) {
      return Error{
          ErrorKind::bad_argument,
          fmt::format("the level of detail must be auto, or 0 (everything) to {}", kCoarsestRung),
          "--detail " + arguments.detail};
    }
  }
  options.profile = arguments.profile == "fast" ? Profile::fast : Profile::reproducible;
  if (!arguments.script.empty()) {
    const auto text = readFile(arguments.script, kMostScriptBytes);
    if (!text.ok()) return text.error();
    auto commands = parseViewScript(*text, arguments.script.string());
    if (!commands.ok()) return commands.error();
    options.script = std::move(*commands);
    options.script_name = arguments.script.string();
    if (options.script.empty()) {
      return Error{ErrorKind::bad_argument, "the script has no commands", options.script_name};
    }
  }
  return options;
}

/// `--leftovers` and `--forget-leftovers`.
Result<Exit> lookAtLeftovers(const Arguments& arguments) {
  const std::vector<KeptLeftover> leftovers = KeptFolder::leftovers(KeptFolder::ofUser());
  if (!arguments.forget_leftovers) {
    fmt::print("{}", leftoversText(leftovers));
    return Exit::done;
  }
  for (const KeptLeftover& leftover : leftovers) {
    if (Status gone = KeptFolder::forget(leftover); !gone) return gone.error();
    fmt::print("deleted {}\n", leftover.folder.string());
  }
  return Exit::done;
}

Result<Exit> view(const Arguments& arguments) {
  auto options = viewOptions(arguments);
  if (!options.ok()) return options.error();
  if (arguments.is_live && arguments.record_input.empty()) {
    options->notice = leftoversOffer(KeptFolder::leftovers(KeptFolder::ofUser()));
    if (!options->notice.empty()) cli::warn(options->notice);
  }
  const auto request = contentRequest(arguments);
  if (!request.ok()) return request.error();
  const auto beyond_doubt = runViewer(*request, *options);
  if (!beyond_doubt.ok()) return beyond_doubt.error();
  return *beyond_doubt ? Exit::done : Exit::no;
}

int viewMain(int argc, char** argv) {
  CLI::App app("Shows a cell at rest, in a recorded session or live.", "rocinante-view");
  Arguments arguments;
  app.add_option(
      "CELL", arguments.cell,
      "a *.cell.toml, a .urdf, an .obj, or a log or bag that carries its cell; without it "
      "the window says how to open one");
  app.add_option("LOG", arguments.log, "a recorded session: a log, or a bag, capture or table");
  auto* beside = app.add_option("--beside", arguments.beside,
                                "another log of the cell: its devices as clear ghosts, where they "
                                "are elsewhere, and its curves")
                     ->type_name("LOG");
  app.add_option("--align", arguments.align,
                 "of --beside: origin, events, event:TEXT, or an offset, 2.5s; default: origin")
      ->needs(beside)
      ->type_name("HOW");
  auto* live = app.add_option("--live", arguments.live,
                              "show live packets; EP as in `rocinante record`, default: the "
                              "standard group; repeatable")
                   ->expected(0, 1)
                   ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--keep", arguments.keep,
                 "how much of a live session is kept to be shown again and saved: a time, a size "
                 "or both, whichever comes first; 0: nothing")
      ->needs(live)
      ->type_name("LIMITS")
      ->capture_default_str();
  app.add_flag("--leftovers", arguments.leftovers,
               "list live sessions that killed windows have left behind");
  app.add_flag("--forget-leftovers", arguments.forget_leftovers, "delete them");
  app.add_option("--trust", arguments.trust,
                 "show only what is signed with a key of this file (rocinante key)")
      ->needs(live)
      ->type_name("FILE");
  app.add_option("--decoders", arguments.decoders,
                 "decode what is not packet text as this file declares; default: the cell's")
      ->needs(live)
      ->type_name("FILE");
  app.add_option("--joints", arguments.joints,
                 "without a session: all joint values of a device in its model's order, "
                 "\"0 -0.785 0\"; repeatable")
      ->option_text("[DEVICE=]VALUES")
      ->allow_extra_args(false);
  app.add_option("--drive", arguments.drive,
                 "send the joints that are moved by hand to this endpoint")
      ->option_text("EP");
  app.add_option("--publish", arguments.publish,
                 "let other windows that hear this endpoint see where this one looks and points, "
                 "what is drawn and said in it; with --as")
      ->option_text("EP");
  app.add_option("--as", arguments.as,
                 "the SOURCE name of --publish and --drive; default of --drive: hand")
      ->option_text("NAME");
  app.add_option("--profile", arguments.profile,
                 "fast: the driver as it is; reproducible: the same bits everywhere")
      ->check(CLI::IsMember({"fast", "reproducible"}))
      ->capture_default_str();
  app.add_option("--camera", arguments.camera, "a camera of the cell or a view of the session");
  auto* at = app.add_option("--at", arguments.at,
                            "start at this session time (12.5s, -1s, RFC 3339), or at the event "
                            "with this text");
  app.add_option("--event", arguments.event, "start at the event whose text matches")
      ->option_text("PATTERN")
      ->excludes(at);
  auto* backdrop = app.add_option("--backdrop", arguments.backdrop,
                                  "pictures of a real camera behind and over the model: a picture, "
                                  "a folder with times, or a video (by ffmpeg)")
                       ->option_text("FILE[,camera=NAME][,fps=N]");
  app.add_option("--backdrop-offset", arguments.backdrop_terms.offset,
                 "the session time at which the backdrop begins: 2.5s, -300ms; default: 0")
      ->needs(backdrop)
      ->type_name("SECONDS");
  app.add_option("--backdrop-opacity", arguments.backdrop_terms.opacity,
                 "how much of the backdrop covers the model: 0 (nothing) to 1")
      ->needs(backdrop)
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--size", arguments.size,
                 "size of the window, WIDTHxHEIGHT; default: as it was last, else 1280x720");
  app.add_flag("--fresh", arguments.fresh,
               "neither use nor change what was remembered: size, panels, theme, recent files");
  app.add_option("--detail", arguments.detail,
                 "auto: as much as --target-fps allows (fast profile); or a level, 0 "
                 "(everything) to 9")
      ->capture_default_str();
  app.add_option("--target-fps", arguments.target_fps, "frames per second to hold, 1 to 240")
      ->check(CLI::Range(1.0, 240.0))
      ->capture_default_str();
  app.add_option("--style", arguments.styles,
                 "a style, KEY or KEY=VALUE, as in `rocinante render`; repeatable");
  app.add_option("--scale", arguments.scale,
                 "scale of text, panels and lines, 1 to 4; default: the screen's")
      ->check(CLI::Range(1.0, 4.0));
  app.add_option("--samples", arguments.samples, "multisampling: 1, 2, 4 or 8")
      ->check(CLI::IsMember({1, 2, 4, 8}))
      ->capture_default_str();
  app.add_option("--hide", arguments.hide, "do not show DEVICE, DEVICE/LINK or layer/NAME");
  app.add_option("--show", arguments.show, "show DEVICE, DEVICE/LINK or layer/NAME even if hidden");
  arguments.where.search_environment = true;
  cli::addSearchFolderOptions(app, arguments.where);
  app.add_option("--frame-times", arguments.frame_times,
                 "write when each frame was shown and what it cost, as CSV")
      ->type_name("FILE");
  auto* script = app.add_option("--script", arguments.script,
                                "drive the window from this file, then close it");
  app.add_option("--record-input", arguments.record_input,
                 "write what mouse and keyboard do here, as a script that does it again")
      ->type_name("FILE")
      ->excludes(script);
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<Exit> {
    if (arguments.leftovers || arguments.forget_leftovers) return lookAtLeftovers(arguments);
    cli::catchStopSignals();
    const cli::StopDeadline until_stopped("stopped");
    arguments.is_live = live->count() > 0;
    orderCellAndLog(arguments.cell, arguments.log);
    const bool is_recording = isLog(arguments.cell) || isForeignRecording(arguments.cell);
    if (arguments.log.empty() && !arguments.is_live && is_recording) {
      arguments.log = arguments.cell;
    }
    return view(arguments);
  });
}

/// The profile must be known before the first thread, so before the arguments are parsed.
bool wantsReproducible(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--profile=reproducible") return true;
    if (word == "--profile" && i + 1 < argc && std::string_view(argv[i + 1]) == "reproducible") {
      return true;
    }
  }
  return false;
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) {
  if (rocinante::wantsReproducible(argc, argv)) {
    rocinante::pinRendererEnvironment();
  } else {
    rocinante::avoidShaderCacheOnFullDisk();
  }
  return rocinante::viewMain(argc, argv);
}
