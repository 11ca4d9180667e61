#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace rocinante {

/// Whose turn it is under `--lockstep`: after each message the player waits until its peer has
/// acknowledged it; before the first, until the peer has said anything. One thread.
class Lockstep {
 public:
  explicit Lockstep(bool is_on) : is_on_(is_on) {
    if (is_on) awaited_ = 0;
  }

  bool isOn() const { return is_on_; }
  bool isWaiting() const { return awaited_.has_value(); }
  /// The message whose acknowledgement is awaited; 0: the first line of a peer; empty: none.
  std::optional<std::uint64_t> awaited() const { return awaited_; }

  /// The message of this number was sent, counted from 1.
  void send(std::uint64_t number) {
    if (is_on_) awaited_ = number;
  }
  /// A peer said something.
  void hear() {
    if (awaited_ == 0U) awaited_.reset();
  }
  /// refused for a message that was not sent yet, or without lockstep; an earlier one is no news.
  Status acknowledge(std::uint64_t number) {
    if (!is_on_) return Error{ErrorKind::refused, "ack is for --lockstep only", {}};
    if (awaited_ && number > *awaited_) {
      return Error{
          ErrorKind::refused, "step " + std::to_string(number) + " has not been sent yet", {}};
    }
    if (awaited_ == number) awaited_.reset();
    return {};
  }

 private:
  bool is_on_;
  std::optional<std::uint64_t> awaited_;
};

}  // namespace rocinante
