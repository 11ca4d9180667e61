#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/log/content_hash.h"
#include "tests/core/log/log_steps.h"

namespace rocinante::test {
namespace {

RC_GTEST_PROP(LogProperty, WhatIsReadIsWhatWasWrittenFromAnyMomentOn, ()) {
  const std::vector<Step> written = *steps();
  const Bytes file = writeSteps(written, anyOptions());
  LogReader reader = openLog(file);
  RC_ASSERT(readAll(reader) == expected(written, 0));
  for (int i = 0; i < 3; ++i) {
    const std::int64_t moment = *rc::gen::inRange(0, 61);
    RC_ASSERT(reader.seek(at(moment)).ok());
    RC_ASSERT(readAll(reader) == expected(written, moment));
  }
  RC_ASSERT(reader.damage().empty());
  RC_ASSERT(reader.summary().messages == written.size());
}

RC_GTEST_PROP(LogProperty, TheSessionsIdentityDoesNotDependOnTheChunking, ()) {
  const std::vector<Step> written = *steps();
  const Bytes a = writeSteps(written, anyOptions());
  const Bytes b = writeSteps(written, anyOptions());
  LogReader reader_a = openLog(a);
  LogReader reader_b = openLog(b);
  RC_ASSERT(*contentSha256(reader_a) == *contentSha256(reader_b));
}

RC_GTEST_PROP(LogProperty, AWalkOverAKilledLogFindsWhatTheSummaryWouldHaveTold, ()) {
  const std::vector<Step> written = *steps();
  Bytes file = writeSteps(written, anyOptions());
  // Without the last byte there is no closing magic, so the summary is ignored.
  file.pop_back();
  file.shrink_to_fit();
  LogReader reader = openLog(file);
  RC_ASSERT(readAll(reader) == expected(written, 0));
  RC_ASSERT(reader.summary().messages == written.size());
  RC_ASSERT(!reader.summary().complete);
  RC_ASSERT(reader.damage().size() == 1U);
}

}  // namespace
}  // namespace rocinante::test
