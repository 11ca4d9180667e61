// Any bytes as a layout of the window. What is read is written as itself.

#include <cstdlib>

#include "viewer/view/view_layout.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto layout =
      ViewLayout::parse({reinterpret_cast<const char*>(data), size}, "fuzz.layout.toml");
  if (!layout.ok()) {
    require(layout.error().where.starts_with("fuzz.layout.toml"));
    return 0;
  }
  const std::string text = layout->text();
  const auto again = ViewLayout::parse(text, "again");
  require(again.ok() && again->text() == text);
  return 0;
}
