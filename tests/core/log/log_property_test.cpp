#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/log/content_hash.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {
namespace {

struct Step {
  int channel;
  std::int64_t time_ns;
  std::string payload;
  bool flush;
};

/// Any messages, in time order or not, on any of five channels, with ties.
rc::Gen<std::vector<Step>> steps() {
  return rc::gen::container<std::vector<Step>>(rc::gen::construct<Step>(
      rc::gen::inRange(0, 5), rc::gen::cast<std::int64_t>(rc::gen::inRange(1, 60)),
      rc::gen::container<std::string>(rc::gen::arbitrary<char>()),
      rc::gen::weightedOneOf<bool>({{9, rc::gen::just(false)}, {1, rc::gen::just(true)}})));
}

Bytes writeSteps(const std::vector<Step>& steps, const LogWriterOptions& options) {
  Bytes file;
  LogWriter writer = makeWriter(file, options);
  for (int i = 0; i < 5; ++i) {
    RC_ASSERT(writer.addChannel("/udp/" + std::to_string(i % 3), "octets", {}).ok());
  }
  SteadyTime now{};
  std::uint32_t sequence = 0;
  for (const Step& step : steps) {
    RC_ASSERT(writer
                  .write(static_cast<ChannelId>(step.channel), sequence++, at(step.time_ns), 1,
                         bytesOf(step.payload))
                  .ok());
    now += options.sync;
    if (step.flush) RC_ASSERT(writer.flushIfDue(now).ok());
  }
  RC_ASSERT(writer.close("finished").ok());
  return file;
}

/// What must come back from `moment` on: by time, ties in order of writing.
std::vector<KeptMessage> expected(const std::vector<Step>& steps, std::int64_t moment) {
  std::vector<KeptMessage> out;
  std::uint32_t sequence = 0;
  for (const Step& step : steps) {
    out.push_back(
        {"/udp/" + std::to_string(step.channel % 3), sequence++, step.time_ns, 1, step.payload});
  }
  std::erase_if(out, [&](const KeptMessage& m) { return m.log_time_ns < moment; });
  std::ranges::stable_sort(out, {}, &KeptMessage::log_time_ns);
  return out;
}

LogWriterOptions anyOptions() {
  LogWriterOptions options;
  options.chunk_bytes = static_cast<std::size_t>(*rc::gen::inRange(1, 4000));
  options.compression = *rc::gen::arbitrary<bool>() ? LogWriterOptions::Compression::zstd
                                                    : LogWriterOptions::Compression::none;
  return options;
}

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
  // Without the last byte there is no closing magic, so that nothing of the summary counts.
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
