#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/recorder/doctor/doctor_support.h"

namespace rocinante::test {

/// A rule, and a change of a sound log that breaks only this rule.
struct DoctorCase {
  std::string rule;
  std::function<void(HandMade&)> change;
  std::function<void(Bytes&)> change_bytes;
};

/// Every rule at least once.
const std::vector<DoctorCase>& doctorCases();

/// Makes the file one without our profile.
inline void foreign(HandMade& log) { log.profile = ""; }

/// A message of our own on a channel of its own, in the second chunk.
void addOwnMessage(HandMade& log, const char* topic, const char* encoding, std::uint64_t time,
                   const std::string& payload);

}  // namespace rocinante::test
