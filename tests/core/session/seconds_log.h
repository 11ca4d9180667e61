#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/packet/decoder.h"
#include "core/session/keyframe.h"
#include "core/session/timeline.h"
#include "tests/core/log/log_support.h"

namespace rocinante::test {

/// Ten seconds of a joint whose value is the current second, ten times a second, a chunk a second;
/// and a keyframe at each of `keyframes`, in seconds.
struct SecondsLog {
  explicit SecondsLog(const std::vector<int>& keyframes) {
    LogWriterOptions options;
    options.chunk_bytes = 900;
    options.compression = LogWriterOptions::Compression::none;
    LogWriter writer = makeWriter(file, options);
    const ChannelId packets = *writer.addChannel("/udp/1/arm", "rk1", {});
    const ChannelId states = *writer.addChannel("/rocinante/keyframe", "rk1-keyframe", {});
    const std::string filler = "\n# " + std::string(60, 'x');
    SessionState state;
    auto decoder = makeDecoder("rk1");
    for (int tenth = 0; tenth < 100; ++tenth) {
      const LogTime time = moment(tenth * 100);
      const std::string text = "RK1 arm - -\njoint arm a=" + std::to_string(tenth / 10);
      state.apply(time, *decoder->decode(bytesOf(text)));
      EXPECT_TRUE(writer.write(packets, 0, time, 0, bytesOf(text + filler)).ok());
      if (tenth % 10 != 0 || std::ranges::find(keyframes, tenth / 10) == keyframes.end()) continue;
      EXPECT_TRUE(writer.write(states, 0, time, 0, bytesOf(keyframeText(state))).ok());
    }
    EXPECT_TRUE(writer.close("finished").ok());
  }

  static LogTime moment(int milliseconds) {
    return LogTime(Nanoseconds(std::chrono::milliseconds(1'000'000 + milliseconds)));
  }
  /// Flips one bit of the first occurrence of the text `a=SECOND`.
  void spoil(int second) {
    const std::string text = "joint arm a=" + std::to_string(second);
    const auto found =
        std::search(file.begin(), file.end(), bytesOf(text).begin(), bytesOf(text).end());
    ASSERT_NE(found, file.end());
    *found ^= std::byte{1};
  }
  bool isToldAt(int milliseconds) const {
    Timeline timeline = Timeline::of(openLog(file));
    return !timeline.stateAt(moment(milliseconds)).ok();
  }

  Bytes file;
};

}  // namespace rocinante::test
