// Any bytes as a script of the window, with what mouse and keyboard do there. What it makes of them
// must be writable as a script again.

#include <cstdlib>

#include "viewer/ui/commands/command.h"
#include "viewer/ui/program/input_record.h"
#include "viewer/ui/program/view_content.h"
#include "viewer/ui/program/view_script.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto script = parseViewScript({reinterpret_cast<const char*>(data), size}, "fuzz.script");
  if (!script.ok()) {
    require(script.error().where.starts_with("fuzz.script:"));
    return 0;
  }
  static ViewContent empty = emptyContent();
  FrameInput input;
  for (const ViewCommand& command : *script) {
    if (findCommand(command.name)->group != CommandGroup::script) continue;
    ViewerRequests requests;
    const Status done =
        runCommand(command.name, command.words, {*empty.model, {}, 1, requests, &input});
    require(done.ok() || !done.error().what.empty());
  }
  require(parseViewScript(inputLines({}, input), "again").ok());
  return 0;
}
