#pragma once

#include <pthread.h>
#include <signal.h>

#include <thread>
#include <utility>

namespace rocinante {

/// A thread that blocks all signals, leaving them to the caller's thread. `name` has at most 15
/// characters.
template <class Body>
std::thread threadWithoutSignals(const char* name, Body body) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(body));
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::pthread_setname_np(thread.native_handle(), name);
  return thread;
}

}  // namespace rocinante
