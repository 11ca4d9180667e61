// rocinante-self-test-draw: the part of `rocinante --self-test` that draws. A separate program, so
// that `--self-test` also works on a machine without it.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/program.h"
#include "golden/self_test/drawing_facts.h"
#include "viewer/gl/context_option.h"
#include "viewer/gl/renderer_key.h"

namespace {

constexpr std::string_view kExamples =
    "  rocinante --self-test                      reports this part with the others\n"
    "  rocinante self-test draw -o frame.png      keeps the drawn frame\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace rocinante;
  cli::Program app("Draws a small built-in frame and prints facts as one line of JSON.",
                   "rocinante-self-test-draw");
  std::vector<std::string> only;
  std::filesystem::path output;
  app.addOption("--only", only, "context, key, frame, cache, pictures; default: all of them")
      .valueName("FACT,...")
      .separatedBy(',')
      .oneEach();
  app.addOption("-o,--output", output, "write the frame as PNG").valueName("FILE");
  addContextOption(app);
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    const auto wanted = [&](const char* name) {
      return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
    };
    std::vector<SelfTestFact> facts;
    Picture drawn;
    if (wanted("context") || wanted("key") || wanted("frame")) {
      // Mesa reads the environment when the first context is made.
      pinRendererEnvironment();
      facts = drawingFacts(&drawn);
    }
    if (wanted("cache")) facts.push_back(cacheFact());
    if (wanted("pictures")) facts.push_back(picturesFact());
    cli::say(factsWire(facts) + "\n");
    if (output.empty()) return cli::Exit::done;
    if (drawn.rgba.empty()) return Error{ErrorKind::refused, "no frame was drawn", output.string()};
    if (Status written = writePng(output, drawn); !written) return written.error();
    return cli::Exit::done;
  });
}
