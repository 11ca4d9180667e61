#include "golden/store/child_output.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/child_process.h"

namespace rocinante {
namespace {

/// Both ends of a pipe, closed on destruction.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() = default;
  ~Pipe() {
    closeEnd(0);
    closeEnd(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  bool open() { return ::pipe2(ends.data(), O_CLOEXEC) == 0; }
  void closeEnd(std::size_t end) {
    if (ends[end] >= 0) ::close(std::exchange(ends[end], -1));
  }
};

int waitFor(::pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// Appends available output to `text`; false at the end.
bool readSome(int pipe, std::string& text) {
  std::array<char, 1 << 16> buffer;
  const ssize_t got = ::read(pipe, buffer.data(), buffer.size());
  if (got < 0) return errno == EINTR;
  text.append(buffer.data(), static_cast<std::size_t>(got));
  return got > 0;
}

}  // namespace

Result<ChildOutput> childOutput(const std::vector<std::string>& words, std::uint64_t most_bytes) {
  Pipe out;
  Pipe err;
  if (!out.open() || !err.open()) {
    return Error{ErrorKind::refused, std::string("cannot run it: ") + std::strerror(errno),
                 words.front()};
  }
  const Result<pid_t> started = startChild(words, {-1, out.ends[1], err.ends[1]});
  if (!started) {
    return Error{started.error().kind, "cannot run it: " + started.error().what, words.front()};
  }
  const pid_t pid = *started;
  out.closeEnd(1);
  err.closeEnd(1);

  ChildOutput output;
  while (out.ends[0] >= 0 || err.ends[0] >= 0) {
    std::array<::pollfd, 2> waiting{{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
    if (::poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) break;
    if (waiting[0].revents != 0 && !readSome(out.ends[0], output.out)) out.closeEnd(0);
    if (waiting[1].revents != 0 && !readSome(err.ends[0], output.err)) err.closeEnd(0);
    if (output.out.size() + output.err.size() > most_bytes) {
      ::kill(pid, SIGKILL);
      waitFor(pid);
      return Error{ErrorKind::refused, "printed more output than is accepted", words.front()};
    }
  }
  output.exit_code = waitFor(pid);
  return output;
}

}  // namespace rocinante
