// What it costs to hand a live session's state to the window, by its size and by what changed: one
// picture's packets are folded by the network's side and applied by the window's. The bar: 10,000
// devices of which 1 % moves cost at most 1.5 times 1,000 devices of which 10 % moves, where a
// picture is drawn before each, as in the window: it leaves nothing else in the processor's caches.
// Without one, 1,000 devices stay in the caches and 10,000 do not; that is beside it, and so is the
// copy of the whole state, which this replaced.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/packet/decoder.h"
#include "viewer/ui/live/state_hand_over.h"

namespace {

using namespace rocinante;

constexpr int kPictures = 400;
constexpr int kRounds = 5;

double cpuMicroseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

struct Cost {
  double change_us = 1e12;  ///< of a hand-over of what changed, both sides, after a picture
  double cached_us = 1e12;  ///< the same without a picture
  double copy_us = 1e12;    ///< of a whole copy
};

class Session {
 public:
  Session(int devices, int moving) : devices_(devices), moving_(moving) {
    StateChanges changes;
    for (int i = 0; i < devices_; ++i) say(i, changes);
    changes.replaceBy(state_);
    std::move(changes).applyTo(window_, *window_decoder_);
  }

  Cost measure() {
    Cost cost;
    cost.change_us = handOver(true);
    cost.cached_us = handOver(false);
    const double began = cpuMicroseconds();
    for (int i = 0; i < 5; ++i) {
      const SessionState copy = state_;
      weight_ += copy.weight();
    }
    cost.copy_us = (cpuMicroseconds() - began) / 5;
    return cost;
  }

 private:
  /// Microseconds of one.
  double handOver(bool draws) {
    StateChanges changes;
    double spent = 0;
    for (int picture = 0; picture < kPictures; ++picture) {
      if (draws) drawPicture();
      // Folding is paid in any case: only what handing over adds is measured.
      std::vector<std::string> said;
      for (int i = 0; i < moving_; ++i) said.push_back(text((next_ += 7919) % devices_));
      for (const std::string& each : said) state_.apply(time(), *decoder_->decode(bytesOf(each)));
      const double began = cpuMicroseconds();
      for (const std::string& each : said) (void)changes.add(time(), bytesOf(each), state_);
      std::move(changes).applyTo(window_, *window_decoder_);
      spent += cpuMicroseconds() - began;
    }
    return spent / kPictures;
  }
  /// As much memory as the pixels, depths and vertices of a picture.
  void drawPicture() {
    for (std::size_t i = 0; i < picture_.size(); i += 8) picture_[i] += i;
  }

  LogTime time() const { return LogTime(Nanoseconds(said_)); }
  std::string text(int device) {
    ++said_;
    return fmt::format("RK1 plant {} -\njoints device{} {} 0.5 -0.25 1.5 0 0.125", said_, device,
                       said_ % 100);
  }
  void say(int device, StateChanges& changes) {
    const std::string one = text(device);
    state_.apply(time(), *decoder_->decode(bytesOf(one)));
    (void)changes.add(time(), bytesOf(one), state_);
  }

  std::vector<std::uint64_t> picture_ = std::vector<std::uint64_t>(3U << 20U);
  int devices_, moving_;
  int next_ = 0;
  std::int64_t said_ = 0;
  std::uint64_t weight_ = 0;
  std::unique_ptr<Decoder> decoder_ = makeDecoder("rk1");
  std::unique_ptr<Decoder> window_decoder_ = makeDecoder("rk1");
  SessionState state_, window_;
};

}  // namespace

int main() {
  Session small(1'000, 100), large(10'000, 100);
  Cost of_small, of_large;
  // In turn, so that both meet the same machine.
  for (int round = 0; round < kRounds; ++round) {
    for (auto& [session, best] : {std::pair{&small, &of_small}, std::pair{&large, &of_large}}) {
      const Cost cost = session->measure();
      best->change_us = std::min(best->change_us, cost.change_us);
      best->cached_us = std::min(best->cached_us, cost.cached_us);
      best->copy_us = std::min(best->copy_us, cost.copy_us);
    }
  }
  const double ratio = of_large.change_us / of_small.change_us;
  fmt::print("{:<34}{:>14}{:>14}{:>14}\n", "state hand-over, us a picture", "what changed",
             "in the caches", "whole copy");
  const auto row = [](const char* name, const Cost& cost) {
    fmt::print("{:<34}{:>14.1f}{:>14.1f}{:>14.1f}\n", name, cost.change_us, cost.cached_us,
               cost.copy_us);
  };
  row("1,000 devices, 10 % moving", of_small);
  row("10,000 devices, 1 % moving", of_large);
  fmt::print("ratio {:.2f} (bar 1.50), in the caches {:.2f}\n", ratio,
             of_large.cached_us / of_small.cached_us);
  return ratio <= 1.5 ? 0 : 1;
}
