#include "core/base/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace rocinante {

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

}  // namespace rocinante
