#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace rocinante {

/// Gives way to the threads that draw or receive. Linux sets the priority of the calling thread
/// only; on failure it keeps the normal one.
inline void lowerPriority() {
  constexpr int kBackgroundNice = 10;
  static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kBackgroundNice));
}

}  // namespace rocinante
