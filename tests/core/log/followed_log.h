#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/log/followed_file.h"
#include "core/log/log_follower.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {

/// A file that grows under the test's control.
class FakeFile final : public FollowedFile {
 public:
  explicit FakeFile(const Bytes& content) : content_(content) {}
  Result<std::uint64_t> size() override { return content_.size(); }
  Status read(std::uint64_t offset, std::span<std::byte> out) override {
    if (offset > content_.size() || out.size() > content_.size() - offset) {
      return Error{ErrorKind::unreadable, "read past the end", name_};
    }
    std::copy_n(content_.begin() + static_cast<std::ptrdiff_t>(offset), out.size(), out.begin());
    return {};
  }
  const std::string& name() const override { return name_; }

 private:
  const Bytes& content_;
  std::string name_ = "growing.mcap";
};

inline LogFollower follow(const Bytes& content, LogFollower::From from = LogFollower::From::start) {
  Result<LogFollower> follower = LogFollower::openOn(std::make_unique<FakeFile>(content), from);
  EXPECT_TRUE(follower.ok()) << follower.error().text();
  return std::move(*follower);
}

/// Adds everything that is there now to `messages`; false after an error.
inline bool drain(LogFollower& follower, std::vector<KeptMessage>& messages,
                  std::string* why = nullptr) {
  while (true) {
    const Result<std::optional<LogMessage>> message = follower.poll();
    if (!message.ok()) {
      if (why != nullptr) *why = message.error().text();
      return false;
    }
    if (!*message) return true;
    messages.push_back(keep(**message));
  }
}

}  // namespace rocinante::test
