#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// What a child reads and writes: descriptors of ours, which stay ours; -1: /dev/null.
struct ChildStreams {
  int in = -1;
  int out = -1;
  int err = -1;
};

/// Starts a program: words[0], searched in PATH when it has no slash, with the other words as its
/// arguments. It gets no other descriptor of ours that is marked close-on-exec. `own_group`: in a
/// process group of its own, so that Ctrl-C reaches only us. Whoever starts it waits for it
/// (waitpid). not_found when there is no such program, else refused; the sentence is the system's.
Result<pid_t> startChild(const std::vector<std::string>& words, const ChildStreams& streams,
                         bool own_group = false);

}  // namespace rocinante
