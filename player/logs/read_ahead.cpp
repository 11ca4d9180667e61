#include "player/logs/read_ahead.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

namespace rocinante {
namespace {

struct Block {
  struct Item {
    Due due;
    std::size_t begin;
    std::size_t byte_count;
  };
  std::vector<Item> items;
  Bytes bytes;
  std::optional<Error> error;  ///< the failure that ended the stream, if any
  bool last = false;
};

// Blocks are handed over whole, so the sender locks once for many datagrams.
constexpr std::size_t kBlocks = 16;
constexpr std::size_t kBlockBytes = 256 * 1024;
constexpr std::size_t kBlockItems = 4096;
// The first block is small, so that it is ready soon.
constexpr std::size_t kFirstBlockItems = 32;

}  // namespace

struct ReadAhead::Impl {
  explicit Impl(DatagramStream& stream) : input(stream) {}

  Block readBlock(std::size_t most_items);
  void readAll();

  DatagramStream& input;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Block> ready;
  bool ended = false;
  bool stop = false;

  Block current;  ///< used by the sender only
  std::size_t position = 0;

  std::thread thread;
};

Block ReadAhead::Impl::readBlock(std::size_t most_items) {
  Block block;
  while (block.bytes.size() < kBlockBytes && block.items.size() < most_items) {
    const Result<std::optional<Due>> due = input.due();
    if (!due) block.error = due.error();
    block.last = !due || !*due;
    if (block.last) break;
    const ByteView payload = input.take();
    block.items.push_back({**due, block.bytes.size(), payload.size()});
    block.bytes.insert(block.bytes.end(), payload.begin(), payload.end());
  }
  return block;
}

void ReadAhead::Impl::readAll() {
  bool last = false;
  for (std::size_t items = kFirstBlockItems; !last; items = std::min(items * 4, kBlockItems)) {
    Block block = readBlock(items);
    last = block.last;
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return stop || ready.size() < kBlocks; });
    if (stop) return;
    ready.push_back(std::move(block));
    ended = last;
    changed.notify_all();
  }
}

ReadAhead::ReadAhead(DatagramStream& stream, bool fill) : impl_(std::make_unique<Impl>(stream)) {
  impl_->thread = std::thread([this] { impl_->readAll(); });
  if (!fill) return;
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(lock, [this] { return impl_->ended || impl_->ready.size() == kBlocks; });
}

ReadAhead::~ReadAhead() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stop = true;
  }
  impl_->changed.notify_all();
  impl_->thread.join();
}

Result<std::optional<Due>> ReadAhead::due() {
  Impl& impl = *impl_;
  while (impl.position == impl.current.items.size()) {
    if (impl.current.error) return *impl.current.error;
    if (impl.current.last) return std::optional<Due>();
    std::unique_lock lock(impl.mutex);
    impl.changed.wait(lock, [&impl] { return !impl.ready.empty(); });
    impl.current = std::move(impl.ready.front());
    impl.ready.pop_front();
    impl.position = 0;
    impl.changed.notify_all();
  }
  return std::optional(impl.current.items[impl.position].due);
}

ByteView ReadAhead::take() {
  const Block::Item& item = impl_->current.items[impl_->position++];
  return ByteView(impl_->current.bytes).subspan(item.begin, item.byte_count);
}

}  // namespace rocinante
