#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/net/endpoint.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// What came to an endpoint that was listened at for a moment.
struct HeardEndpoint {
  std::string endpoint;  ///< as a user writes it
  /// Names of sources, sorted, as they may be shown; at most kMostSources.
  std::vector<std::string> sources;
  std::uint64_t datagrams = 0;
  std::uint64_t undecoded = 0;  ///< of those: not packet text
  bool listening = true;        ///< more may come
  std::string fault;            ///< why nobody can listen there; empty: one can

  static constexpr std::size_t kMostSources = 32;
  /// "arm, gripper: 120 packets", "nothing heard", or the fault.
  std::string text() const;
  bool operator==(const HeardEndpoint&) const = default;
};

/// Why an endpoint cannot be listened at, with advice that a window has in place of a program's.
std::string faultInWindow(std::string fault);

/// An endpoint, and for how long it is listened at.
struct SurveyedEndpoint {
  Endpoint endpoint;
  Nanoseconds length{0};
};

/// Where sources send without settings: the standard group, for longer than a source is silent, and
/// its port on every address of this machine. That port has one listener, so it is taken for as
/// short as possible.
std::vector<SurveyedEndpoint> usualEndpoints();

/// Listens at endpoints for a moment, in a thread of its own with a low priority, and closes them
/// again. Nothing is kept of what came. For one calling thread.
class EndpointSurvey {
 public:
  /// Begins at once.
  explicit EndpointSurvey(std::vector<SurveyedEndpoint> endpoints);

  /// Listens once more; not while isListening().
  void listen();
  /// In the order of the endpoints, as far as is known; empty before the first is open.
  std::vector<HeardEndpoint> heard() const;
  bool isListening() const { return worker_.isBusy(); }
  /// True when there is more since the last call.
  bool takeNews() { return worker_.takeNews(); }
  void wait() const { worker_.wait(); }

 private:
  struct Question {};
  using Answer = std::vector<HeardEndpoint>;
  Answer look(const std::stop_token& stop);

  std::vector<SurveyedEndpoint> endpoints_;
  Worker<Question, Answer> worker_;  // last: its thread uses the member above
};

}  // namespace rocinante
