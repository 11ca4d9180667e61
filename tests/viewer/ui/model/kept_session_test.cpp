#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>
#include <thread>

#include "core/net/udp_socket.h"
#include "core/session/marks.h"
#include "core/session/message_folder.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_queue.h"
#include "tests/viewer/support/kept_datagrams.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

SteadyTime steadyClockNow() { return std::chrono::steady_clock::now(); }

/// A port of 127.0.0.1 that was free a moment ago.
Endpoint unusedEndpoint() {
  auto probe = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  Endpoint endpoint = Endpoint::parse("127.0.0.1:1").value();
  endpoint.address.port = probe->boundAddress().port;
  return endpoint;
}

/// A live window without a window: what it hears comes over the loopback interface.
class KeptSession : public testing::Test {
 protected:
  void open(const KeepLimits& keep) {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_ / "cell.toml",
                    "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n");
    auto cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    endpoint_ = unusedEndpoint();
    auto feed = LiveFeed::start({endpoint_}, nullptr, keep);
    ASSERT_TRUE(feed.ok()) << feed.error().text();
    auto model = ViewModel::make(std::move(*cell), std::nullopt, std::move(*feed), {}, {});
    ASSERT_TRUE(model.ok()) << model.error().text();
    model_.emplace(std::move(*model));
    ASSERT_TRUE(model_->update(steadyClockNow()).ok());
    auto sender = UdpSender::open(endpoint_);
    ASSERT_TRUE(sender.ok());
    sender_.emplace(std::move(*sender));
  }
  void send(int number, const std::string& statement) {
    const std::string text = "RK1 me@a " + std::to_string(number) + " -\n" + statement;
    ASSERT_TRUE(sender_->send(bytesOf(text)).ok());
  }
  /// Updates the model until it holds; fails after 30 s.
  void waitUntil(const std::function<bool()>& holds) {
    const SteadyTime began = steadyClockNow();
    while (!holds()) {
      ASSERT_LT(steadyClockNow() - began, 30s);
      ASSERT_TRUE(model_->update(steadyClockNow()).ok());
      std::this_thread::sleep_for(2ms);
    }
  }
  double joint() const {
    const DeviceState* const arm = model_->state().findDevice("arm");
    return arm != nullptr && arm->joints ? arm->joints->value.front() : -1;
  }
  /// Whether every drawing of the scene is one of the state that is there.
  bool drawsItsState() const {
    const auto& drawings = model_->state().drawings();
    return std::ranges::all_of(model_->scene().drawings, [&](const PosedDrawing& posed) {
      const auto found = drawings.find({posed.source, posed.id});
      return found != drawings.end() && &found->second == posed.drawing;
    });
  }
  fs::path keptFolder() const { return folder_ / "cache" / "rocinante" / "live"; }

  const test::TemporaryFolder folder_;
  const test::Environment environment_{{{"XDG_CACHE_HOME", (folder_ / "cache").string()}}};
  Endpoint endpoint_;
  std::optional<ViewModel> model_;
  std::optional<UdpSender> sender_;
};

TEST_F(KeptSession, TimeLineAndCurvesGrowWithIt) {
  open({});
  send(0, "joints arm 0.5");
  waitUntil([&] { return model_->cursor() != nullptr; });
  StudyQuery wish;
  wish.keys = {{SeriesKey::Kind::joint, "arm", "turn"}};
  wish.columns = wish.strip_columns = 100;
  for (int round = 1; round <= 3; ++round) {
    const bool next_piece = round == 3;
    if (next_piece) {
      ASSERT_TRUE(model_->logOfShownMoment().ok());
    }
    send(round, "joints arm " + std::to_string(round));
    std::shared_ptr<const StudyPicture> picture;
    waitUntil([&] {
      wish.from = model_->cursor()->start();
      wish.until = model_->cursor()->end();
      picture = model_->study()->show(wish);
      if (picture == nullptr || picture->curves.empty() || picture->curves[0].empty()) return false;
      const auto& curve = picture->curves[0];
      return std::ranges::any_of(curve, [&](const ValueColumn& column) {
        return column.held && std::lround(*column.held * 1000) == round * 1000;
      });
    });
    EXPECT_TRUE(picture->damaged.empty()) << round;
    EXPECT_EQ(picture->fault, "");
  }
  EXPECT_EQ(model_->findings(), nullptr) << "judged by its first moments";
}

TEST_F(KeptSession, DrivingStaysAtNowAndEndsInThePast) {
  open({});
  send(0, "joints arm 0.5");
  waitUntil([&] { return model_->cursor() != nullptr; });
  EXPECT_FALSE(model_->setByHand("arm", "turn", 1, steadyClockNow()));
  EXPECT_TRUE(model_->showsNow()) << "a refused move leaves now";
  const auto kept = std::make_shared<test::KeptDatagrams::Kept>();
  const auto drive = [&] {
    auto opened = HandDrive::into(std::make_unique<test::KeptDatagrams>(kept), {"me", "run1"});
    ASSERT_TRUE(opened.ok());
    model_->hand.drive(std::move(*opened));
  };
  const auto step = [&] {
    ASSERT_TRUE(model_->update(steadyClockNow()).ok());
    model_->hand.sendDue(steadyClockNow(), WallTime{});
  };
  model_->cursor()->pause(steadyClockNow());
  step();
  ASSERT_TRUE(model_->setByHand("arm", "turn", 9, steadyClockNow())) << "what if, in the past";
  drive();
  step();
  EXPECT_TRUE(model_->showsNow()) << "entering goes to now";
  EXPECT_TRUE(kept->texts.empty()) << kept->texts.front();
  ASSERT_TRUE(model_->setByHand("arm", "turn", 1, steadyClockNow()));
  step();
  EXPECT_TRUE(model_->showsNow());
  ASSERT_EQ(kept->texts.size(), 1U);
  EXPECT_TRUE(kept->texts[0].ends_with("\njoint arm turn=1\n")) << kept->texts[0];
  EXPECT_EQ(joint(), 0.5) << "the picture is what packets say";
  // Space, the time line, an event: whatever leaves now ends it.
  model_->cursor()->toggle(steadyClockNow());
  step();
  EXPECT_EQ(model_->hand.driving(), nullptr);
  EXPECT_FALSE(model_->hand.drawn()) << "what was driven is not drawn over the past";
  model_->cursor()->seek(model_->cursor()->start(), steadyClockNow());
  model_->cursor()->play(steadyClockNow());
  for (int i = 0; i < 5; ++i) {
    send(i + 1, "joints arm " + std::to_string(i));
    step();
  }
  EXPECT_TRUE(model_->goToNow());
  step();
  EXPECT_EQ(kept->texts.size(), 1U);
}

TEST_F(KeptSession, WhatIsDrawnIsOfTheStateThatIsThere) {
  open({});
  send(0, "label l 0 0 1 \"here\"");
  waitUntil([&] { return model_->cursor() != nullptr && model_->scene().drawings.size() == 1; });
  model_->cursor()->pause(steadyClockNow());
  for (int round = 1; round <= 20; ++round) {
    // The log grows, and lends another state for the same moment.
    const LogTime end = model_->session()->end();
    send(round, "joints arm " + std::to_string(round));
    waitUntil([&] {
      EXPECT_TRUE(drawsItsState()) << round;
      return model_->session()->end() > end;
    });
    EXPECT_TRUE(drawsItsState()) << round;
    ASSERT_TRUE(model_->logOfShownMoment().ok());
    EXPECT_TRUE(drawsItsState()) << round;
  }
  EXPECT_TRUE(model_->goToNow());
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  EXPECT_TRUE(drawsItsState());
}

TEST_F(KeptSession, ThePastIsShownWhileTheSessionGoesOn) {
  open({});
  send(0, "joints arm 0\nevent \"begun\"");
  waitUntil([&] { return model_->cursor() != nullptr && model_->events().size() == 1; });
  EXPECT_TRUE(model_->showsNow());
  for (int i = 1; i <= 20; ++i) {
    send(i, "joints arm " + std::to_string(i));
    std::this_thread::sleep_for(2ms);
  }
  waitUntil([&] { return joint() == 20; });
  TimelineCursor& cursor = *model_->cursor();
  // Paused: exactly what was shown, although the file does not have it yet.
  cursor.pause(steadyClockNow());
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  const LogTime paused = model_->shownTime();
  EXPECT_FALSE(model_->showsNow());
  EXPECT_EQ(joint(), 20);
  send(21, "joints arm 21");
  waitUntil([&] { return model_->live()->datagrams == 22 && model_->session()->end() > paused; });
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  EXPECT_EQ(joint(), 20);
  EXPECT_EQ(model_->shownTime(), paused);
  cursor.seek(cursor.start(), steadyClockNow());
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  EXPECT_EQ(joint(), 0);
  EXPECT_TRUE(model_->addMark("look").ok());
  EXPECT_EQ(model_->events().size(), 2U);
  EXPECT_TRUE(model_->goToNow());
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  EXPECT_EQ(joint(), 21);
  // For other programs: a whole log that has the moment.
  const auto log = model_->logOfShownMoment();
  ASSERT_TRUE(log.ok()) << log.error().text();
  auto reader = LogReader::open(*log);
  ASSERT_TRUE(reader.ok());
  EXPECT_TRUE(reader->summary().complete);
  EXPECT_EQ(reader->summary().messages, 22U);
  EXPECT_TRUE(reader->damage().empty());
  // And on in the next piece.
  send(22, "joints arm 22");
  waitUntil([&] { return joint() == 22 && model_->session()->end() == model_->live()->time; });
  EXPECT_EQ(model_->cursor()->start(), cursor.start());
  model_.reset();
  EXPECT_TRUE(fs::is_empty(keptFolder()));
}

TEST_F(KeptSession, KeepsEveryPacketOfABusySessionThatIsScrubbed) {
  KeepLimits limits;
  limits.time = 3s;  // pieces of 0.3 s
  open(limits);
  constexpr int kRate = 6000;
  constexpr int kCount = kRate;
  std::atomic<bool> done{false};
  std::thread source([&] {
    const SteadyTime began = steadyClockNow();
    for (int i = 0; i < kCount; ++i) {
      const SteadyTime due = began + Nanoseconds(1'000'000'000LL * i / kRate);
      while (steadyClockNow() < due) std::this_thread::sleep_for(200us);
      if (i % 100 == 0) test::waitUntilTaken(endpoint_.address.port);
      send(i, "joints arm " + std::to_string(i));
    }
    done.store(true);
  });
  std::mt19937 random(4);
  int scrubbed = 0;
  while (!done.load()) {
    if (!model_->update(steadyClockNow()).ok()) {
      ADD_FAILURE();
      break;
    }
    if (TimelineCursor* cursor = model_->cursor(); cursor && model_->session()) {
      // Back and forth; what is shown is what was sent then.
      const Nanoseconds length = model_->session()->end() - cursor->start();
      const Nanoseconds back(static_cast<std::int64_t>(random() % 1000) * (length.count() / 1000));
      cursor->pause(steadyClockNow());
      cursor->seek(cursor->start() + back, steadyClockNow());
      EXPECT_TRUE(model_->update(steadyClockNow()).ok());
      const double here = joint();
      cursor->step(5ms, steadyClockNow());
      EXPECT_TRUE(model_->update(steadyClockNow()).ok());
      EXPECT_GE(joint(), here);
      ++scrubbed;
      if (scrubbed % 5 == 0) model_->goToNow();
    }
    std::this_thread::sleep_for(1ms);
  }
  source.join();
  EXPECT_GT(scrubbed, 0);
  model_->goToNow();
  waitUntil([&] { return joint() == kCount - 1; });
  ASSERT_EQ(model_->live()->dropped, 0U);
  const auto last = model_->logOfShownMoment();
  ASSERT_TRUE(last.ok()) << last.error().text();
  const KeptProgress kept = model_->feed().keeper()->progress();
  EXPECT_EQ(kept.trouble, "");
  EXPECT_EQ(kept.lost, 0U);
  EXPECT_GT(kept.finished.size(), 2U);
  // Every number, once and in order.
  int next = 0;
  MessageFolder folder;
  for (const fs::path& piece : kept.finished) {
    auto reader = LogReader::open(piece);
    ASSERT_TRUE(reader.ok());
    EXPECT_TRUE(reader->summary().complete);
    while (true) {
      auto message = reader->next();
      ASSERT_TRUE(message.ok());
      if (!*message) break;
      if (!(*message)->channel->captured()) continue;
      const Packet* const packet = folder.decode(**message);
      ASSERT_NE(packet, nullptr);
      ASSERT_EQ(packet->header.sequence, static_cast<std::uint64_t>(next));
      ++next;
    }
  }
  EXPECT_EQ(next, kCount);
}

TEST_F(KeptSession, DeletesWhatIsOlderThanItsLimit) {
  KeepLimits limits;
  limits.time = 1s;
  open(limits);
  const SteadyTime began = steadyClockNow();
  int number = 0;
  waitUntil([&] {
    send(number, "joints arm " + std::to_string(number));
    ++number;
    return steadyClockNow() - began > 1800ms;
  });
  waitUntil([&] { return model_->cursor()->start() > model_->origin(); });
  const KeptProgress kept = model_->feed().keeper()->progress();
  EXPECT_LT(kept.finished.size(), 13U);
  // A moment that is gone becomes the first that is there.
  model_->cursor()->pause(steadyClockNow());
  model_->cursor()->seek(model_->origin(), steadyClockNow());
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  EXPECT_EQ(model_->shownTime(), model_->cursor()->start());
  EXPECT_GE(joint(), 0);
}

TEST_F(KeptSession, NoMomentIsShownThatWasDeletedWhileThePictureWaitedForTheLog) {
  KeepLimits limits;
  limits.time = 1s;
  open(limits);
  int number = 0;
  const auto sendNext = [&] {
    send(number, "joints arm " + std::to_string(number));
    ++number;
  };
  waitUntil([&] {
    sendNext();
    return model_->cursor() != nullptr;
  });
  // The file lags behind what is shown, and then the window is busy while its pieces come and go.
  model_->cursor()->pause(steadyClockNow());
  const fs::path first = model_->session()->log().name();
  const SteadyTime began = steadyClockNow();
  while (fs::exists(first)) {
    ASSERT_LT(steadyClockNow() - began, 30s);
    sendNext();
    std::this_thread::sleep_for(2ms);
  }
  model_->cursor()->seek(model_->origin(), steadyClockNow());
  ASSERT_TRUE(model_->update(steadyClockNow()).ok());
  EXPECT_GE(model_->shownTime(), model_->session()->start());
  EXPECT_GE(joint(), 0);
}

TEST_F(KeptSession, KeepsNothingWhenToldSo) {
  KeepLimits none;
  none.time = Nanoseconds(0);
  open(none);
  send(0, "joints arm 7");
  waitUntil([&] { return joint() == 7; });
  EXPECT_EQ(model_->cursor(), nullptr);
  EXPECT_FALSE(model_->logOfShownMoment().ok());
  EXPECT_FALSE(fs::exists(keptFolder()));
}

TEST_F(KeptSession, WithoutAPlaceToKeepItTheSessionIsLiveAllTheSame) {
  test::writeText(folder_ / "cache", "a file where the folder should be");
  open({});
  EXPECT_NE(model_->keepingTrouble(), "");
  send(0, "joints arm 7");
  waitUntil([&] { return joint() == 7; });
  EXPECT_EQ(model_->cursor(), nullptr);
}

TEST_F(KeptSession, GoesOnWhenItsLogIsDeletedUnderIt) {
  KeepLimits limits;
  limits.time = 1s;
  open(limits);
  send(0, "joints arm 0");
  waitUntil([&] { return model_->cursor() != nullptr; });
  fs::remove_all(keptFolder());
  int number = 1;
  waitUntil([&] {
    send(number, "joints arm " + std::to_string(number));
    ++number;
    return model_->keepingTrouble() != "";
  });
  waitUntil([&] { return joint() == number - 1; });
  if (model_->cursor() != nullptr) {
    model_->cursor()->seek(model_->cursor()->start(), steadyClockNow());
    EXPECT_TRUE(model_->update(steadyClockNow()).ok());
  }
}

}  // namespace
}  // namespace rocinante
