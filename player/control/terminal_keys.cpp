#include "player/control/terminal_keys.h"

#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "player/send/send_progress.h"

namespace rocinante {
namespace {

constexpr int kKeyboard = STDIN_FILENO;

struct Key {
  std::string_view typed, command;
};
constexpr Key kKeys[] = {
    {" ", "toggle"},       {"\x1b[C", "step 1"}, {"\x1b[D", "back 1"}, {"\x1b[A", "step 1s"},
    {"\x1b[B", "back 1s"}, {"\x1bOC", "step 1"}, {"\x1bOD", "back 1"}, {"\x1bOA", "step 1s"},
    {"\x1bOB", "back 1s"}, {"+", "faster"},      {"=", "faster"},      {"-", "slower"},
    {"n", "next"},         {"p", "previous"},    {"q", "quit"},
};

// Read by signal handlers, so written only while they are not installed.
termios former_mode;
termios key_mode;
std::atomic<bool> in_key_mode{false};
static_assert(std::atomic<bool>::is_always_lock_free, "read by a signal handler");

/// Signals that end the program at once, or may.
constexpr std::array kEnding = {SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
constexpr std::array kStopping = {SIGINT, SIGTERM};
std::array<struct sigaction, kEnding.size()> former_ending;
std::array<struct sigaction, kStopping.size()> former_stopping;
struct sigaction former_suspend, former_resume;
std::atomic<int> stops{0};

void restoreMode() {
  if (in_key_mode.load()) ::tcsetattr(kKeyboard, TCSANOW, &former_mode);
}

bool isForeground() { return ::tcgetpgrp(kKeyboard) == ::getpgrp(); }

void onEnding(int number) {
  restoreMode();
  ::signal(number, SIG_DFL);
  ::raise(number);
}

/// The program handles the first signal itself; the second ends it.
void onStopping(int number) {
  const int saved = errno;
  if (stops.fetch_add(1) > 0) {
    restoreMode();
    ::signal(number, SIG_DFL);
    ::raise(number);
  } else {
    const auto& former = former_stopping[number == SIGINT ? 0 : 1];
    if (former.sa_handler != SIG_DFL && former.sa_handler != SIG_IGN) former.sa_handler(number);
    // The program's handler restored the default, which would not restore the terminal.
    struct sigaction again {};
    again.sa_handler = onStopping;
    ::sigaction(number, &again, nullptr);
  }
  errno = saved;
}

void onSuspend(int) {
  const int saved = errno;
  restoreMode();
  ::raise(SIGSTOP);
  errno = saved;
}

void onResume(int) {
  const int saved = errno;
  noteResume();
  if (in_key_mode.load() && isForeground()) ::tcsetattr(kKeyboard, TCSANOW, &key_mode);
  errno = saved;
}

void handle(int number, void (*handler)(int), struct sigaction* former) {
  struct sigaction action {};
  action.sa_handler = handler;
  ::sigaction(number, &action, former);
}

}  // namespace

std::string_view KeyReader::take(char key) {
  if (sequence_.empty() && key != '\x1b')
    sequence_ = key;
  else if (key == '\x1b')
    sequence_ = key;  // the previous bytes are not a known sequence
  else
    sequence_ += key;
  bool may_go_on = false;
  for (const Key& each : kKeys) {
    if (each.typed == sequence_) {
      sequence_.clear();
      return each.command;
    }
    may_go_on = may_go_on || each.typed.starts_with(sequence_);
  }
  // Skip the rest of a longer sequence (a function key) up to its final letter.
  const bool is_long = sequence_.size() > 2 && sequence_.size() < 16 && sequence_[1] == '[' &&
                       (key < '@' || key > '~');
  if (!may_go_on && !is_long) sequence_.clear();
  return {};
}

void restoreTerminal() { restoreMode(); }

std::unique_ptr<TerminalKeys> TerminalKeys::open() {
  // Changing the terminal from the background would stop the program.
  if (::isatty(kKeyboard) != 1 || !isForeground()) return nullptr;
  if (::tcgetattr(kKeyboard, &former_mode) != 0) return nullptr;
  key_mode = former_mode;
  // ISIG stays set: Ctrl-C still sends its signal.
  key_mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  key_mode.c_cc[VMIN] = 0;
  key_mode.c_cc[VTIME] = 0;
  in_key_mode.store(true);
  for (std::size_t i = 0; i < kEnding.size(); ++i) handle(kEnding[i], onEnding, &former_ending[i]);
  for (std::size_t i = 0; i < kStopping.size(); ++i) {
    handle(kStopping[i], onStopping, &former_stopping[i]);
  }
  handle(SIGTSTP, onSuspend, &former_suspend);
  handle(SIGCONT, onResume, &former_resume);
  ::tcsetattr(kKeyboard, TCSANOW, &key_mode);
  return std::unique_ptr<TerminalKeys>(new TerminalKeys());
}

TerminalKeys::~TerminalKeys() {
  if (isForeground()) restoreMode();
  in_key_mode.store(false);
  for (std::size_t i = 0; i < kEnding.size(); ++i) {
    ::sigaction(kEnding[i], &former_ending[i], nullptr);
  }
  // After a first Ctrl-C the next one still ends the program.
  for (std::size_t i = 0; i < kStopping.size(); ++i) {
    if (stops.load() == 0) ::sigaction(kStopping[i], &former_stopping[i], nullptr);
  }
  ::sigaction(SIGTSTP, &former_suspend, nullptr);
  ::sigaction(SIGCONT, &former_resume, nullptr);
}

void TerminalKeys::addDescriptors(std::vector<pollfd>& descriptors) const {
  if (!over_) descriptors.push_back({kKeyboard, POLLIN, 0});
}

void TerminalKeys::serve(const Ask& ask) {
  pollfd ready{kKeyboard, POLLIN, 0};
  if (over_ || ::poll(&ready, 1, 0) != 1) return;
  std::array<char, 64> typed;
  const ssize_t size = isForeground() ? ::read(kKeyboard, typed.data(), typed.size()) : -1;
  over_ = size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR);
  for (ssize_t i = 0; i < size; ++i) {
    const std::string_view command = reader_.take(typed[static_cast<std::size_t>(i)]);
    if (command.empty()) continue;
    const std::string answer = ask(std::string(command));
    // The progress line shows the status anyway.
    if (answer.starts_with("error ")) tell(answer.substr(6));
  }
}

void TerminalKeys::tell(const std::string& line) {
  const std::string text = "\r" + line + "\033[K\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace rocinante
