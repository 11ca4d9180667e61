// What ffprobe says of a video: any text is read as pictures in order, or refused with a sentence.
#include <algorithm>
#include <cstdlib>
#include <functional>

#include "viewer/backdrop/video_facts.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto facts = rocinante::parseVideoFacts({reinterpret_cast<const char*>(data), size});
  if (!facts) {
    if (facts.error().what.empty()) std::abort();
    return 0;
  }
  const auto& times = facts->times;
  if (times.empty() || facts->width < 1 || facts->height < 1) std::abort();
  if (std::ranges::adjacent_find(times, std::greater_equal{}) != times.end()) std::abort();
  return 0;
}
