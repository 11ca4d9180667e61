#include "golden/check/finding_command.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>

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
  std::erase_if(running_, [&](ChildProcess& child) {
    const auto end = child.poll();
    if (end && !end->ok()) noteFailure("failed (" + end->text() + ")");
    return end.has_value();
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
  // In a group of its own: Ctrl-C ends the watch, not what it started.
  Result<ChildProcess> child = ChildProcess::start(words_, {.out = STDERR_FILENO,
                                                            .err = STDERR_FILENO,
                                                            .input_text = json,
                                                            .own_group = true,
                                                            .last_signal = 0});
  if (!child) return child.error();
  running_.push_back(std::move(*child));
  return {};
}

void FindingCommand::noteFailure(const std::string& how) {
  // Said once: a command that fails does so for every finding.
  if (++failed_ == 1) cli::warn(fmt::format("--on-finding: {} {}", text_, how));
}

}  // namespace rocinante
