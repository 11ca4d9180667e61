#include "core/base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// A file in memory that is read from its beginning.
Result<int> memoryFile(std::string_view text) {
  const auto refusal = [] { return Error{ErrorKind::refused, std::strerror(errno), "memory"}; };
  const int file = ::memfd_create("stream", MFD_CLOEXEC);
  if (file < 0) return refusal();
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written <= 0) {
      const Error error = refusal();
      ::close(file);
      return error;
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  ::lseek(file, 0, SEEK_SET);
  return file;
}

/// Empty while the child runs, which `options` of waitpid() may allow.
std::optional<ChildEnd> endOfChild(pid_t child, int options) {
  int status = 0;
  pid_t ended = 0;
  do {
    ended = ::waitpid(child, &status, options);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return std::nullopt;
  if (ended < 0) return ChildEnd{false, 255};  // somebody else has waited for it
  if (WIFSIGNALED(status)) return ChildEnd{true, WTERMSIG(status)};
  return ChildEnd{false, WEXITSTATUS(status)};
}

}  // namespace

ChildEnd waitForChild(pid_t child) { return *endOfChild(child, 0); }

Result<pid_t> startChild(const std::vector<std::string>& words, const ChildStreams& streams,
                         bool own_group) {
  std::vector<char*> arguments;
  // The call takes them as char* for C's sake, and does not change them.
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  const auto give = [&](int ours, int theirs, int flags) {
    if (ours < 0) {
      ::posix_spawn_file_actions_addopen(&actions, theirs, "/dev/null", flags, 0);
    } else {
      ::posix_spawn_file_actions_adddup2(&actions, ours, theirs);
    }
  };
  give(streams.in, STDIN_FILENO, O_RDONLY);
  give(streams.out, STDOUT_FILENO, O_WRONLY);
  give(streams.err, STDERR_FILENO, O_WRONLY);
  if (own_group) {
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    ::posix_spawnattr_setpgroup(&attributes, 0);
  }
  pid_t child = -1;
  const int fault =
      ::posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (fault == 0) return child;
  return Error{fault == ENOENT ? ErrorKind::not_found : ErrorKind::refused, std::strerror(fault),
               words.front()};
}

std::string ChildEnd::text() const {
  return fmt::format("{} {}", by_signal ? "signal" : "exit", code);
}

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& words,
                                         const Options& options) {
  ChildProcess made;
  made.last_signal_ = options.last_signal;
  if (!options.err) {
    const Result<int> file = memoryFile({});
    if (!file) return file.error();
    made.error_output_ = *file;
  }
  std::array<int, 2> ends{-1, -1};  // ours, and its
  if (options.input_text) {
    const Result<int> file = memoryFile(*options.input_text);
    if (!file) return file.error();
    ends[1] = *file;
  } else if (options.ours != Ours::none) {
    const int fault = options.ours == Ours::output
                          ? ::pipe2(ends.data(), O_CLOEXEC)
                          : ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data());
    if (fault != 0) return Error{ErrorKind::refused, std::strerror(errno), words.front()};
  }
  made.stream_ = ends[0];
  const bool reads_it = options.input_text || options.ours == Ours::input;
  const Result<pid_t> process = startChild(
      words,
      {reads_it ? ends[1] : options.in, options.ours == Ours::output ? ends[1] : options.out,
       options.err.value_or(made.error_output_)},
      options.own_group);
  if (ends[1] >= 0) ::close(ends[1]);
  if (!process) return process.error();
  made.process_ = *process;
  return made;
}

void ChildProcess::swap(ChildProcess& other) {
  std::swap(process_, other.process_);
  std::swap(error_output_, other.error_output_);
  std::swap(stream_, other.stream_);
  std::swap(last_signal_, other.last_signal_);
  std::swap(end_, other.end_);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept { swap(other); }

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  ChildProcess taken(std::move(other));
  swap(taken);
  return *this;
}

ChildProcess::~ChildProcess() {
  closeStream();
  if (process_ > 0 && last_signal_ != 0) {
    ::kill(process_, last_signal_);
    look(true);
  }
  if (error_output_ >= 0) ::close(error_output_);
}

void ChildProcess::closeStream() {
  if (stream_ >= 0) ::close(std::exchange(stream_, -1));
}

std::optional<ChildProcess::End> ChildProcess::look(bool wait) {
  if (process_ <= 0) return end_;
  const std::optional<End> end = endOfChild(process_, wait ? 0 : WNOHANG);
  if (!end) return std::nullopt;
  process_ = -1;
  end_ = *end;
  return end_;
}

std::uint64_t ChildProcess::errorBytes() const {
  return error_output_ < 0
             ? 0
             : static_cast<std::uint64_t>(std::max<off_t>(0, ::lseek(error_output_, 0, SEEK_END)));
}

std::string ChildProcess::errorOutput(std::size_t most_bytes) const {
  const std::uint64_t size = errorBytes();
  std::string text(std::min<std::uint64_t>(most_bytes, size), '\0');
  const ssize_t got =
      ::pread(error_output_, text.data(), text.size(), static_cast<off_t>(size - text.size()));
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

std::string programBeside(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / name;
  return fs::exists(beside, ignored) ? beside.string() : name;
}

std::string onOneLine(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
    text.replace(at, 1, "; ");
  }
  return plainText(text);
}

}  // namespace rocinante
