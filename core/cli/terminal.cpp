#include "core/cli/terminal.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>

namespace rocinante::cli {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

/// The locale as setlocale() would choose it, without changing how this process reads numbers.
bool localeIsUtf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const std::string_view locale = variable(name);
    if (locale.empty()) continue;
    for (const std::string_view ending : {"UTF-8", "utf-8", "utf8", "UTF8"}) {
      if (locale.find(ending) != locale.npos) return true;
    }
    return false;
  }
  return false;
}

}  // namespace

void fillClosedStandardStreams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // open() takes the lowest free number: this one. No O_CLOEXEC: child processes need it too.
    ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

OutputTerminal outputTerminal() {
  OutputTerminal terminal;
  terminal.is_terminal = ::isatty(STDOUT_FILENO) == 1;
  if (!terminal.is_terminal) return terminal;
  const std::string_view kind = variable("TERM");
  terminal.color = variable("NO_COLOR").empty() && !kind.empty() && kind != "dumb";
  terminal.unicode = localeIsUtf8();
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) terminal.columns = size.ws_col;
  return terminal;
}

}  // namespace rocinante::cli
