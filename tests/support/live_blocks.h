#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

// Counts what `new` gives and `delete` takes back in the whole program: include it in one file of a
// program alone.

namespace rocinante::test {

inline std::atomic<std::int64_t> g_live_blocks{0};

/// Blocks of memory that were made and are not gone, of every thread.
inline std::int64_t liveBlocks() { return g_live_blocks.load(); }

}  // namespace rocinante::test

// Not inlined: where g++ sees malloc() inside `new`, it takes the two for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) std::abort();
  ++rocinante::test::g_live_blocks;
  return block;
}

// What std::stable_sort asks for; a sanitizer's own would not go with our delete.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return operator new(size);
}

[[gnu::noinline]] void operator delete(void* block) noexcept {
  if (block == nullptr) return;
  --rocinante::test::g_live_blocks;
  std::free(block);
}

[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}
