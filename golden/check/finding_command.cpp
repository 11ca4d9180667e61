#include "golden/check/finding_command.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "core/base/child_process.h"
#include "core/cli/program.h"

namespace rocinante {
namespace {

constexpr int kLookEveryMs = 10;

bool isProgram(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

/// As execvp() looks for it.
bool isFound(const std::string& program) {
  if (program.find('/') != program.npos) return isProgram(program);
  const char* const variable = std::getenv("PATH");
  std::istringstream folders(variable == nullptr ? "/bin:/usr/bin" : variable);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (isProgram(std::filesystem::path(folder.empty() ? "." : folder) / program)) return true;
  }
  return false;
}

Error systemError(const char* what) { return {ErrorKind::refused, std::strerror(errno), what}; }

/// A file in memory that is read from its beginning.
Result<int> memoryFile(const std::string& text) {
  const int file = ::memfd_create("finding", MFD_CLOEXEC);
  if (file < 0) return systemError("memfd_create");
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if (written <= 0) {
      const Error error = systemError("memfd");
      ::close(file);
      return error;
    }
    done += static_cast<std::size_t>(written);
  }
  ::lseek(file, 0, SEEK_SET);
  return file;
}

std::string howItEnded(int status) {
  if (WIFEXITED(status)) return fmt::format("exited with {}", WEXITSTATUS(status));
  return fmt::format("was ended by signal {}", WTERMSIG(status));
}

}  // namespace

Result<FindingCommand> FindingCommand::parse(std::string_view text) {
  FindingCommand command;
  command.text_ = text;
  std::istringstream words(command.text_);
  for (std::string word; words >> word;) command.words_.push_back(word);
  if (command.words_.empty()) {
    return Error{ErrorKind::bad_argument, "must be a program and its arguments", "--on-finding"};
  }
  if (!isFound(command.words_[0])) {
    return Error{ErrorKind::not_found, "there is no such program", command.words_[0]};
  }
  return command;
}

void FindingCommand::add(std::string json) {
  if (waiting_.size() >= kWaiting) {
    ++dropped_;
    return;
  }
  waiting_.push_back(std::move(json));
  tend();
}

void FindingCommand::tend() {
  std::erase_if(running_, [&](pid_t child) {
    int status = 0;
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == 0) return false;
    if (ended == child && status != 0) noteFailure(howItEnded(status));
    return true;
  });
  while (!waiting_.empty() && running_.size() < kRunning) {
    if (Status started = start(waiting_.front()); !started) noteFailure(started.error().text());
    waiting_.pop_front();
  }
}

void FindingCommand::finish(int at_most_ms) {
  tend();
  for (int waited = 0; !isIdle() && waited < at_most_ms; waited += kLookEveryMs) {
    ::poll(nullptr, 0, kLookEveryMs);
    tend();
  }
  dropped_ += waiting_.size();
}

Status FindingCommand::start(const std::string& json) {
  const Result<int> input = memoryFile(json);
  if (!input) return input.error();
  // In a group of its own: Ctrl-C ends the watch, not what it started.
  const Result<pid_t> child = startChild(words_, {*input, STDERR_FILENO, STDERR_FILENO}, true);
  ::close(*input);
  if (!child) return child.error();
  running_.push_back(*child);
  return {};
}

void FindingCommand::noteFailure(const std::string& how) {
  // Said once: a command that fails does so for every finding.
  if (++failed_ == 1) cli::warn(fmt::format("--on-finding: {} {}", text_, how));
}

}  // namespace rocinante
