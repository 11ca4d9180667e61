#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace rocinante {

/// For a thread that works beside the one that draws. Linux sets the priority of this thread only;
/// on failure it keeps the normal one.
inline void lowerPriority() {
  constexpr int kBackgroundNice = 10;
  static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kBackgroundNice));
}

}  // namespace rocinante
