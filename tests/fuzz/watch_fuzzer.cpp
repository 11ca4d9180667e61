// Captured frames as an attacker would send them: the first byte is the link type, then frames,
// each behind two bytes of length and one of the milliseconds that pass. Whatever they hold,
// datagrams come out no longer than there can be, and the same ones on the same bytes.
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/pcap/frame_reader.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

struct Outcome {
  std::vector<std::size_t> sizes;
  InputCounts counts;
  std::uint64_t waiting = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome readAll(ByteView bytes) {
  constexpr LinkType kLinks[] = {LinkType::ethernet,     LinkType::bsd_null,
                                 LinkType::bsd_loop,     LinkType::raw_ip,
                                 LinkType::linux_cooked, LinkType::linux_cooked_2};
  Outcome outcome;
  if (bytes.empty()) return outcome;
  const auto number = [&](std::size_t at) { return std::to_integer<std::size_t>(bytes[at]); };
  const LinkType link = kLinks[number(0) % 6];
  FrameReader reader([](LinkType, ByteView frame) { return frame.size() % 7 != 0; },
                     number(0) >= 128 ? FrameReader::Filtered::here : FrameReader::Filtered::before,
                     number(0) % 4 == 1);
  bytes = bytes.subspan(1);
  WallTime time{std::chrono::seconds(1'000)};
  while (bytes.size() >= 3) {
    const std::size_t length = std::min(number(0) << 8U | number(1), bytes.size() - 3);
    time += std::chrono::milliseconds(number(2));
    // A buffer of its own: reading one byte beyond shows.
    const Bytes frame(bytes.begin() + 3, bytes.begin() + 3 + static_cast<std::ptrdiff_t>(length));
    bytes = bytes.subspan(3 + length);
    const std::uint64_t left_out = reader.leftOut(true).total();
    const auto seen = reader.read(link, frame, time);
    // Used, named, or a fragment that waits for others.
    if (!seen) outcome.waiting += reader.leftOut(true).total() == left_out ? 1 : 0;
    if (!seen) continue;
    require(seen->payload.size() <= 65'527);
    std::size_t sum = 0;
    for (const std::byte each : seen->payload) sum += std::to_integer<std::size_t>(each);
    outcome.sizes.push_back(seen->payload.size() + sum * 65'536);
  }
  reader.finish();
  outcome.counts = reader.counts();
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  require(readAll(bytes) == readAll(bytes));
  return 0;
}
