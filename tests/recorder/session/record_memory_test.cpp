#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>

#include "recorder/receive_loop.h"
#include "tests/recorder/session/capture_rig.h"
#include "tests/support/joint_packets.h"
#include "tests/support/process_memory.h"

// Hours of a session as fast as they go: sockets and clocks are the test's own.
namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kRate = 6'000;
constexpr Nanoseconds kStep = 5ms;

/// kRate datagrams a second of a six-joint arm, on clocks that only the test moves.
class SteadySource final : public DatagramSource {
 public:
  explicit SteadySource(const test::FakeClocks& clocks) : clocks_(clocks), begin_(clocks.wall()) {
    // A second's worth, said over and over: what is measured is the recorder.
    for (std::size_t i = 0; i < kRate; ++i) packets_.push_back(test::jointPacket(i, kRate));
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    batch_.clear();
    const auto due =
        (static_cast<std::uint64_t>((clocks_.wall() - begin_).count()) * kRate / 1'000'000'000);
    for (; sent_ < due && batch_.size() < 256; ++sent_) {
      batch_.push_back({});
      batch_.back().payload = bytesOf(packets_[sent_ % kRate]);
      batch_.back().sender = sender_;
      batch_.back().kernel_time = clocks_.wall();
    }
    return std::span<const ReceivedDatagram>(batch_);
  }
  std::uint64_t dropped() const override { return 0; }
  Result<std::uint64_t> droppedByNow() override { return 0U; }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return endpoint_.address; }
  std::uint64_t sent() const { return sent_; }

 private:
  const test::FakeClocks& clocks_;
  WallTime begin_;
  Endpoint endpoint_ = Endpoint::parse("127.0.0.1:9").value();
  SocketAddress sender_ = SocketAddress::parse("10.0.0.1", 5000).value();
  std::vector<std::string> packets_;
  std::vector<ReceivedDatagram> batch_;
  std::uint64_t sent_ = 0;
};

// Under AddressSanitizer freed memory waits to be judged: how much there is says nothing then.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kJudgesMemory = false;
#else
constexpr bool kJudgesMemory = true;
#endif

/// Records for so long; the anonymous memory takes no more in the second half than in the first, in
/// which every piece has grown to its end and every buffer to its size.
void recordFor(Nanoseconds span, RecordOptions options) {
  // On a busy machine threads wait for each other, and malloc then opens a second arena, at any
  // time: 3 MB that are the allocator's and not the recorder's.
  ::mallopt(M_ARENA_MAX, 1);
  test::CaptureRig rig(std::move(options));
  test::FakeClocks clocks;
  SteadySource source(clocks);
  ReceiveLoop loop(
      {&source}, [&] { return clocks.look(); }, rig.queue);
  std::uint64_t at_first = 0;
  std::uint64_t later = 0;
  const std::int64_t steps = span / kStep;
  for (std::int64_t step = 0; step < steps; ++step) {
    clocks.pass(kStep);
    ASSERT_TRUE(loop.pass().ok());
    rig.writer->write(rig.queue.take(0ns), rig.queue);
    rig.writer->flush(SteadyTime(1h + kStep * step));
    (void)rig.notes.take();
    // Every step: closing a piece takes some memory for a moment, which fewer looks hit or miss.
    std::uint64_t& most = step < steps / 2 ? at_first : later;
    most = std::max(most, test::anonymousBytes());
  }
  ASSERT_TRUE(loop.finish().ok());
  rig.writer->write(rig.queue.take(0ns), rig.queue);
  const RecordedFiles files = rig.close();
  ASSERT_FALSE(rig.writer->trouble()) << rig.writer->trouble()->text();
  EXPECT_EQ(rig.writer->packets(), source.sent());
  EXPECT_EQ(rig.writer->lost(), 0U);
  std::printf("%llu packets; anonymous memory %.1f MB at most in the first half, %.1f MB later\n",
              static_cast<unsigned long long>(source.sent()), static_cast<double>(at_first) * 1e-6,
              static_cast<double>(later) * 1e-6);
  if (kJudgesMemory) {
    EXPECT_LT(later, at_first + (2U << 20U));
  }
}

Nanoseconds sessionLength() {
  return std::getenv("ROCINANTE_NIGHTLY") != nullptr ? Nanoseconds(1h) : Nanoseconds(60s);
}

TEST(RecordMemory, OfPiecesIsConstant) {
  RecordOptions options;
  options.split.size_bytes = sessionLength() > 1min ? 64'000'000 : 2'000'000;
  options.limits.keep = 3;
  recordFor(sessionLength(), options);
}

TEST(RecordMemory, OfARingIsConstant) {
  RecordOptions options;
  options.ring = RingRule{3s, 0s};
  recordFor(sessionLength(), options);
}

}  // namespace
}  // namespace rocinante
