// A program of its own: it counts what the whole program allocates.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <new>

#include "core/source/source.h"

namespace {
std::size_t g_allocations = 0;
}

// Not inlined: where g++ sees malloc() inside `new`, it takes the two for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++g_allocations;
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) std::abort();
  return block;
}
// All forms of `new` and `delete`: the sanitizers' own allocate what only they can free.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++g_allocations;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void* operator new[](std::size_t size) { return operator new(size); }
[[gnu::noinline]] void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
  return operator new(size, tag);
}
[[gnu::noinline]] void operator delete(void* block) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete(void* block, const std::nothrow_t&) noexcept {
  std::free(block);
}
[[gnu::noinline]] void operator delete[](void* block) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete[](void* block, std::size_t) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete[](void* block, const std::nothrow_t&) noexcept {
  std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace rocinante {
namespace {

TEST(SourceMemory, NothingIsAllocatedOnceItRuns) {
  SourceSettings settings;
  settings.source = "cell";
  std::size_t bytes = 0;
  auto opened = Source::open(settings, [&bytes](std::span<std::byte> datagram) {
    bytes += datagram.size();
    return true;
  });
  Source& source = opened.value();
  const std::array<std::string_view, 3> names = {"shoulder_of_the_first_arm", "elbow", "wrist"};
  const std::array points = {Vec3{0, 0, 0}, Vec3{1, 2, 3}};
  const std::array<std::string_view, 2> boxes = {"a_box_with_a_long_name", "another_box"};
  bool all_done = true;
  const auto expectDone = [&](SourceResult result) { all_done &= result == SourceResult::done; };

  const std::size_t before = g_allocations;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    const SourceDevice arm = source.device("arm_with_a_name_that_no_string_keeps_inside");
    const double value = 0.001 * cycle;
    expectDone(source.setOrder(arm, names));
    expectDone(source.setJoints(arm, std::array{value, -value, 2 * value}));
    const SourceDevice box = source.device(boxes[static_cast<std::size_t>(cycle % 2)]);
    expectDone(source.add(box, "box", 17));
    expectDone(source.setPose(box, {{value, 0, 0}, Quat(1, 0, 0, 0)}, {"arm", "tip", false}));
    expectDone(source.setColor({"arm", "link", false}, static_cast<std::uint32_t>(cycle)));
    expectDone(source.setVisibility({"layer", "safety", true}, Source::Visibility::hidden));
    expectDone(source.drawLine("path", 0xFF, points, 1 + value));
    expectDone(source.drawLabel("label", {value, 0, 0}, "a text that is long enough for the heap"));
    expectDone(source.event("an event that is long enough for the heap as well"));
    if (cycle % 7 == 0) expectDone(source.erase("path"));
    if (cycle % 5 == 0) expectDone(source.remove(box));
    if (cycle % 10 == 0) expectDone(source.forget(box));
    expectDone(source.flush(WallTime(std::chrono::milliseconds(cycle))));
  }
  EXPECT_EQ(g_allocations - before, 0U);
  EXPECT_TRUE(all_done);
  EXPECT_GT(bytes, 100'000U);
}

}  // namespace
}  // namespace rocinante
