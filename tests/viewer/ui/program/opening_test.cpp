#include "viewer/ui/program/opening.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include "core/net/udp_socket.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/kept_datagrams.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr const char* kWouldBeLost =
    "what this session kept would be deleted: `save` what you need, then `disconnect forget`";
constexpr const char* kWouldBeLostBehind =
    "what the session that goes on behind this kept would be deleted: `live` shows it; `save` what "
    "you need, then `disconnect forget`";
constexpr const char* kFull =
    "this window keeps 4 live sessions: `save` what you need, then `disconnect forget`";

SteadyTime presentTime() { return std::chrono::steady_clock::now(); }

/// The address of a port of 127.0.0.1 that was free a moment ago.
std::string unusedAddress() {
  auto probe = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  return "udp://127.0.0.1:" + std::to_string(probe->boundAddress().port);
}

/// A window without a window: what it shows, and what gives way to what.
class OpeningInAWindow : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeSession(folder_ / "s.mcap", {{0, "joints arm 2\n"}, {1000, "joints arm 3\n"}});
  }
  /// What becomes of it: what is shown then, or a sentence.
  std::string done(const std::function<Status(Opening&)>& ask) {
    Opening opening(loader_, left_, *content_);
    const Status begun = ask(opening);
    if (!begun) return begun.error().what;
    if (const auto meanwhile = std::exchange(meanwhile_, nullptr)) meanwhile();
    auto loaded = opening.take(true);
    if (!loaded.ok()) return loaded.error().text();
    if (!*loaded) return "nothing";
    if ((*loaded)->content == nullptr) return (*loaded)->fault;
    std::unique_ptr<ViewContent> next = std::move((*loaded)->content);
    left_.leave(std::move(content_), *next);
    content_ = std::move(next);
    return model().viewer.is_empty ? "an empty window" : content_->request.title();
  }
  std::string connect(const std::vector<std::string>& endpoints) {
    return done([&](Opening& opening) { return opening.connect(endpoints); });
  }
  std::string open(const std::vector<std::filesystem::path>& files) {
    return done([&](Opening& opening) { return opening.open(files); });
  }
  /// "beside" when it is, or is ended.
  std::string beside(const std::filesystem::path& file, const std::string& align = {}) {
    const std::string came = done([&](Opening& opening) {
      return opening.showBeside({file, align});
    });
    const bool is_shown = came.empty() || (file.empty() && came == "nothing");
    EXPECT_TRUE(model().update(presentTime()).ok());
    return is_shown ? "beside" : came;
  }
  std::string goBack() {
    return done([](Opening& opening) { return opening.goBack(); });
  }
  std::string disconnect(bool forgets) {
    return done([&](Opening& opening) { return opening.disconnect(forgets); });
  }
  ViewModel& model() { return *content_->model; }
  /// What is to be said of a live session that was ended.
  std::string ended() { return model().viewer.panels.open.ended; }
  /// Sends until the shown session, or else those behind it, have heard it, and keep it.
  void say(const std::string& endpoint, const std::string& statement,
           const std::function<bool()>& heard) {
    auto sender = UdpSender::open(Endpoint::parse(endpoint).value());
    ASSERT_TRUE(sender.ok());
    const SteadyTime began = presentTime();
    for (; !heard(); ++sequence_) {
      ASSERT_LT(presentTime() - began, 30s);
      const std::string text = "RK1 me@a " + std::to_string(sequence_) + " -\n" + statement;
      ASSERT_TRUE(sender->send(bytesOf(text)).ok());
      ASSERT_TRUE(model().update(presentTime()).ok());
      std::this_thread::sleep_for(5ms);
    }
  }
  /// Connects, and waits until something is heard; the endpoint.
  std::string connectAndHear() {
    std::string endpoint = unusedAddress();
    connect({endpoint});
    hear(endpoint);
    return endpoint;
  }
  void hear(const std::string& endpoint) {
    say(endpoint, "pose box 1 2 3 0 0 0 1\n", [&] { return hasHeard(model()); });
  }
  /// Leaves three that have heard something; their endpoints, the one shown last first.
  std::vector<std::string> leaveThree() {
    std::vector<std::string> endpoints;
    for (int i = 0; i < 3; ++i) endpoints.insert(endpoints.begin(), connectAndHear());
    EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
    EXPECT_EQ(left_.names(), endpoints);
    return endpoints;
  }
  double turn() {
    const DeviceState* const arm = model().state().findDevice("arm");
    return arm != nullptr && arm->joints ? arm->joints->value.front() : -1;
  }

  const test::TemporaryFolder folder_;
  const test::Environment environment_{{{"XDG_CACHE_HOME", (folder_ / "cache").string()}}};
  ContentLoader loader_;
  LeftSessions left_;
  std::unique_ptr<ViewContent> content_ = std::make_unique<ViewContent>(emptyContent());
  std::function<void()> meanwhile_;  ///< what happens once while something is loaded
  int sequence_ = 0;
};

TEST_F(OpeningInAWindow, ALiveSessionGoesOnBehindALogAndIsGoneBackTo) {
  const std::string endpoint = unusedAddress();
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_TRUE(model().setVisible("arm/hand", false));
  EXPECT_EQ(connect({endpoint}), "arm.urdf");
  ASSERT_TRUE(model().isLive());
  EXPECT_EQ(model().hiddenPaths(), std::vector<std::string>{"arm/hand"}) << "as it was chosen";
  say(endpoint, "joints arm 0.5\n", [&] { return turn() == 0.5 && model().cursor() != nullptr; });
  const ViewModel* const live = &model();
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_FALSE(model().isLive());
  EXPECT_EQ(model().cell().devices.size(), 1U) << "with the cell that was shown";
  EXPECT_EQ(left_.names(), std::vector<std::string>{endpoint});
  // It is heard and kept meanwhile.
  const std::uint64_t before = left_.model(0).feed().keeper()->progress().datagrams;
  say(endpoint, "joints arm 0.75\n",
      [&] { return left_.model(0).feed().keeper()->progress().datagrams > before + 3; });
  left_.tend(presentTime());
  EXPECT_EQ(goBack(), "arm.urdf");
  EXPECT_EQ(&model(), live);
  EXPECT_TRUE(model().viewer.was_shown);
  say(endpoint, "joints arm 0.75\n", [&] { return turn() == 0.75; });
  EXPECT_GT(model().live()->datagrams, before + 3);
  ASSERT_NE(model().cursor(), nullptr) << "its past is there";
  EXPECT_TRUE(left_.empty());
}

TEST_F(OpeningInAWindow, AnEndpointIsLeftForAnotherAndConnectedToAgain) {
  const std::string first = unusedAddress(), second = unusedAddress();
  EXPECT_EQ(connect({first}), first) << "without a cell";
  say(first, "pose box 1 2 3 0 0 0 1\n", [&] { return model().scene().findDevice("box"); });
  EXPECT_EQ(connect({first}), "this window listens at " + first + " already");
  EXPECT_EQ(connect({second}), second);
  EXPECT_EQ(left_.names(), std::vector<std::string>{first});
  EXPECT_EQ(connect({first}), first);
  EXPECT_NE(model().scene().findDevice("box"), nullptr) << "what it heard is still there";
  EXPECT_TRUE(left_.empty()) << "nothing was heard at the second";
}

TEST_F(OpeningInAWindow, ACellTakesTheLiveSessionAlong) {
  const std::string endpoint = unusedAddress();
  EXPECT_EQ(connect({endpoint}), endpoint);
  say(endpoint, "joints arm 0.5\n", [&] { return model().cursor() != nullptr; });
  const std::uint64_t heard = model().live()->datagrams;
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  ASSERT_TRUE(model().isLive());
  EXPECT_TRUE(left_.empty());
  ASSERT_TRUE(model().update(presentTime()).ok());
  EXPECT_EQ(turn(), 0.5);
  EXPECT_GE(model().live()->datagrams, heard);
  say(endpoint, "joints arm 0.25\n", [&] { return turn() == 0.25 && model().cursor() != nullptr; });
  EXPECT_EQ(endpointsText(content_->request), endpoint);
  // Gone back to, it takes nothing along any more.
  const ViewModel* const taken_along = &model();
  const std::string second = unusedAddress();
  EXPECT_EQ(connect({second}), "arm.urdf");
  EXPECT_EQ(left_.names(), std::vector<std::string>{endpoint});
  hear(second);
  EXPECT_EQ(goBack(), "arm.urdf");
  EXPECT_EQ(&model(), taken_along);
  EXPECT_EQ(endpointsText(content_->request), endpoint);
  EXPECT_EQ(left_.names(), std::vector<std::string>{second});
  ASSERT_TRUE(model().update(presentTime()).ok());
  EXPECT_EQ(turn(), 0.25);
  ASSERT_NE(model().cursor(), nullptr) << "its past is there";
  const std::uint64_t before = model().live()->datagrams;
  say(endpoint, "joints arm 0.75\n", [&] { return turn() == 0.75; });
  EXPECT_GT(model().live()->datagrams, before);
}

TEST_F(OpeningInAWindow, DisconnectingAsksBeforeSomethingIsLost) {
  const std::string endpoint = unusedAddress();
  EXPECT_EQ(disconnect(false), "this window listens nowhere");
  EXPECT_EQ(goBack(), "no live session goes on behind what is shown");
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(connect({endpoint}), "arm.urdf");
  say(endpoint, "joints arm 0.5\n", [&] { return turn() == 0.5; });
  EXPECT_EQ(disconnect(false), kWouldBeLost);
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_EQ(disconnect(false), kWouldBeLostBehind);
  EXPECT_EQ(goBack(), "arm.urdf") << "where it can be saved, as the sentence says";
  EXPECT_EQ(disconnect(false), kWouldBeLost);
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_EQ(disconnect(true), "nothing");
  EXPECT_TRUE(left_.empty());
  const std::string of_left = ended(), deleted = "; what it kept is deleted: ";
  EXPECT_TRUE(of_left.starts_with("disconnected from " + endpoint + deleted)) << of_left;
  EXPECT_NE(of_left.find(" datagram"), std::string::npos) << of_left;
  // The port is free again, and the cell stays.
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(connect({endpoint}), "arm.urdf");
  EXPECT_EQ(disconnect(false), "arm.urdf") << "nothing was heard";
  EXPECT_EQ(ended(), "disconnected from " + endpoint + ", where nothing was heard");
  EXPECT_FALSE(model().isLive());
  EXPECT_TRUE(left_.empty());
}

TEST_F(OpeningInAWindow, WhatIsHeardWhileASessionEndsIsLostOnlyWhenItIsToBeForgotten) {
  const std::string endpoint = unusedAddress();
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(connect({endpoint}), "arm.urdf");
  meanwhile_ = [&] { hear(endpoint); };
  const ViewModel* const shown = &model();
  EXPECT_EQ(disconnect(false), kWouldBeLost);
  EXPECT_EQ(&model(), shown);
  EXPECT_TRUE(hasHeard(model()));
  EXPECT_EQ(disconnect(true), "arm.urdf");
  EXPECT_TRUE(ended().starts_with("disconnected from " + endpoint + "; what it kept is deleted: "))
      << ended();
  EXPECT_FALSE(model().isLive());
  EXPECT_EQ(connect({endpoint}), "arm.urdf");
  EXPECT_EQ(ended(), "") << "said of one change";
  meanwhile_ = [&] { hear(endpoint); };
  EXPECT_EQ(disconnect(true), "arm.urdf");
  EXPECT_FALSE(model().isLive());
  EXPECT_TRUE(left_.empty());
}

TEST_F(OpeningInAWindow, WhatIsHeardJustBeforeASessionEndsGoesOnBehind) {
  const std::string endpoint = connectAndHear();
  auto next = std::make_unique<ViewContent>(emptyContent());
  next->request = withoutConnection(content_->request, false);
  left_.leave(std::move(content_), *next);
  content_ = std::move(next);
  EXPECT_EQ(left_.names(), std::vector<std::string>{endpoint});
  EXPECT_EQ(ended(), endpoint + " was heard just now and goes on behind this: `live` shows it");
  EXPECT_EQ(content_->request.leaving, ContentRequest::Leaving::stays_behind) << "held for once";
}

TEST_F(OpeningInAWindow, OthersGetTheFarewellOfASessionThatIsLeft) {
  connectAndHear();
  const auto kept = std::make_shared<test::KeptDatagrams::Kept>();
  ASSERT_TRUE(model().publishing.begin(std::make_unique<test::KeptDatagrams>(kept), {"ann", "r"}));
  model().publishing.sendDue(model().cameraView(), presentTime(), WallTime(1s));
  ASSERT_FALSE(kept->texts.empty());
  EXPECT_NE(kept->texts.back().find("view ann "), std::string::npos);
  kept->texts.clear();
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_EQ(left_.model(0).publishing.active(), nullptr);
  ASSERT_FALSE(kept->texts.empty());
  EXPECT_TRUE(kept->texts.back().ends_with(" restated part=end1:1/1\n")) << kept->texts.back();
}

TEST_F(OpeningInAWindow, AWindowKeepsFourLiveSessions) {
  for (int i = 0; i < 4; ++i) {
    const std::string endpoint = unusedAddress();
    EXPECT_EQ(connect({endpoint}), endpoint);
    say(endpoint, "pose box 1 2 3 0 0 0 1\n", [&] { return model().scene().findDevice("box"); });
  }
  EXPECT_EQ(connect({unusedAddress()}), kFull);
  EXPECT_EQ(open({folder_ / "s.mcap"}), kFull);
  EXPECT_EQ(disconnect(true), "an empty window");
  EXPECT_EQ(left_.names().size(), 3U);
}

TEST_F(OpeningInAWindow, WithFourLiveSessionsOneGoesFromEachToEach) {
  const std::vector<std::string> left = leaveThree();
  const std::string fourth = connectAndHear();
  EXPECT_EQ(goBack(), left[0]);
  EXPECT_EQ(left_.names(), (std::vector<std::string>{fourth, left[1], left[2]}));
  EXPECT_EQ(connect({left[2]}), left[2]);
  EXPECT_EQ(left_.names(), (std::vector<std::string>{left[0], fourth, left[1]}));
  EXPECT_EQ(connect({left[2]}), "this window listens at " + left[2] + " already");
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(endpointsText(content_->request), left[2]) << "it went along";
  EXPECT_EQ(left_.names(), (std::vector<std::string>{left[0], fourth, left[1]}));
  EXPECT_EQ(goBack(), left[0]);
  EXPECT_EQ(left_.names(), (std::vector<std::string>{left[2], fourth, left[1]}));
}

TEST_F(OpeningInAWindow, AFourthThatIsHeardWhileSomethingIsLoadedStays) {
  const std::vector<std::string> left = leaveThree();
  const std::string fourth = unusedAddress();
  connect({fourth});
  ASSERT_TRUE(model().isLive());
  const ViewModel* const shown = &model();
  EXPECT_EQ(connect({unusedAddress()}), kFull) << "both may be heard before it is there";
  meanwhile_ = [&] { hear(fourth); };
  EXPECT_EQ(open({folder_ / "s.mcap"}), std::string("s.mcap is not shown: ") + kFull);
  EXPECT_EQ(&model(), shown);
  EXPECT_TRUE(hasHeard(model()));
  EXPECT_EQ(left_.names(), left);
}

TEST_F(OpeningInAWindow, AFourthThatIsHeardWhileItEndsStays) {
  const std::vector<std::string> left = leaveThree();
  const std::string fourth = unusedAddress();
  connect({fourth});
  const ViewModel* const shown = &model();
  meanwhile_ = [&] { hear(fourth); };
  EXPECT_EQ(disconnect(false), kWouldBeLost);
  EXPECT_EQ(&model(), shown);
  EXPECT_EQ(left_.names(), left);
  EXPECT_EQ(disconnect(true), "an empty window");
  EXPECT_EQ(left_.names(), left);
}

TEST_F(OpeningInAWindow, AFourthThatHasHeardNothingGivesWay) {
  const std::vector<std::string> left = leaveThree();
  connect({unusedAddress()});
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_EQ(left_.names(), left);
  connect({unusedAddress()});
  disconnect(false);
  EXPECT_FALSE(model().isLive());
  EXPECT_EQ(left_.names(), left);
  connectAndHear();
  EXPECT_EQ(left_.names(), left);
}

TEST_F(OpeningInAWindow, ALogComesBesideTheOneThatIsShownAndGoesAgain) {
  test::writeSession(folder_ / "b.mcap", {{0, "joints arm 2.5\n"}, {1000, "joints arm 3\n"}});
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  const ViewModel* const shown = &model();
  model().cursor()->seek(test::sessionTime(500), presentTime());
  EXPECT_TRUE(model().setVisible("arm/hand", false));
  model().viewer.panels.notes.push_back({"of the cell", true});
  ASSERT_TRUE(model().update(presentTime()).ok());
  EXPECT_EQ(beside(folder_ / "b.mcap"), "beside");
  EXPECT_EQ(&model(), shown) << "moment, view and choices are those from before";
  EXPECT_EQ(model().shownTime(), test::sessionTime(500));
  EXPECT_EQ(model().hiddenPaths(), std::vector<std::string>{"arm/hand"});
  EXPECT_EQ(model().viewer.panels.notes.size(), 1U);
  EXPECT_NE(model().scene().findDevice("beside:arm"), nullptr) << "drawn at once";
  EXPECT_EQ(content_->request.beside, folder_ / "b.mcap") << "for evidence";
  ASSERT_NE(model().partings(), nullptr);
  // In place of it another one, or the same otherwise aligned.
  model().beside_shown = false;
  EXPECT_EQ(beside(folder_ / "b.mcap", "-1s"), "beside");
  EXPECT_TRUE(model().beside_shown);
  EXPECT_EQ(content_->request.align, "-1s");
  EXPECT_FALSE(model().beside()->covers(test::sessionTime(500)));
  EXPECT_EQ(model().scene().findDevice("beside:arm"), nullptr);
  EXPECT_EQ(beside(folder_ / "b.mcap"), "beside");
  EXPECT_TRUE(model().setVisible("beside:arm", false));
  EXPECT_EQ(beside({}), "beside");
  EXPECT_EQ(model().beside(), nullptr);
  EXPECT_EQ(model().partings(), nullptr);
  EXPECT_EQ(model().scene().findDevice("beside:arm"), nullptr);
  EXPECT_EQ(model().hiddenPaths(), std::vector<std::string>{"arm/hand"});
  EXPECT_TRUE(content_->request.beside.empty() && content_->request.align.empty());
}

TEST_F(OpeningInAWindow, WhatCannotBeBesideIsASentenceAndWhatIsShownStays) {
  test::writeSession(folder_ / "b.mcap", {{0, "joints arm 2.5\n"}});
  test::writeSession(folder_ / "empty.mcap", {});
  test::writeSession(folder_ / "other.mcap", {{0, "joints welder 1 2 3\n"}});
  test::writeSession(folder_ / "six.mcap", {{0, "joints arm 1 2 3 4 5 6\n"}});
  test::writeText(folder_ / "bad.mcap", "no log");
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(beside(folder_ / "b.mcap"), "a log is shown beside another one, and none is shown");
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_EQ(beside(folder_ / "b.mcap"), "beside");
  EXPECT_EQ(beside(folder_ / "gone.mcap"), "there is no such file");
  EXPECT_EQ(beside(folder_.path()), "a folder cannot be shown; open a file of it");
  EXPECT_EQ(beside(folder_ / "arm.urdf"), "only a log or another recording can be beside one");
  EXPECT_NE(beside(folder_ / "bad.mcap").find("bad.mcap"), std::string::npos);
  EXPECT_EQ(beside(folder_ / "empty.mcap"), "empty.mcap is not shown beside: it has no packets");
  EXPECT_EQ(beside(folder_ / "other.mcap"),
            "other.mcap is not shown beside: it moves nothing of this cell: welder is not a device "
            "of the cell and was not added");
  EXPECT_EQ(beside(folder_ / "six.mcap"),
            "six.mcap is not shown beside: it moves nothing of this cell: arm received 6 joint "
            "values, but its model has 1, so none is used");
  EXPECT_EQ(beside(folder_ / "b.mcap", "nowhere"),
            "b.mcap is not shown beside: `nowhere` aligns nothing: use origin, events, event:TEXT "
            "or an offset, as 2.5s");
  EXPECT_EQ(beside(folder_ / "b.mcap", "events"),
            "b.mcap is not shown beside: the two sessions have no event in common");
  ASSERT_NE(model().beside(), nullptr);
  EXPECT_EQ(model().beside()->session().log().name(), (folder_ / "b.mcap").string());
  EXPECT_EQ(content_->request.beside, folder_ / "b.mcap");
  EXPECT_TRUE(content_->request.align.empty());
  connectAndHear();
  EXPECT_EQ(beside(folder_ / "b.mcap"),
            "no log is shown beside a live session: `save` it, and open that");
}

TEST_F(OpeningInAWindow, ALogThatIsStillLoadedIsNotShownBesideOnceThatIsEnded) {
  test::writeSession(folder_ / "b.mcap", {{0, "joints arm 2.5\n"}});
  EXPECT_EQ(open({folder_ / "arm.urdf", folder_ / "s.mcap"}), "s.mcap");
  Opening opening(loader_, left_, *content_);
  const auto& comes = model().viewer.panels.open.beside_comes;
  EXPECT_TRUE(opening.showBeside({folder_ / "b.mcap", ""}));
  EXPECT_TRUE(comes);
  EXPECT_TRUE(opening.showBeside({}));
  EXPECT_FALSE(comes);
  EXPECT_EQ(opening.status()->waits_for, "it is not shown beside");
  auto loaded = opening.take(true);
  ASSERT_TRUE(loaded.ok() && *loaded);
  EXPECT_EQ((*loaded)->fault,
            "b.mcap is not shown beside: `beside none` came before it was loaded");
  EXPECT_EQ(model().beside(), nullptr);
  EXPECT_TRUE(opening.showBeside({folder_ / "b.mcap", ""}));
  EXPECT_EQ((*opening.take(true))->fault, "") << "the next one is";
  EXPECT_NE(model().beside(), nullptr);
  EXPECT_FALSE(comes);
  // One that cannot be read says that, and the next one is shown.
  test::writeText(folder_ / "bad.mcap", "no log");
  EXPECT_TRUE(opening.showBeside({folder_ / "bad.mcap", ""}));
  EXPECT_TRUE(opening.showBeside({}));
  EXPECT_EQ(model().beside(), nullptr);
  EXPECT_NE((*opening.take(true))->fault, "");
  EXPECT_TRUE(opening.showBeside({folder_ / "b.mcap", ""}));
  EXPECT_EQ((*opening.take(true))->fault, "");
}

TEST_F(OpeningInAWindow, WhatComesBesideEndsErrorsOfEarlierFiles) {
  test::writeSession(folder_ / "b.mcap", {{0, "joints arm 2.5\n"}});
  EXPECT_EQ(open({folder_ / "arm.urdf", folder_ / "s.mcap"}), "s.mcap");
  std::vector<PictureNote>& notes = model().viewer.panels.notes;
  notes = {{"of the cell", true}, {"gone.mcap", true, PictureNote::Of::failure}};
  EXPECT_EQ(beside(folder_ / "gone.mcap"), "there is no such file");
  EXPECT_EQ(notes.size(), 2U);
  EXPECT_EQ(beside(folder_ / "b.mcap"), "beside");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].text, "of the cell");
}

TEST_F(OpeningInAWindow, WhatIsDroppedWhileSomethingIsLoadedIsOpenedThen) {
  test::writeSession(folder_ / "b.mcap", {{0, "joints arm 2.5\n"}});
  meanwhile_ = [&] {
    Opening opening(loader_, left_, *content_);
    EXPECT_TRUE(opening.open({folder_ / "gone.mcap"}));
    EXPECT_TRUE(opening.open({folder_ / "s.mcap", folder_ / "b.mcap"}));
    EXPECT_EQ(opening.status()->waits_for, "gone.mcap and 2 more are opened then");
    EXPECT_FALSE(opening.connect({unusedAddress()}));
  };
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  const auto next = [&] { return done([](Opening&) { return Status(); }); };
  EXPECT_TRUE(Opening(loader_, left_, *content_).busy());
  EXPECT_NE(next().find("there is no such file"), std::string::npos) << "and the window stays";
  EXPECT_TRUE(Opening(loader_, left_, *content_).busy());
  EXPECT_EQ(next(), "s.mcap");
  EXPECT_NE(model().beside(), nullptr);
  EXPECT_FALSE(Opening(loader_, left_, *content_).busy());
  EXPECT_EQ(next(), "nothing");
}

TEST_F(OpeningInAWindow, ALogThatTakesThePlaceOfAnotherOffersThatBesideIt) {
  test::writeSession(folder_ / "b.mcap", {{0, "joints arm 2.5\n"}});
  std::string other = test::kArmUrdf;
  other.replace(other.find("\"arm\""), 5, "\"gripper\"");
  test::writeText(folder_ / "gripper.urdf", other);
  const auto offered = [&] { return model().viewer.panels.open.before; };
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_TRUE(offered().empty()) << "there was no log";
  EXPECT_EQ(open({folder_ / "b.mcap"}), "b.mcap");
  EXPECT_EQ(offered(), folder_ / "s.mcap");
  model().viewer.panels.open.openBeside(folder_.path());
  const std::vector<RecentContent> lines = model().viewer.panels.open.offered();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].log, folder_ / "s.mcap");
  EXPECT_EQ(open({folder_ / "b.mcap"}), "b.mcap");
  EXPECT_TRUE(offered().empty()) << "the same one";
  EXPECT_EQ(open({folder_ / "." / "b.mcap"}), "b.mcap");
  EXPECT_TRUE(offered().empty()) << "the same one, by another name";
  EXPECT_EQ(open({folder_ / "gripper.urdf", folder_ / "s.mcap"}), "s.mcap");
  EXPECT_TRUE(offered().empty()) << "of another cell";
  EXPECT_EQ(open({folder_ / "arm.urdf", folder_ / "s.mcap", folder_ / "b.mcap"}), "s.mcap");
  EXPECT_TRUE(offered().empty());
  ASSERT_NE(model().beside(), nullptr) << "two dropped together";
  EXPECT_EQ(content_->request.beside, folder_ / "b.mcap");
}

TEST_F(OpeningInAWindow, OfTwoLogsWithoutACellNoneIsOfferedBesideTheOther) {
  test::writeSession(folder_ / "welder.mcap", {{0, "pose welder 1 2 3 0 0 0 1\n"}});
  EXPECT_EQ(open({folder_ / "s.mcap"}), "s.mcap");
  EXPECT_EQ(open({folder_ / "welder.mcap"}), "welder.mcap");
  EXPECT_TRUE(model().viewer.panels.open.before.empty());
}

TEST_F(OpeningInAWindow, ADroppedLogOfAnotherCellIsNotBesideTheFirst) {
  test::writeSession(folder_ / "other.mcap", {{0, "joints welder 1 2 3\n"}});
  test::writeSession(folder_ / "more.mcap", {{0, "joints arm 1\njoints welder 1 2 3\n"}});
  const std::string sentence =
      "other.mcap is not shown beside: it moves nothing of this cell: welder is not a device of "
      "the cell and was not added";
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  EXPECT_EQ(open({folder_ / "s.mcap", folder_ / "other.mcap"}), "s.mcap");
  EXPECT_EQ(model().beside(), nullptr);
  EXPECT_TRUE(content_->request.beside.empty());
  ASSERT_FALSE(model().viewer.panels.notes.empty());
  EXPECT_EQ(model().viewer.panels.notes.back().text, sentence);
  EXPECT_TRUE(model().viewer.panels.notes.back().is_error);
  ASSERT_FALSE(content_->warnings.empty());
  EXPECT_EQ(content_->warnings.back(), sentence) << "in the terminal, too";
  // One that has a device too many is, and that is over the picture.
  EXPECT_EQ(open({folder_ / "s.mcap", folder_ / "more.mcap"}), "s.mcap");
  EXPECT_NE(model().beside(), nullptr);
  ASSERT_FALSE(model().viewer.panels.notes.empty());
  const std::string said = model().viewer.panels.notes.back().text;
  EXPECT_TRUE(said.starts_with("more.mcap: the cell has no device welder")) << said;
  EXPECT_EQ(content_->warnings.back(), said);
}

TEST(TheListBesideALog, HasOtherLogsAlone) {
  OpenState open;
  open.log = "/s/today.mcap";
  open.before = "/s/yesterday.mcap";
  open.recent = {{"/s/cell.toml", "/s/today.mcap"},
                 {"/s/cell.toml", ""},
                 {"/s/cell.toml", "/s/yesterday.mcap"},
                 {"/s/old.mcap", "/s/old.mcap"}};
  EXPECT_EQ(open.offered(), open.recent);
  open.openBeside("/");
  EXPECT_EQ(open.offered(),
            (std::vector<RecentContent>{{"", "/s/yesterday.mcap"}, {"", "/s/old.mcap"}}));
  EXPECT_TRUE(canBeBeside("a.mcap") && canBeBeside("bag/") && canBeBeside("t.csv"));
  EXPECT_FALSE(canBeBeside("a.cell.toml") || canBeBeside("A.URDF"));
  open.open("/");
  EXPECT_FALSE(open.beside);
}

TEST_F(OpeningInAWindow, BadEndpointsAreSentencesAndWhatIsShownStays) {
  EXPECT_EQ(open({folder_ / "arm.urdf"}), "arm.urdf");
  {
    Opening opening(loader_, left_, *content_);
    EXPECT_TRUE(opening.connect({"nonsense:host:99999"}));
    EXPECT_FALSE(opening.busy()) << "nothing is loaded for it";
    EXPECT_EQ((*opening.take(false))->fault,
              "an IPv6 address must be in brackets, as in [::1]:19960 (nonsense:host:99999)");
  }
  EXPECT_EQ(connect({"nonsense"}), "an endpoint needs a port, as in HOST:19960 (nonsense)");
  auto held = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(held.ok());
  const std::string taken = "127.0.0.1:" + std::to_string(held->boundAddress().port);
  const std::string is_taken = connect({taken});
  EXPECT_NE(is_taken.find(" is held by "), std::string::npos);
  EXPECT_EQ(is_taken.find("--tee"), std::string::npos) << "a window has no such option";
  EXPECT_FALSE(connect({"\x1B[31m%00\xFF:1"}).empty());
  EXPECT_FALSE(connect({std::string(100'000, '[') + ":1"}).empty());
  EXPECT_EQ(content_->request.title(), "arm.urdf");
  // A port of this window's own.
  const std::string endpoint = unusedAddress();
  EXPECT_EQ(connect({endpoint}), "arm.urdf");
  EXPECT_EQ(connect({endpoint.substr(6)}),
            "this window listens at that port itself: `disconnect` ends that, `live` shows what it "
            "left");
}

TEST(TypedText, HasNoPasswords) {
  EXPECT_EQ(typedText({"nats://ada:secret@robots/cell", ":19960"}),
            "nats://...@robots/cell :19960");
  EXPECT_EQ(typedText({"a\x1B"}), "a\\x1b");
}

}  // namespace
}  // namespace rocinante
