// Any bytes as a log that grows while it is followed, by steps that the first bytes choose, from
// its start and from now. Nothing may crash, hang or take memory without bound; an error stays one;
// and what does not stand there yet is not read.

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "core/log/followed_file.h"
#include "core/log/log_follower.h"

namespace {

using namespace rocinante;

/// Of `whole`, what `*stands` says.
class GrowingFile final : public FollowedFile {
 public:
  GrowingFile(ByteView whole, const std::uint64_t* stands) : whole_(whole), stands_(stands) {}

  Result<std::uint64_t> size() override { return *stands_; }
  Status read(std::uint64_t offset, std::span<std::byte> out) override {
    if (offset > *stands_ || out.size() > *stands_ - offset) {
      return Error{ErrorKind::unreadable, "not all of it is there", name_};
    }
    if (!out.empty()) std::memcpy(out.data(), whole_.data() + offset, out.size());
    return {};
  }
  const std::string& name() const override { return name_; }

 private:
  ByteView whole_;
  const std::uint64_t* stands_;
  std::string name_ = "fuzz";
};

void follow(ByteView file, ByteView steps, LogFollower::From from) {
  std::uint64_t stands = 0;
  Result<LogFollower> follower =
      LogFollower::openOn(std::make_unique<GrowingFile>(file, &stands), from);
  if (!follower) return;
  bool failed = false;
  for (std::size_t step = 0; step <= steps.size(); ++step) {
    const bool is_last = step == steps.size();
    const std::uint64_t grown =
        is_last ? file.size() : static_cast<std::uint64_t>(steps[step]) * 16;
    stands = is_last ? grown : std::min<std::uint64_t>(stands + grown, file.size());
    while (true) {
      const Result<std::optional<LogMessage>> message = follower->poll();
      if (failed && message) std::abort();
      failed = !message;
      if (!message || !*message) break;
      const LogMessage& each = **message;
      if (each.channel == nullptr) std::abort();
      // Every byte of a payload is read: a sanitizer sees one too many.
      std::size_t sum = 0;
      for (const std::byte byte : each.payload) sum += static_cast<std::size_t>(byte);
      if (sum > each.payload.size() * 255) std::abort();
    }
    (void)follower->takeDamage();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kSteps = 8;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  const ByteView steps = bytes.first(std::min(size, kSteps));
  const ByteView file = bytes.subspan(steps.size());
  follow(file, steps, LogFollower::From::start);
  follow(file, steps, LogFollower::From::now);
  return 0;
}
