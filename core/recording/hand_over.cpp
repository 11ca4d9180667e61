#include "core/recording/hand_over.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rocinante {
namespace {

// The wall clock steps a few times in a session; a clock that steps all the time must not fill the
// memory.
constexpr std::size_t kMaxSteps = 1'000;

}  // namespace

void addLoss(std::vector<EndpointLoss>& losses, const EndpointLoss& loss) {
  const auto same = std::find_if(losses.begin(), losses.end(), [&](const EndpointLoss& each) {
    return each.endpoint == loss.endpoint;
  });
  if (same == losses.end()) {
    losses.push_back(loss);
    return;
  }
  same->from = std::min(same->from, loss.from);
  same->until = std::max(same->until, loss.until);
  same->counts += loss.counts;
}

std::unique_ptr<DatagramBlock> HandOver::freeBlock() {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      std::unique_ptr<DatagramBlock> block = std::move(free_.back());
      free_.pop_back();
      return block;
    }
    if (made_ == max_blocks_) return nullptr;
    ++made_;
  }
  return std::make_unique<DatagramBlock>();
}

void HandOver::give(std::unique_ptr<DatagramBlock> block, std::vector<EndpointLoss>& losses,
                    std::vector<ClockStep>& steps, std::optional<LogTime> drained_until) {
  const bool urgent = block != nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (block) waiting_.blocks.push_back(std::move(block));
    for (const EndpointLoss& loss : losses) addLoss(waiting_.losses, loss);
    const std::size_t room = kMaxSteps - std::min(kMaxSteps, waiting_.steps.size());
    std::copy_n(steps.begin(), std::min(room, steps.size()), std::back_inserter(waiting_.steps));
    if (drained_until) waiting_.drained_until = std::max(waiting_.drained_until, *drained_until);
  }
  losses.clear();
  steps.clear();
  if (urgent) given_.notify_one();
}

double HandOver::fill() {
  const std::lock_guard lock(mutex_);
  return static_cast<double>(made_ - free_.size()) / static_cast<double>(max_blocks_);
}

void HandOver::finish() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.finished = true;
  }
  given_.notify_one();
}

TakenOver HandOver::take(Nanoseconds at_most) {
  std::unique_lock lock(mutex_);
  given_.wait_for(lock, at_most, [&] { return !waiting_.blocks.empty() || waiting_.finished; });
  TakenOver taken = std::exchange(waiting_, TakenOver{});
  waiting_.drained_until = taken.drained_until;
  waiting_.finished = taken.finished;
  return taken;
}

void HandOver::giveBack(std::unique_ptr<DatagramBlock> block) {
  block->clear();
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(block));
}

}  // namespace rocinante
