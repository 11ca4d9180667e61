#include "viewer/backdrop/child_pipe.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace rocinante {
namespace {

constexpr int kLookEvery_ms = 100;
constexpr int kLongestSilence_ms = 30'000;
constexpr std::size_t kMaxSaid = 1000;

}  // namespace

Result<ChildPipe> ChildPipe::start(const std::vector<std::string>& words) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Error{
        ErrorKind::refused, std::string("cannot create a pipe: ") + std::strerror(errno), {}};
  }
  // Its own process group, so that only we handle Ctrl-C.
  Result<ChildProcess> child =
      ChildProcess::start(words, {.out = ends[1], .own_group = true, .last_signal = SIGKILL});
  ::close(ends[1]);
  if (!child) {
    ::close(ends[0]);
    return child.error();
  }
  return ChildPipe(std::move(*child), ends[0]);
}

ChildPipe::ChildPipe(ChildPipe&& other) noexcept
    : child_(std::move(other.child_)), output_(std::exchange(other.output_, -1)) {}

ChildPipe& ChildPipe::operator=(ChildPipe&& other) noexcept {
  if (this == &other) return *this;
  closeOutput();
  child_ = std::move(other.child_);
  output_ = std::exchange(other.output_, -1);
  return *this;
}

ChildPipe::~ChildPipe() { closeOutput(); }

void ChildPipe::closeOutput() {
  if (output_ >= 0) ::close(std::exchange(output_, -1));
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
  closeOutput();
  const ChildProcess::End end = child_.wait();
  if (end.ok()) return {};
  const std::string why = onOneLine(child_.said(kMaxSaid));
  return Error{ErrorKind::refused, why.empty() ? end.text() : end.text() + ": " + why, {}};
}

}  // namespace rocinante
