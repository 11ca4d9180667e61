// Any bytes as SRDF: the number of pairs is bounded, each has two names, and every fault can be
// printed.

#include <cstdlib>
#include <span>

#include "core/kinematics/srdf_reader.h"

using namespace rocinante;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Findings faults;
  const auto pairs = readSrdf(std::as_bytes(std::span(data, size)), "fuzz.srdf", faults);
  if (pairs.size() > kMaxSrdfPairs) std::abort();
  for (const auto& [first, second] : pairs) {
    if (first.empty() || second.empty()) std::abort();
  }
  for (const Finding& fault : faults) {
    if (fault.print().empty()) std::abort();
  }
  return 0;
}
