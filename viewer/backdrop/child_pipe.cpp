#include "viewer/backdrop/child_pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/child_process.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr int kLookEvery_ms = 100;
constexpr int kLongestSilence_ms = 30'000;
constexpr std::size_t kMaxWords = 1000;

std::string lineOf(int words) {
  std::array<char, kMaxWords> buffer{};
  const ssize_t got = ::pread(words, buffer.data(), buffer.size(), 0);
  std::string text(buffer.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) {
    text.replace(at, 1, "; ");
  }
  return plainText(text);
}

}  // namespace

Result<ChildPipe> ChildPipe::start(const std::vector<std::string>& words) {
  ChildPipe pipe;
  std::array<int, 2> ends{-1, -1};
  pipe.words_ = ::memfd_create("words", MFD_CLOEXEC);
  if (pipe.words_ < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Error{
        ErrorKind::refused, std::string("cannot create a pipe: ") + std::strerror(errno), {}};
  }
  pipe.output_ = ends[0];
  // Its own process group, so that only we handle Ctrl-C.
  const Result<pid_t> child = startChild(words, {-1, ends[1], pipe.words_}, true);
  ::close(ends[1]);
  if (!child) return child.error();
  pipe.child_ = *child;
  return pipe;
}

ChildPipe::ChildPipe(ChildPipe&& other) noexcept
    : child_(std::exchange(other.child_, -1)),
      output_(std::exchange(other.output_, -1)),
      words_(std::exchange(other.words_, -1)) {}

ChildPipe& ChildPipe::operator=(ChildPipe&& other) noexcept {
  if (this == &other) return *this;
  stop();
  child_ = std::exchange(other.child_, -1);
  output_ = std::exchange(other.output_, -1);
  words_ = std::exchange(other.words_, -1);
  return *this;
}

ChildPipe::~ChildPipe() { stop(); }

void ChildPipe::stop() {
  if (output_ >= 0) ::close(std::exchange(output_, -1));
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
  }
  if (words_ >= 0) ::close(std::exchange(words_, -1));
}

Result<std::size_t> ChildPipe::read(std::span<std::uint8_t> into,
                                    const std::function<bool()>& stopped) {
  std::size_t done = 0;
  int silent_ms = 0;
  while (done < into.size()) {
    pollfd ready{output_, POLLIN, 0};
    const int news = ::poll(&ready, 1, kLookEvery_ms);
    if (stopped && stopped()) return Error{ErrorKind::refused, "stopped", {}};
    if (news == 0 && (silent_ms += kLookEvery_ms) >= kLongestSilence_ms) {
      return Error{ErrorKind::refused, "it says nothing for half a minute", {}};
    }
    if (news <= 0) continue;
    const ssize_t got = ::read(output_, into.data() + done, into.size() - done);
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Error{ErrorKind::refused, std::strerror(errno), {}};
    silent_ms = 0;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

Status ChildPipe::ended() {
  if (output_ >= 0) ::close(std::exchange(output_, -1));
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string why = lineOf(words_);
  const std::string how = WIFEXITED(status) ? fmt::format("exit {}", WEXITSTATUS(status))
                                            : fmt::format("signal {}", WTERMSIG(status));
  return Error{ErrorKind::refused, why.empty() ? how : how + ": " + why, {}};
}

}  // namespace rocinante
