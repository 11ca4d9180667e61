#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/cli/program.h"
#include "viewer/render/render_job.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante render cell.toml session.mcap --at 12.5s -o frame.png\n"
    "  rocinante render session.mcap --at 12.5s -o frame.png   a log that carries its cell\n"
    "  rocinante render panda.urdf -o panda.png --size 1280x720\n"
    "  rocinante render cell.toml session.mcap --at 1 --at 2.5 --at -1s --sheet sheet.png\n"
    "  rocinante render cell.toml session.mcap --every 0.04s --frames frames/\n"
    "  rocinante render cell.toml session.mcap --at 12.5s --hash\n"
    "  rocinante render cell.toml session.mcap --at 3 --hide layer/labels --camera side -o f.png\n";

/// How many faults are shown before the rest is only counted.
constexpr std::size_t kWarningsShown = 5;

void printWarnings(const RenderReport& report) {
  for (std::size_t i = 0; i < report.warnings.size() && i < kWarningsShown; ++i) {
    cli::warn(report.warnings[i]);
  }
  if (report.warnings.size() > kWarningsShown) {
    cli::warn("... and " + std::to_string(report.warnings.size() - kWarningsShown) +
              " more faults of the model (rocinante check lists all)");
  }
}

void printJson(const RenderReport& report) {
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["renderer"] = report.key.text();
  json["inputs"] = report.inputs;
  json["frames"] = nlohmann::ordered_json::array();
  for (const RenderedFrame& frame : report.frames) {
    nlohmann::ordered_json one;
    one["time"] = frame.time;
    one["log_time_ns"] = frame.log_time.time_since_epoch().count();
    one["sha256"] = frame.sha256;
    if (!frame.file.empty()) one["file"] = frame.file.string();
    json["frames"].push_back(std::move(one));
  }
  json["warnings"] = report.warnings;
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void printHashes(const RenderReport& report) {
  for (const RenderedFrame& frame : report.frames) {
    if (report.frames.size() == 1) {
      std::printf("%s\n", frame.sha256.c_str());
    } else {
      std::printf("%s %s\n", frame.time.c_str(), frame.sha256.c_str());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws frames of a cell and a session without a window.", "rocinante-render");
  RenderJob job;
  std::string size = "640x480";
  std::string caps = "sse4.1";
  std::string profile = "reproducible";
  bool hash = false;
  bool json = false;
  app.add_option("cell", job.cell,
                 "A .cell.toml, a bare .urdf or .obj, or a log that carries its cell")
      ->required();
  app.add_option("log", job.log, "The session; without one, the cell at rest");
  app.add_option("--at", job.at,
                 "A moment: 12.5, 1m02.5s, -1s from the end, or RFC 3339; repeatable")
      ->allow_extra_args(false);
  app.add_option("--every", job.every, "Every so often, from the log's start to its end");
  app.add_option("-o,--output", job.output, "One frame, as PNG");
  app.add_option("--sheet", job.sheet, "All moments on one PNG, their times below");
  app.add_option("--frames", job.frames, "A folder for frame-00001.png and on");
  app.add_option("--camera", job.look.camera, "Of the cell, or a `view` of the session")
      ->option_text("NAME");
  app.add_option("--size", size, "Pixels")->capture_default_str();
  app.add_option("--samples", job.look.samples, "A pixel: 1 or 4")->capture_default_str();
  app.add_option("--hide", job.look.hide,
                 "PATH not to draw: DEVICE, DEVICE/LINK, layer/NAME; repeatable")
      ->allow_extra_args(false);
  app.add_option("--show", job.look.show, "PATH to draw whatever packets say; repeatable")
      ->allow_extra_args(false);
  app.add_option("--profile", profile, "reproducible: the same bits everywhere; fast: any GPU")
      ->check(CLI::IsMember({"reproducible", "fast"}))
      ->capture_default_str();
  app.add_option("--caps", caps, "What the reproducible profile pins the processor to")
      ->check(CLI::IsMember({"sse4.1", "sse2"}))
      ->capture_default_str();
  app.add_option("--search", job.search, "A folder in which models are looked for; repeatable")
      ->allow_extra_args(false);
  app.add_flag("--search-env", job.search_environment,
               "Also in ROCINANTE_PATH, AMENT_PREFIX_PATH, ROS_PACKAGE_PATH");
  app.add_flag("--hash", hash, "Print the SHA-256 of the RGBA rows, top to bottom, a line a frame");
  app.add_flag("--force", job.overwrite, "Replace existing files");
  app.add_flag("--json", json, "Print a report as JSON");

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    // Mesa reads its environment when the first context is made.
    job.profile = profile == "fast" ? Profile::fast : Profile::reproducible;
    if (job.profile == Profile::reproducible) pinRendererEnvironment(caps);
    const auto pixels = parseSize(size);
    if (!pixels) return pixels.error();
    std::tie(job.look.width, job.look.height) = *pixels;
    if (job.output.empty() && job.sheet.empty() && job.frames.empty() && !hash && !json) {
      return Error{ErrorKind::bad_argument,
                   "nothing to make: -o FILE, --sheet FILE, --frames DIR, --hash or --json",
                   {}};
    }
    cli::catchStopSignals();
    const bool bar = ::isatty(STDERR_FILENO) == 1;
    const auto report = render(job, [&](std::size_t done, std::size_t of) {
      if (bar && of > 1) {
        std::fprintf(stderr, "\rframe %zu of %zu%s", done, of, done == of ? "\n" : "");
      }
      return !cli::stopRequested();
    });
    if (!report) return report.error();
    printWarnings(*report);
    if (json) {
      printJson(*report);
    } else if (hash) {
      printHashes(*report);
    }
    return cli::Exit::done;
  });
}
