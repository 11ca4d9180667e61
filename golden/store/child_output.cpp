#include "golden/store/child_output.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "core/base/child_process.h"

namespace rocinante {

Result<ChildOutput> childOutput(const std::vector<std::string>& words, std::uint64_t most_bytes) {
  auto child =
      ChildProcess::start(words, {.ours = ChildProcess::Ours::output, .last_signal = SIGKILL});
  if (!child) {
    return Error{child.error().kind, "cannot run it: " + child.error().what, words.front()};
  }
  ChildOutput output;
  std::array<char, 1 << 16> part;
  constexpr int kLook_ms = 100;  // at what it writes to its standard error
  for (bool open = true; open;) {
    pollfd stream{child->stream(), POLLIN, 0};
    if (::poll(&stream, 1, kLook_ms) > 0) {
      const ssize_t got = ::read(child->stream(), part.data(), part.size());
      if (got < 0 && errno == EINTR) continue;
      open = got > 0;
      if (open) output.out.append(part.data(), static_cast<std::size_t>(got));
    }
    if (output.out.size() > most_bytes || child->errorBytes() > most_bytes) {
      return Error{ErrorKind::refused, "printed more output than is accepted", words.front()};
    }
  }
  const ChildProcess::End end = child->wait();
  output.exit_code = end.by_signal ? 128 + end.code : end.code;
  output.err = child->errorOutput(most_bytes);
  return output;
}

}  // namespace rocinante
