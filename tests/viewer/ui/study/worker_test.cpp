#include "viewer/ui/study/worker.h"

#include <gtest/gtest.h>

#include <atomic>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(Worker, AnswersTheNewestOfWhatIsAskedMeanwhile) {
  std::atomic<bool> begun = false, goes_on = false;
  std::atomic<int> ready = 0;
  Worker<int, int> worker(
      [&, asked = 0](int question, const std::stop_token&) mutable {
        begun = true;
        goes_on.wait(false);
        return 100 * ++asked + question;
      },
      [&] { ++ready; });
  EXPECT_FALSE(worker.isBusy());
  EXPECT_EQ(worker.found(), nullptr);
  worker.ask(1);
  while (!begun) std::this_thread::yield();
  worker.ask(2);
  worker.ask(3);
  EXPECT_TRUE(worker.isBusy());
  EXPECT_FALSE(worker.waitFor(0ms));
  EXPECT_FALSE(worker.takeNews());
  goes_on = true;
  goes_on.notify_all();
  worker.wait();
  EXPECT_FALSE(worker.isBusy());
  EXPECT_EQ(*worker.found(), 203);
  EXPECT_TRUE(worker.takeNews());
  EXPECT_FALSE(worker.takeNews());
  worker.ask(4);
  EXPECT_TRUE(worker.waitFor(1h));
  EXPECT_EQ(*worker.found(), 304);
  EXPECT_GE(ready, 2);
}

TEST(Worker, ShowsWhatIsKnownOfAnAnswerSoFar) {
  std::atomic<bool> goes_on = false;
  std::optional<Worker<int, int>> worker;
  worker.emplace([&](int question, const std::stop_token&) {
    worker->publish(-question);
    goes_on.wait(false);
    return question;
  });
  worker->ask(7);
  while (!worker->takeNews()) std::this_thread::yield();
  EXPECT_EQ(*worker->found(), -7);
  EXPECT_TRUE(worker->isBusy());
  goes_on = true;
  goes_on.notify_all();
  worker->wait();
  EXPECT_EQ(*worker->found(), 7);
}

TEST(Worker, StopsTheAnswerThatItWorksOnAndNoOtherOne) {
  std::atomic<int> begun = 0;
  {
    Worker<int, int> worker([&](int question, const std::stop_token& stop) {
      ++begun;
      while (!stop.stop_requested()) std::this_thread::yield();
      return question;
    });
    worker.ask(1);
    while (begun == 0) std::this_thread::yield();
    worker.ask(2);
  }
  EXPECT_EQ(begun, 1);
}

}  // namespace
}  // namespace rocinante
