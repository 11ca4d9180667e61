#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "core/foreign/foxglove/signal_json.h"
#include "core/foreign/session/given_names.h"
#include "core/foreign/session/message_sink.h"
#include "core/foreign/session/session_format.h"
#include "core/report/account.h"

namespace rocinante {

/// The JSON channels of signals: one an owner, /signals/PATH. Of two owners that are written alike,
/// as a link `b` of `a` and a device `a/b`, the second one's has a number. One thread.
class SignalTopics {
 public:
  /// Their fields, from now on; again where there are more.
  void know(const KnownSignals& known);
  /// A message of what is new, or of all; nothing of what is not known.
  Status write(MessageSink& out, LogTime time, const SignalOwner& owner,
               std::span<const StatedSignal> signals, bool all_requested);

  /// Channels with a number.
  const Account& leftOut() const { return left_out_; }

 private:
  struct Topic {
    std::string name;
    SignalJson json;
    std::optional<MessageSchema> schema;  ///< made at the first message with these fields
  };
  std::string nameOf(const SignalOwner& owner);

  std::map<SignalOwner, Topic> topics_;
  GivenNames given_;
  Account left_out_;
};

}  // namespace rocinante
