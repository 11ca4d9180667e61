#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/core/log/log_support.h"

namespace rocinante::test {

/// The next step of a generated session.
struct Step {
  int channel;
  std::int64_t time_ns;
  std::string payload;
  bool flush;
};

/// Any messages, in time order or not, on any of five channels, with ties.
inline rc::Gen<std::vector<Step>> steps() {
  return rc::gen::container<std::vector<Step>>(rc::gen::construct<Step>(
      rc::gen::inRange(0, 5), rc::gen::cast<std::int64_t>(rc::gen::inRange(1, 60)),
      rc::gen::container<std::string>(rc::gen::arbitrary<char>()),
      rc::gen::weightedOneOf<bool>({{9, rc::gen::just(false)}, {1, rc::gen::just(true)}})));
}

/// How a log ends.
enum class Ending {
  closed,
  without_magic,  ///< its last byte is missing, so that its summary is ignored
  killed,         ///< after the last flush: the last chunk may be open
};

inline Bytes writeSteps(const std::vector<Step>& steps, const LogWriterOptions& options,
                        Ending ending = Ending::closed) {
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
  if (ending == Ending::killed) {
    RC_ASSERT(writer.flushIfDue(now + options.sync).ok());
    return cutAt(file, file.size());
  }
  RC_ASSERT(writer.close("finished").ok());
  return cutAt(file, file.size() - (ending == Ending::without_magic ? 1 : 0));
}

/// The messages expected from `moment` on: by time, ties in order of writing.
inline std::vector<KeptMessage> expected(const std::vector<Step>& steps, std::int64_t moment = 0) {
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

inline LogWriterOptions anyOptions() {
  LogWriterOptions options;
  options.chunk_bytes = static_cast<std::size_t>(*rc::gen::inRange(1, 4000));
  options.compression = *rc::gen::arbitrary<bool>() ? LogWriterOptions::Compression::zstd
                                                    : LogWriterOptions::Compression::none;
  return options;
}

}  // namespace rocinante::test
