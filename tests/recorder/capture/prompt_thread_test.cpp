#include "recorder/capture/prompt_thread.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>

#include <algorithm>
#include <thread>

namespace rocinante {
namespace {

int niceOfThisThread() { return ::getpriority(PRIO_PROCESS, 0); }

/// Uses its own thread, so that lowered limits stay there.
template <class Body>
auto onAThread(Body body) {
  decltype(body()) answer{};
  std::thread([&] { answer = body(); }).join();
  return answer;
}

TEST(PromptThread, HasMoreWeightWhereItMayAndIsTheOnlyOneThatHas) {
  const int before = niceOfThisThread();
  const bool may = onAThread([] { return ::setpriority(PRIO_PROCESS, 0, -10) == 0; });
  const int nice = onAThread([] {
    askToRunPromptly();
    return niceOfThisThread();
  });
  EXPECT_EQ(nice, may ? std::min(before, -10) : before);
  EXPECT_EQ(niceOfThisThread(), before);
}

TEST(PromptThread, LeavesAnotherPolicyAlone) {
  const int policy = onAThread([] {
    const sched_param none{};
    EXPECT_EQ(::sched_setscheduler(0, SCHED_BATCH, &none), 0);
    askToRunPromptly();
    return ::sched_getscheduler(0);
  });
  EXPECT_EQ(policy, SCHED_BATCH);
}

}  // namespace
}  // namespace rocinante
