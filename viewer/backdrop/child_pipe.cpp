#include "viewer/backdrop/child_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace rocinante {
namespace {

constexpr int kLookEvery_ms = 100;
constexpr int kLongestSilence_ms = 30'000;
constexpr std::size_t kMaxErrorBytes = 1000;

}  // namespace

Result<ChildPipe> ChildPipe::start(const std::vector<std::string>& words) {
  // Its own process group, so that only we handle Ctrl-C.
  auto child = ChildProcess::start(
      words, {.ours = ChildProcess::Ours::output, .own_group = true, .last_signal = SIGKILL});
  if (!child) return child.error();
  return ChildPipe(std::move(*child));
}

Result<std::size_t> ChildPipe::read(std::span<std::uint8_t> into,
                                    const std::function<bool()>& stopped) {
  std::size_t done = 0;
  int silent_ms = 0;
  while (done < into.size()) {
    pollfd ready{child_.stream(), POLLIN, 0};
    const int news = ::poll(&ready, 1, kLookEvery_ms);
    if (stopped && stopped()) return Error{ErrorKind::refused, "stopped", {}};
    if (news == 0 && (silent_ms += kLookEvery_ms) >= kLongestSilence_ms) {
      return Error{ErrorKind::refused, "no output for 30 s", {}};
    }
    if (news <= 0) continue;
    const ssize_t got = ::read(child_.stream(), into.data() + done, into.size() - done);
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Error{ErrorKind::refused, std::strerror(errno), {}};
    silent_ms = 0;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

Status ChildPipe::ended() {
  child_.closeStream();
  const ChildProcess::End end = child_.wait();
  if (end.ok()) return {};
  const std::string why = onOneLine(child_.errorOutput(kMaxErrorBytes));
  return Error{ErrorKind::refused, why.empty() ? end.text() : end.text() + ": " + why, {}};
}

}  // namespace rocinante
