// rocinante-view: the interactive viewer (docs/programs/view.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/base/atomic_file.h"
#include "core/bundle/attached_cell.h"
#include "core/cli/load_progress.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "viewer/ui/program/view_app.h"

namespace rocinante {
namespace {

using cli::Exit;

constexpr char kExamples[] =
    "  rocinante view examples/demo/demo.cell.toml out/demo/live.mcap\n"
    "  rocinante view session.mcap                      a log that carries its cell\n"
    "  rocinante view puma.urdf --live\n"
    "  rocinante view cell.toml --live 0.0.0.0:19960 --camera overview\n"
    "  rocinante view cell.toml session.mcap --profile reproducible --script look.txt\n";

struct Arguments {
  std::filesystem::path cell, log, script;
  std::vector<std::string> live;
  std::string profile = "fast", camera, at, size = "1280x720", detail = "auto";
  std::vector<std::string> styles;
  double target_fps = 30;
  std::vector<std::string> hide, show;
  ModelSearch where;
  bool is_live = false;
  int samples = 4;
  std::optional<double> scale;
};

Result<std::optional<LiveFeed>> openFeed(const Arguments& arguments) {
  if (!arguments.is_live) return std::optional<LiveFeed>();
  std::vector<Endpoint> endpoints;
  for (const std::string& text : arguments.live) {
    if (text.empty()) continue;
    auto endpoint = Endpoint::parse(text);
    if (!endpoint.ok()) return endpoint.error();
    endpoints.push_back(*endpoint);
  }
  if (endpoints.empty()) endpoints.push_back(Endpoint::standard());
  auto feed = LiveFeed::start(endpoints);
  if (!feed.ok()) return feed.error();
  return std::optional<LiveFeed>(std::move(*feed));
}

Result<ViewOptions> viewOptions(const Arguments& arguments) {
  ViewOptions options;
  char end = 0;
  if (std::sscanf(arguments.size.c_str(), "%dx%d%c", &options.width, &options.height, &end) != 2 ||
      options.width < 64 || options.height < 64 || options.width > 8192 || options.height > 8192) {
    return Error{ErrorKind::bad_argument, "the size must be WIDTHxHEIGHT, each from 64 to 8192",
                 "--size " + arguments.size};
  }
  options.samples = arguments.samples;
  options.scale = arguments.scale;
  options.target_fps = arguments.target_fps;
  options.cell = arguments.cell;
  options.log = arguments.log;
  options.where = arguments.where;
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
    const auto text = readFile(arguments.script, 1U << 20U);
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

void warnOfFaults(const Cell& cell) {
  std::size_t errors = 0;
  for (const ModelFault& fault : cell.faults) {
    if (fault.severity != Severity::error) continue;
    if (++errors <= 3) cli::warn(fault.print());
  }
  if (errors > 3) {
    cli::warn(fmt::format("{} errors in all; rocinante check lists them", errors));
  }
}

Result<Exit> view(const Arguments& arguments) {
  const auto options = viewOptions(arguments);
  if (!options.ok()) return options.error();
  if (arguments.is_live && !arguments.log.empty()) {
    return Error{ErrorKind::bad_argument, "a log and --live cannot be used together", ""};
  }
  CellOptions cell_options;
  static_cast<ModelSearch&>(cell_options) = arguments.where;
  cell_options.parallel = cli::workerThreads();
  cell_options.progress = cli::loadProgress(arguments.cell.string());
  auto cell = loadCellOrLog(arguments.cell, cell_options);
  if (!cell.ok()) return cell.error();
  warnOfFaults(*cell);

  std::optional<Timeline> session;
  if (!arguments.log.empty()) {
    auto opened = Timeline::open(arguments.log);
    if (!opened.ok()) return opened.error();
    session = std::move(*opened);
  }
  auto feed = openFeed(arguments);
  if (!feed.ok()) return feed.error();
  auto model = ViewModel::make(std::move(*cell), std::move(session), std::move(*feed),
                               arguments.hide, arguments.show);
  if (!model.ok()) return model.error();
  RenderStyle style;
  for (const std::string& word : arguments.styles) {
    if (auto set = setStyle(style, word); !set) return set.error();
  }
  if (auto known = model->names().check(style); !known) return known.error();
  model->setStyle(style);
  for (const auto* paths : {&arguments.hide, &arguments.show}) {
    for (const std::string& path : *paths) {
      const std::string doubt = model->names().doubtAbout(path);
      if (!doubt.empty()) cli::warn(doubt);
    }
  }
  if (!arguments.camera.empty()) {
    if (auto known = model->names().checkCamera(arguments.camera); !known) return known.error();
    model->useCamera(arguments.camera);
  }
  if (!arguments.at.empty()) {
    TimelineCursor* cursor = model->cursor();
    if (cursor == nullptr) {
      return Error{ErrorKind::bad_argument, "--at needs a log", "--at " + arguments.at};
    }
    const auto moment = parseSessionTime(arguments.at, model->origin(), cursor->end());
    if (!moment.ok()) return moment.error();
    cursor->seek(*moment, SteadyTime{});
  }
  if (auto shown = runViewer(*model, *options); !shown) return shown.error();
  if (!model->seenDamage().empty()) {
    cli::warn(model->seenDamage().what() + "; what was shown may be older than its time says (" +
              model->seenDamage().where() + ")");
  }
  for (const std::string& doubt : model->doubts) cli::warn(doubt);
  return model->seenDamage().empty() && model->doubts.empty() ? Exit::done : Exit::no;
}

int viewMain(int argc, char** argv) {
  CLI::App app("Shows a cell at rest, in a recorded session or live.", "rocinante-view");
  Arguments arguments;
  app.add_option("CELL", arguments.cell,
                 "a *.cell.toml, a .urdf, an .obj or a log that carries its cell")
      ->required();
  app.add_option("LOG", arguments.log, "a recorded session");
  auto* live = app.add_option("--live", arguments.live,
                              "show live packets; EP as in `rocinante record`, default: the "
                              "standard group")
                   ->expected(0, 1);
  app.add_option("--profile", arguments.profile,
                 "fast: the driver as it is; reproducible: the same bits everywhere")
      ->check(CLI::IsMember({"fast", "reproducible"}))
      ->capture_default_str();
  app.add_option("--camera", arguments.camera, "a camera of the cell or a view of the session");
  app.add_option("--at", arguments.at, "start at this session time");
  app.add_option("--size", arguments.size, "size of the window, WIDTHxHEIGHT")
      ->capture_default_str();
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
  app.add_option("--script", arguments.script, "drive the window from this file, then close it");
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<Exit> {
    cli::catchStopSignals();
    const cli::StopDeadline until_stopped("stopped");
    arguments.is_live = live->count() > 0;
    if (arguments.log.empty() && !arguments.is_live && isLog(arguments.cell)) {
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
  if (rocinante::wantsReproducible(argc, argv)) rocinante::pinRendererEnvironment();
  return rocinante::viewMain(argc, argv);
}
