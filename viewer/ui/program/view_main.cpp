// rocinante-view: the interactive viewer (docs/programs/view.md).
#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/bundle/cell_or_log.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "core/foreign/recordings/opened_recording.h"
#include "viewer/backdrop/backdrop_options.h"
#include "viewer/gl/shader_cache.h"
#include "viewer/ui/live/kept_folder.h"
#include "viewer/ui/program/frame_journal.h"
#include "viewer/ui/program/view_program.h"
#include "viewer/view/scene_options.h"

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
  ContentRequest content;
  ViewOptions options;
  // What is read from texts into the two.
  std::filesystem::path script, layout;
  std::vector<std::string> live;
  std::string keep = "10m,2GB", as, event, backdrop;
  std::string profile = "fast", size, detail = "auto";
  bool is_live = false, leftovers = false, forget_leftovers = false;
};

Status finishContent(const Arguments& arguments, ContentRequest& content) {
  if (!content.publish.empty() && arguments.as.empty()) {
    return Error{ErrorKind::bad_argument, "others need a name for this window: add --as NAME",
                 "--publish " + content.publish};
  }
  if (!arguments.as.empty() && content.publish.empty() && content.drive.empty()) {
    return Error{ErrorKind::bad_argument, "this needs --publish or --drive",
                 "--as " + arguments.as};
  }
  content.at_event = !arguments.event.empty();
  if (content.at_event) content.at = arguments.event;
  if (!arguments.backdrop.empty()) {
    if (Status read = readBackdrop(arguments.backdrop, content.backdrop); !read) return read;
  }
  content.publish_as = arguments.as;
  // Two sources of one name would be taken for one that begins anew again and again.
  const bool both = !content.publish.empty() && !content.drive.empty();
  content.drive_as = both ? arguments.as + "-hand" : arguments.as;
  if (!arguments.is_live) return {};
  if (!content.log.empty()) {
    return Error{ErrorKind::bad_argument, "a log and --live cannot be used together", ""};
  }
  content.live.emplace();
  for (const std::string& text : arguments.live) {
    if (text.empty()) continue;
    auto endpoint = Endpoint::parse(text);
    if (!endpoint.ok()) return endpoint.error();
    content.live->push_back(*endpoint);
  }
  if (content.live->empty()) content.live->push_back(Endpoint::standard());
  const auto keep = parseKeepLimits(arguments.keep);
  if (!keep.ok()) return keep.error();
  content.keep = *keep;
  return {};
}

Status finishOptions(const Arguments& arguments, ViewOptions& options) {
  char end = 0;
  if (!arguments.size.empty() &&
      (std::sscanf(arguments.size.c_str(), "%dx%d%c", &options.width, &options.height, &end) != 2 ||
       options.width < 64 || options.height < 64 || options.width > 8192 ||
       options.height > 8192)) {
    return Error{ErrorKind::bad_argument, "the size must be WIDTHxHEIGHT, each from 64 to 8192",
                 "--size " + arguments.size};
  }
  if (!options.frame_times.empty()) {
    if (Status begun = FrameJournal::begin(options.frame_times); !begun) return begun;
  }
  if (arguments.detail != "auto") {
    options.detail = parseDetailRung(arguments.detail);
    if (!options.detail) {
      return Error{
          ErrorKind::bad_argument,
          fmt::format("the level of detail must be auto, or 0 (everything) to {}", kCoarsestRung),
          "--detail " + arguments.detail};
    }
  }
  if (!arguments.layout.empty()) {
    auto layout = ViewLayout::load(arguments.layout);
    if (!layout.ok()) return layout.error();
    options.layout = std::move(*layout);
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
  return {};
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

Result<Exit> view(Arguments& arguments) {
  ViewOptions& options = arguments.options;
  if (Status fit = finishOptions(arguments, options); !fit) return fit.error();
  if (arguments.is_live && options.record_input.empty()) {
    options.notice = leftoversOffer(KeptFolder::leftovers(KeptFolder::ofUser()));
    if (!options.notice.empty()) cli::warn(options.notice);
  }
  if (Status fit = finishContent(arguments, arguments.content); !fit) return fit.error();
  const auto beyond_doubt = runViewer(arguments.content, options);
  if (!beyond_doubt.ok()) return beyond_doubt.error();
  return *beyond_doubt ? Exit::done : Exit::no;
}

int viewMain(int argc, char** argv) {
  cli::Program app("Shows a cell at rest, in a recorded session or live.", "rocinante-view");
  Arguments arguments;
  ContentRequest& content = arguments.content;
  ViewOptions& options = arguments.options;
  app.addOption(
      "CELL", content.cell,
      "a *.cell.toml, a .urdf, an .obj, or a log or bag that carries its cell; without it "
      "the window says how to open one");
  app.addOption("LOG", content.log, "a recorded session: a log, or a bag, capture or table");
  addBesideOptions(app, content.beside, content.align, ", and its curves");
  const cli::Option live =
      app.addOption("--live", arguments.live,
                    "show live packets; EP as in `rocinante record`, default: the "
                    "standard group; repeatable")
          .mayBeBare();
  app.addOption("--keep", arguments.keep,
                "how much of a live session is kept to be shown again and saved: a time, a size "
                "or both, whichever comes first; 0: nothing")
      .needs(live)
      .valueName("LIMITS")
      .showDefault();
  app.addFlag("--leftovers", arguments.leftovers,
              "list live sessions that killed windows have left behind");
  app.addFlag("--forget-leftovers", arguments.forget_leftovers, "delete them");
  app.addOption("--trust", content.trust,
                "show only what is signed with a key of this file (rocinante key)")
      .needs(live)
      .valueName("FILE");
  app.addOption("--decoders", content.decoders,
                "decode what is not packet text as this file declares; default: the cell's")
      .needs(live)
      .valueName("FILE");
  addJointsOption(app, content.joints);
  app.addOption("--drive", content.drive, "send the joints that are moved by hand to this endpoint")
      .valueText("EP");
  app.addOption("--publish", content.publish,
                "let other windows that hear this endpoint see where this one looks and points, "
                "what is drawn and said in it; with --as")
      .valueText("EP");
  app.addOption("--as", arguments.as,
                "the SOURCE name of --publish and --drive; default of --drive: hand")
      .valueText("NAME");
  addProfileOption(app, arguments.profile);
  app.addOption("--camera", content.camera, "a camera of the cell or a view of the session");
  const cli::Option at =
      app.addOption("--at", content.at,
                    "start at this session time (12.5s, -1s, RFC 3339), or at the event "
                    "with this text");
  app.addOption("--event", arguments.event, "start at the event whose text matches")
      .valueText("PATTERN")
      .excludes(at);
  addBackdropOptions(app, arguments.backdrop, content.backdrop);
  app.addOption("--size", arguments.size,
                "size of the window, WIDTHxHEIGHT; default: as it was last, else 1280x720");
  app.addOption("--layout", arguments.layout,
                "panels, curves, insets and camera as this NAME.layout.toml has them")
      .valueName("FILE");
  app.addFlag("--fresh", options.fresh,
              "neither use nor change what was remembered: size, panels, theme, recent files");
  app.addOption("--detail", arguments.detail,
                "auto: as much as --target-fps allows (fast profile); or a level, 0 "
                "(everything) to 9")
      .showDefault();
  app.addOption("--target-fps", options.target_fps, "frames per second to hold, 1 to 240")
      .within(1.0, 240.0)
      .showDefault();
  app.addOption("--style", content.styles,
                "a style, KEY or KEY=VALUE, as in `rocinante render`; repeatable");
  app.addOption("--scale", options.scale,
                "scale of text, panels and lines, 1 to 4; default: the screen's")
      .within(1.0, 4.0);
  app.addOption("--samples", options.samples, "multisampling: 1, 2, 4 or 8")
      .oneOf({1, 2, 4, 8})
      .showDefault();
  addVisibilityOptions(app, content.hide, content.show);
  content.where.search_environment = true;
  cli::addSearchFolderOptions(app, content.where);
  app.addOption("--frame-times", options.frame_times,
                "write when each frame was shown and what it cost, as CSV")
      .valueName("FILE");
  const cli::Option script =
      app.addOption("--script", arguments.script, "drive the window from this file, then close it");
  app.addOption("--record-input", options.record_input,
                "write what mouse and keyboard do here, as a script that does it again")
      .valueName("FILE")
      .excludes(script);
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<Exit> {
    if (arguments.leftovers || arguments.forget_leftovers) return lookAtLeftovers(arguments);
    // Before the first thread; Mesa reads the environment when the first context is made.
    if (arguments.profile == "reproducible") {
      pinRendererEnvironment();
    } else {
      avoidShaderCacheOnFullDisk();
    }
    cli::catchStopSignals();
    const cli::StopDeadline until_stopped("stopped");
    arguments.is_live = live.given();
    orderCellAndLog(content.cell, content.log);
    const bool is_recording = isLog(content.cell) || isForeignRecording(content.cell);
    if (content.log.empty() && !arguments.is_live && is_recording) {
      content.log = content.cell;
    }
    return view(arguments);
  });
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) { return rocinante::viewMain(argc, argv); }
