#include "core/source/source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// A source whose datagrams are kept.
struct Sender {
  explicit Sender(SourceSettings settings = {}) {
    settings.source = "cell";
    settings.run = "1";
    source.emplace(Source::open(settings, [this](std::span<std::byte> datagram) {
                     if (!is_connected) return false;
                     sent.emplace_back(textOf(datagram));
                     return true;
                   }).value());
  }
  Source* operator->() { return &*source; }
  std::vector<std::string> flush(Nanoseconds now) {
    sent.clear();
    result = source->flush(WallTime(now));
    return sent;
  }

  std::optional<Source> source;
  std::vector<std::string> sent;
  bool is_connected = true;
  SourceResult result = SourceResult::done;
};

constexpr std::array<double, 2> kValues = {0.5, -1};
constexpr std::array<std::string_view, 2> kNames = {"shoulder", "elbow"};

TEST(Source, SendsWhatChangedAndNothingElse) {
  Sender sender;
  const SourceDevice arm = sender->device("my arm");
  EXPECT_EQ(sender->device("my arm").handle, arm.handle);
  ASSERT_EQ(sender->add(arm, "puma", 0xFF), SourceResult::done);
  ASSERT_EQ(sender->setOrder(arm, kNames), SourceResult::done);
  ASSERT_EQ(sender->setJoints(arm, kValues), SourceResult::done);
  EXPECT_THAT(sender.flush(1s),
              ElementsAre("RK1 cell@1 0 1\nadd my%20arm puma kin=00000000000000ff\n"
                          "order my%20arm shoulder elbow\n"
                          "joints my%20arm 0.5 -1\n"));
  ASSERT_EQ(sender->setJoints(arm, kValues), SourceResult::done);
  EXPECT_THAT(sender.flush(1250ms), ElementsAre());
  ASSERT_EQ(sender->setJoints(arm, std::array{0.25, -1.0}), SourceResult::done);
  EXPECT_THAT(sender.flush(1250ms), ElementsAre("RK1 cell@1 1 1.25\njoints my%20arm 0.25 -1\n"));
  EXPECT_EQ(sender->sent(), 2U);
  ASSERT_EQ(sender->repeat(arm), SourceResult::done);
  EXPECT_THAT(sender.flush(1300ms), ElementsAre("RK1 cell@1 2 1.3\njoints my%20arm 0.25 -1\n"));
}

TEST(Source, SaysEveryKindOfStatement) {
  Sender sender;
  const SourceDevice tray = sender->device("tray");
  const std::array points = {Vec3{0, 0, 0}, Vec3{1, 0.5, -0.0}};
  Source::View view;
  view.eye = {1, 2, 3};
  view.up = {0, 1, 0};
  view.ortho_height_m = 4;
  const PathView tip = {"arm", "tip", false};
  ASSERT_EQ(sender->setPose(tray, {{1, 0, 1e-9}, Quat(1, 0, 0, 0)}, tip), SourceResult::done);
  ASSERT_EQ(sender->setVisibility({"layer", "safety", true}, Source::Visibility::hidden),
            SourceResult::done);
  ASSERT_EQ(sender->setVisibility({"layer", "a", false}, Source::Visibility::as_the_cell),
            SourceResult::done);
  ASSERT_EQ(sender->setColor({"tray", "", false}, 0xFF800080), SourceResult::done);
  ASSERT_EQ(sender->setColor({"tray", "a/b", false}, std::nullopt), SourceResult::done);
  ASSERT_EQ(sender->drawLine("path", 0x00FF00FF, points, 2), SourceResult::done);
  ASSERT_EQ(sender->drawPoints("cloud", 0x00FF0010, points, 3, tip), SourceResult::done);
  ASSERT_EQ(sender->drawLabel("goal", {0, 0, 1}, "a \"b\"\n", tip), SourceResult::done);
  ASSERT_EQ(sender->setView("top", view), SourceResult::done);
  ASSERT_EQ(sender->event("picked"), SourceResult::done);
  EXPECT_THAT(sender.flush(0s),
              ElementsAre("RK1 cell@1 0 0\n"
                          "pose tray 1 0 0.000000001 0 0 0 1 in arm/tip\n"
                          "hide layer/safety\n"
                          "show %6Cayer/a default\n"
                          "color tray #ff800080\n"
                          "color tray/a%2Fb default\n"
                          "line path #00ff00 width=2 0 0 0 1 0.5 0\n"
                          "points cloud #00ff0010 size=3 in arm/tip 0 0 0 1 0.5 0\n"
                          "label goal in arm/tip 0 0 1 \"a \\\"b\\\"\\n\"\n"
                          "view top 1 2 3 0 0 0 45 up 0 1 0 ortho 4\n"
                          "event \"picked\"\n"));
  ASSERT_EQ(sender->erase("path"), SourceResult::done);
  ASSERT_EQ(sender->eraseAll(), SourceResult::done);
  ASSERT_EQ(sender->remove(tray), SourceResult::done);
  ASSERT_EQ(sender->add(tray, "tray"), SourceResult::done);
  EXPECT_THAT(sender.flush(1ms), ElementsAre("RK1 cell@1 1 0.001\nerase path\nerase *\n"
                                             "remove tray\nadd tray tray\n"));
}

TEST(Source, PositionsCancelAnOrderThatAReceiverMayKnow) {
  Sender sender;
  const SourceDevice arm = sender->device("arm");
  ASSERT_EQ(sender->setJoints(arm, kValues), SourceResult::done);
  EXPECT_THAT(sender.flush(0s), ElementsAre("RK1 cell@1 0 0\norder arm\njoints arm 0.5 -1\n"));
  EXPECT_THAT(sender.flush(2s), ElementsAre("RK1 cell@1 1 2 restated part=r1:1/1\norder arm\n"
                                            "joints arm 0.5 -1\n"));
  // The count of positions is free.
  ASSERT_EQ(sender->setJoints(arm, std::array{1.0}), SourceResult::done);
  EXPECT_EQ(sender->setOrder(arm, kNames), SourceResult::order_fixed);
  ASSERT_EQ(sender->remove(arm), SourceResult::done);
  EXPECT_EQ(sender->setOrder(arm, kNames), SourceResult::gone);
  EXPECT_EQ(sender->setColor({"arm", "link", false}, 0), SourceResult::gone);
  ASSERT_EQ(sender->add(arm, "puma"), SourceResult::done);
  EXPECT_EQ(sender->setOrder(arm, kNames), SourceResult::done);
  EXPECT_EQ(sender->setOrder(arm, kNames), SourceResult::done);
  EXPECT_EQ(sender->setJoints(arm, std::array{1.0}), SourceResult::wrong_count);
}

TEST(Source, ARestatementHasTheValuesOfItsMomentAndIsSpread) {
  Sender sender;
  std::vector<SourceDevice> devices;
  for (int i = 0; i < 400; ++i) {
    devices.push_back(sender->device("device_" + std::to_string(i)));
    ASSERT_EQ(sender->setJoints(devices.back(), std::array{0.0, 0.0}), SourceResult::done);
  }
  sender.flush(0s);
  std::size_t parts = 0;
  std::size_t most_at_once = 0;
  Nanoseconds last{};
  SessionState late;
  PacketTextDecoder decoder;
  for (Nanoseconds now = 2ms; now < 3s; now += 2ms) {
    const double value = std::chrono::duration<double>(now).count();
    ASSERT_EQ(sender->setJoints(devices.back(), std::array{value, 1.0}), SourceResult::done);
    std::size_t at_once = 0;
    for (const std::string& datagram : sender.flush(now)) {
      EXPECT_LE(datagram.size(), 1200U);
      const Packet* const packet = decoder.decode(bytesOf(datagram));
      ASSERT_NE(packet, nullptr);
      if (now > 1s) late.apply(LogTime(now), *packet);
      at_once += packet->header.part.has_value();
      if (packet->header.part) last = now;
    }
    parts += at_once;
    most_at_once = std::max(most_at_once, at_once);
  }
  EXPECT_GT(parts, 10U);
  EXPECT_EQ(most_at_once, 1U);
  EXPECT_GT(last, 2400ms);
  EXPECT_LE(last, 2500ms);
  EXPECT_EQ(late.devices().size(), 400U);
  EXPECT_EQ(late.devices().at("device_399").joints->value[0], 2.998);
}

TEST(Source, SlowAndIrregularFlushesStillCompleteARestatement) {
  for (const Nanoseconds step : {Nanoseconds(300ms), Nanoseconds(700ms), Nanoseconds(5s)}) {
    Sender sender;
    for (int i = 0; i < 200; ++i) {
      const SourceDevice device = sender->device("device_" + std::to_string(i));
      ASSERT_EQ(sender->setJoints(device, kValues), SourceResult::done);
    }
    sender.flush(0s);
    SessionState late;
    PacketTextDecoder decoder;
    for (int i = 1; i * step <= 20s; ++i) {
      for (const std::string& datagram : sender.flush(i * step)) {
        late.apply(LogTime(i * step), *decoder.decode(bytesOf(datagram)));
      }
    }
    EXPECT_EQ(late.devices().size(), 200U);
    EXPECT_FALSE(late.restatementOpen());
  }
}

TEST(Source, LongDrawingsAreSentInPartsAndErasedWhole) {
  Sender sender;
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(i, 0.1 * i, -1e-3 * i);
  ASSERT_EQ(sender->drawLine("path", 0xFF, points), SourceResult::done);
  SessionState state;
  PacketTextDecoder decoder;
  const auto hear = [&](Nanoseconds now) {
    for (const std::string& datagram : sender.flush(now)) {
      EXPECT_LE(datagram.size(), 1200U);
      state.apply(LogTime(now), *decoder.decode(bytesOf(datagram)));
    }
  };
  hear(0s);
  ASSERT_EQ(state.drawings().size(), 1U);
  std::size_t numbers = 0;
  for (const auto& part : state.drawings().begin()->second.parts) {
    ASSERT_TRUE(part);
    numbers += part->size();
  }
  EXPECT_EQ(numbers, 1500U);
  ASSERT_EQ(sender->drawLine("path", 0xFF, points), SourceResult::done);
  EXPECT_THAT(sender.flush(1ms), ElementsAre());
  ASSERT_EQ(sender->drawLabel("path", {}, "short"), SourceResult::done);
  hear(2ms);
  EXPECT_EQ(state.drawings().begin()->second.kind, StatementKind::label);
  ASSERT_EQ(sender->erase("path"), SourceResult::done);
  hear(3ms);
  EXPECT_TRUE(state.drawings().empty());
}

TEST(Source, AForgottenDeviceFallsBackWithTheNextRestatement) {
  Sender sender;
  const SourceDevice box = sender->device("box");
  const SourceDevice arm = sender->device("arm");
  ASSERT_EQ(sender->add(box, "box"), SourceResult::done);
  ASSERT_EQ(sender->setJoints(arm, kValues), SourceResult::done);
  SessionState state;
  PacketTextDecoder decoder;
  const auto hear = [&](Nanoseconds now) {
    for (const std::string& datagram : sender.flush(now)) {
      state.apply(LogTime(now), *decoder.decode(bytesOf(datagram)));
    }
  };
  hear(0s);
  ASSERT_EQ(sender->forget(box), SourceResult::done);
  EXPECT_EQ(sender->add(box, "box"), SourceResult::no_device);
  hear(1s);
  EXPECT_EQ(state.devices().count("box"), 1U);
  hear(2s);
  EXPECT_EQ(state.devices().count("box"), 0U);
  EXPECT_EQ(state.devices().count("arm"), 1U);
  // Its handle stays invalid when its place is taken.
  EXPECT_NE(sender->device("other").handle, box.handle);
  EXPECT_EQ(sender->remove(box), SourceResult::no_device);
}

TEST(Source, NamesThatComeAndGoTakeNoMemory) {
  SourceSettings settings;
  settings.memory_bytes = 40'000;
  Sender sender(settings);
  for (int i = 0; i < 10'000; ++i) {
    const SourceDevice box = sender->device("box_" + std::to_string(i));
    ASSERT_EQ(sender->add(box, "box"), SourceResult::done);
    ASSERT_EQ(sender->setPose(box, {}, {"arm", "tip", false}), SourceResult::done);
    ASSERT_EQ(sender->event("there"), SourceResult::done);
    sender.flush(i * 10ms);
    ASSERT_EQ(sender->remove(box), SourceResult::done);
    ASSERT_EQ(sender->forget(box), SourceResult::done);
    const auto sent = sender.flush(i * 10ms + 5ms);
    ASSERT_THAT(sent.front(), HasSubstr("remove box_"));
  }
}

TEST(Source, RefusesWithASentenceAndChangesNothing) {
  Sender sender;
  const SourceDevice arm = sender->device("arm");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sender->device("").handle, static_cast<int>(SourceResult::bad_name));
  EXPECT_EQ(sender->device(std::string(256, 'a')).ok(), false);
  EXPECT_EQ(sender->device(std::string_view("a\0b", 3)).ok(), false);
  EXPECT_EQ(sender->device("\xFF").ok(), false);
  EXPECT_EQ(sender->setJoints(sender->device("a\nb"), kValues), SourceResult::bad_name);
  EXPECT_EQ(sender->setJoints({}, kValues), SourceResult::no_device);
  EXPECT_EQ(sender->setJoints(arm, {}), SourceResult::bad_argument);
  EXPECT_EQ(sender->setJoints(arm, std::array{nan}), SourceResult::bad_number);
  EXPECT_EQ(sender->setJoints(arm, std::array{0x1p53}), SourceResult::bad_number);
  EXPECT_EQ(sender->setJoints(arm, std::vector<double>(600, 0.5)), SourceResult::too_long);
  EXPECT_EQ(sender->setOrder(arm, std::array<std::string_view, 2>{"a", "a"}),
            SourceResult::bad_argument);
  EXPECT_EQ(sender->setPose(arm, {{}, Quat(0.5, 0, 0, 0)}), SourceResult::bad_pose);
  EXPECT_EQ(sender->setPose(arm, {}, {"arm", "", false}), SourceResult::bad_name);
  EXPECT_EQ(sender->drawLine("path", 0, {}), SourceResult::bad_argument);
  EXPECT_EQ(sender->drawLine("path", 0, std::array{Vec3{}}, 0), SourceResult::bad_argument);
  EXPECT_EQ(sender->drawLabel("goal", {}, "\x01"), SourceResult::bad_text);
  EXPECT_EQ(sender->event(std::string(4097, 'a')), SourceResult::bad_text);
  EXPECT_EQ(sender->event(std::string(1200, 'a')), SourceResult::too_long);
  EXPECT_EQ(sender->setView("v", {}), SourceResult::bad_argument);
  EXPECT_THAT(sender.flush(1s), ElementsAre());
  EXPECT_EQ(sentenceOf(SourceResult::too_long), "the statement does not fit one datagram");

  EXPECT_EQ(Source::open({}, [](auto) { return true; }).error().text(),
            "a name is not 1 to 255 bytes of UTF-8 without control characters");
  SourceSettings settings;
  settings.source = "arm";
  settings.max_datagram = 60;
  EXPECT_THAT(Source::open(settings, [](auto) { return true; }).error().text(),
              HasSubstr("leaves no room"));
}

TEST(Source, FullMemoryIsAResultAndTheRestStays) {
  SourceSettings settings;
  settings.memory_bytes = 32'000;
  Sender sender(settings);
  int declared = 0;
  SourceResult result = SourceResult::done;
  while (result == SourceResult::done) {
    const SourceDevice device = sender->device("device_" + std::to_string(declared));
    result = sender->setJoints(device, kValues);
    declared += result == SourceResult::done;
    ASSERT_LT(declared, 1000);
  }
  EXPECT_EQ(result, SourceResult::full);
  EXPECT_GT(declared, 10);
  std::string all;
  for (const std::string& datagram : sender.flush(0s)) all += datagram;
  EXPECT_EQ(static_cast<int>(std::count(all.begin(), all.end(), '\n')) -
                static_cast<int>(sender.sent.size()),
            2 * declared);
}

TEST(Source, ADatagramThatCouldNotBeSentIsMadeUpFor) {
  Sender sender;
  const SourceDevice arm = sender->device("arm");
  ASSERT_EQ(sender->setJoints(arm, kValues), SourceResult::done);
  sender.is_connected = false;
  sender.flush(0s);
  EXPECT_EQ(sender.result, SourceResult::not_sent);
  sender.is_connected = true;
  EXPECT_THAT(sender.flush(2s), ElementsAre("RK1 cell@1 1 2 restated part=r1:1/1\norder arm\n"
                                            "joints arm 0.5 -1\n"));
  EXPECT_EQ(sender.result, SourceResult::done);
}

TEST(Source, RoomBehindADatagramIsTheCallers) {
  SourceSettings settings;
  settings.source = "arm";
  settings.reserved_bytes = 64;
  std::string signed_text;
  auto source = Source::open(settings, [&](std::span<std::byte> datagram) {
                  const std::string_view signature = "sig key c2ln\n";
                  char* const bytes = reinterpret_cast<char*>(datagram.data());
                  signature.copy(bytes + datagram.size(), signature.size());
                  signed_text.assign(bytes, datagram.size() + signature.size());
                  return true;
                }).value();
  ASSERT_EQ(source.event("a"), SourceResult::done);
  ASSERT_EQ(source.flush(Nanoseconds(0), std::nullopt), SourceResult::done);
  EXPECT_EQ(signed_text, "RK1 arm 0 -\nevent \"a\"\nsig key c2ln\n");
}

}  // namespace
}  // namespace rocinante
