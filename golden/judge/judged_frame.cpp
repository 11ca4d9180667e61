#include "golden/judge/judged_frame.h"

namespace rocinante {

std::string_view nameOf(FrameVerdict verdict) {
  switch (verdict) {
    case FrameVerdict::same:
      return "same";
    case FrameVerdict::different:
      return "different";
    case FrameVerdict::missing:
      return "missing";
    case FrameVerdict::unstable:
      return "unstable";
    case FrameVerdict::incomparable:
      return "incomparable";
    case FrameVerdict::expected:
      return "expected";
    case FrameVerdict::unexpected:
      return "unexpected";
  }
  return "incomparable";
}

bool isFine(FrameVerdict verdict) {
  return verdict == FrameVerdict::same || verdict == FrameVerdict::expected;
}

}  // namespace rocinante
