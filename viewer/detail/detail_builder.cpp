#include "viewer/detail/detail_builder.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>

#include "core/base/thread_priority.h"

namespace rocinante {

struct DetailBuilder::Impl {
  std::vector<DetailInput> inputs;
  std::vector<std::size_t> order;  // numbers of inputs, the most triangles first
  DetailCache cache;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::condition_variable all_made;
  std::vector<ReadyDetail> ready;  // guarded by mutex
  std::size_t made = 0;            // guarded by mutex
  std::size_t taken = 0;           // by the caller
  std::vector<std::jthread> threads;

  MeshDetail detailOf(const DetailInput& input) const {
    const std::string key = detailKey(input);
    if (auto kept = cache.load(key, input)) return std::move(*kept);
    MeshDetail detail = makeMeshDetail(input);
    cache.store(key, detail);
    return detail;
  }

  void work() {
    lowerPriority();
    for (std::size_t i = next++; i < order.size() && !stop; i = next++) {
      ReadyDetail one{order[i], detailOf(inputs[order[i]])};
      const std::lock_guard lock(mutex);
      ready.push_back(std::move(one));
      if (++made == order.size()) all_made.notify_all();
    }
  }
};

DetailBuilder::DetailBuilder(std::vector<DetailInput> inputs, DetailCache cache, int threads)
    : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  impl.inputs = std::move(inputs);
  impl.cache = std::move(cache);
  impl.order.resize(impl.inputs.size());
  std::iota(impl.order.begin(), impl.order.end(), std::size_t{0});
  std::ranges::stable_sort(impl.order, std::ranges::greater(),
                           [&](std::size_t number) { return impl.inputs[number].indices->size(); });
  const std::size_t wanted =
      std::min<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), impl.inputs.size());
  for (std::size_t i = 0; i < wanted; ++i) impl.threads.emplace_back([&impl] { impl.work(); });
}

DetailBuilder::~DetailBuilder() {
  impl_->stop = true;
  impl_->threads.clear();
}

std::vector<ReadyDetail> DetailBuilder::takeReady() {
  std::vector<ReadyDetail> taken;
  {
    const std::lock_guard lock(impl_->mutex);
    taken = std::exchange(impl_->ready, {});
  }
  impl_->taken += taken.size();
  return taken;
}

std::vector<ReadyDetail> DetailBuilder::waitForAll() {
  {
    std::unique_lock lock(impl_->mutex);
    impl_->all_made.wait(lock, [&] { return impl_->made == impl_->order.size(); });
  }
  return takeReady();
}

bool DetailBuilder::finished() const { return impl_->taken == impl_->inputs.size(); }

}  // namespace rocinante
