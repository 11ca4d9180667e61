#include "core/cli/status_line.h"

#include <unistd.h>

#include <string>

#include "core/cli/program.h"

namespace rocinante::cli {
namespace {

constexpr std::string_view kErase = "\r\033[K";

}  // namespace

StatusLine::StatusLine(bool visible) : visible_(visible && ::isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() { clear(); }

void StatusLine::show(std::string_view text) {
  if (!visible_) return;
  shown_ = true;
  // Erased first: erasing at the end of a cut line would delete its last character.
  tell(std::string(kErase) + "\033[?7l" + std::string(text) + "\033[?7h");
}

void StatusLine::clear() {
  if (shown_) tell(kErase);
  shown_ = false;
}

}  // namespace rocinante::cli
