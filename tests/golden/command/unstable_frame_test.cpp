// Whole commands over frames that are drawn wrongly: each time otherwise, or always the same way.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/cell/cell.h"
#include "golden/command/commands.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::HasSubstr;

/// What is wrong with the drawing of a frame.
enum class Flaw : std::uint8_t {
  none,
  coplanar,     ///< where two boxes meet, a column of pixels is another each time
  left_behind,  ///< what was drawn before shows
  uninitialised,
  changed  ///< one pixel differs, always in the same way
};

/// What was asked of all drawers.
struct Drawings {
  int frames = 0, identities = 0;
};

/// The cell's own drawer, and then a flaw.
class FlawedDrawer : public FrameDrawer {
 public:
  FlawedDrawer(std::unique_ptr<FrameDrawer> sound, const Flaw& flaw, int context,
               Drawings& drawings)
      : sound_(std::move(sound)), flaw_(flaw), context_(context), drawings_(drawings) {}

  Result<Picture> frame(const FrameRequest& request) override {
    ++drawings_.frames;
    auto drawn = sound_->frame(request);
    if (!drawn.ok()) return drawn;
    const int turn = turns_++;
    if (flaw_ == Flaw::coplanar) {
      const auto scene = identity(request);
      if (!scene.ok()) return scene.error();
      addSeam(scene->frame, 20 * (turn + 3 * context_), *drawn);
    } else if (flaw_ == Flaw::left_behind) {
      drawn->rgba[4] = static_cast<std::uint8_t>(last_width_ == 0 ? request.width : last_width_);
    } else if (flaw_ == Flaw::uninitialised) {
      drawn->rgba[4] = static_cast<std::uint8_t>(100 * context_);
    } else if (flaw_ == Flaw::changed) {
      drawn->rgba[4] ^= 0x80;
    }
    last_width_ = request.width;
    return drawn;
  }
  Result<SceneIdentity> identity(const FrameRequest& request) override {
    ++drawings_.identities;
    return sound_->identity(request);
  }
  std::string renderer() const override { return sound_->renderer(); }
  const std::string& inputsHash() const override { return sound_->inputsHash(); }
  Result<std::vector<PicturedView>> views(const FrameRequest& request) override {
    return sound_->views(request);
  }
  Result<SessionState> state(const FrameRequest& request) override {
    return sound_->state(request);
  }
  const Cell& cell() const override { return sound_->cell(); }

 private:
  static void addSeam(const IdentityFrame& frame, int level, Picture& drawn) {
    for (std::size_t pixel = 1; pixel < frame.ids.size(); ++pixel) {
      const std::uint32_t here = frame.ids[pixel], before = frame.ids[pixel - 1];
      if (here == 0 || before == 0 || here == before) continue;
      drawn.rgba[pixel * 4] = static_cast<std::uint8_t>(level);
    }
  }

  std::unique_ptr<FrameDrawer> sound_;
  const Flaw& flaw_;
  int context_, turns_ = 0, last_width_ = 0;
  Drawings& drawings_;
};

class UnstableFrameTest : public testing::Test {
 protected:
  UnstableFrameTest() {
    const auto write = [&](const char* name, std::string_view text) {
      EXPECT_TRUE(writeFileWhole(folder_ / name, bytesOf(text), true).ok());
    };
    const auto box = [](const char* name, const char* x) {
      return std::string("<link name=\"") + name + "\"><visual><origin xyz=\"" + x +
             " 0 0\"/><geometry><box size=\"1 1 1\"/></geometry></visual></link>";
    };
    write("boxes.urdf", "<robot name=\"boxes\">" + box("left", "-0.5") + box("right", "0.5") +
                            "<joint name=\"seam\" type=\"fixed\"><parent link=\"left\"/>"
                            "<child link=\"right\"/></joint></robot>");
    write("suite.toml",
          "format = 1\ncell = \"boxes.urdf\"\n[[case]]\nname = \"pair\"\nsize = [64, 48]\n"
          "samples = 1\nhide = [\"layer/grid\", \"layer/gnomon\"]\n");
    arguments_.suite.suite = folder_ / "suite.toml";
    arguments_.files.folder = (folder_ / "report").string();
    arguments_.files.junit = (folder_ / "junit.xml").string();
    arguments_.files.json_file = (folder_ / "verdicts.json").string();
    arguments_.suite.drawers = [this]() -> Result<std::unique_ptr<FrameDrawer>> {
      auto cell = loadCell(folder_ / "boxes.urdf", {});
      if (!cell.ok()) return cell.error();
      auto sound = sceneDrawers(std::move(*cell), std::nullopt)();
      if (!sound.ok()) return sound.error();
      return std::unique_ptr<FrameDrawer>(
          std::make_unique<FlawedDrawer>(std::move(*sound), flaw_, contexts_++, drawings_));
    };
  }

  cli::Exit run() {
    contexts_ = 0;
    const auto exit = runSuiteCommand(arguments_);
    EXPECT_TRUE(exit.ok()) << exit.error().text();
    return exit.ok() ? *exit : cli::Exit::could_not_run;
  }

  cli::Exit approve() {
    contexts_ = 0;
    ApproveArguments arguments;
    arguments.suite = arguments_.suite;
    arguments.message = "looks right";
    const auto exit = runApproveCommand(arguments);
    EXPECT_TRUE(exit.ok()) << exit.error().text();
    return exit.ok() ? *exit : cli::Exit::could_not_run;
  }

  std::string textIn(const char* name) {
    auto text = readFile(folder_ / name);
    return text.ok() ? std::move(*text) : std::string();
  }

  nlohmann::json verdict() { return nlohmann::json::parse(textIn("verdicts.json"))["frames"][0]; }

  test::TemporaryFolder folder_;
  RunArguments arguments_;
  Flaw flaw_ = Flaw::none;
  int contexts_ = 0;
  Drawings drawings_;
};

TEST_F(UnstableFrameTest, AChangedFrameIsJudgedByFourDrawingsAndExplainedByOneIdentity) {
  EXPECT_EQ(approve(), cli::Exit::done);
  drawings_ = {};
  EXPECT_EQ(run(), cli::Exit::done);
  EXPECT_EQ(drawings_.frames, 1);
  EXPECT_EQ(drawings_.identities, 0);
  drawings_ = {};
  flaw_ = Flaw::changed;
  EXPECT_EQ(run(), cli::Exit::no);
  EXPECT_EQ(verdict()["verdict"], "different");
  EXPECT_EQ(contexts_, 2);
  // Itself, another one between, itself again, and itself in a context of its own.
  EXPECT_EQ(drawings_.frames, 4);
  EXPECT_EQ(drawings_.identities, 1);
}

TEST_F(UnstableFrameTest, IsAFailureOfItsOwnKindInEveryAnswer) {
  flaw_ = Flaw::coplanar;
  EXPECT_EQ(run(), cli::Exit::no);
  EXPECT_EQ(verdict()["verdict"], "unstable");
  const std::string rule = verdict()["rule"];
  EXPECT_THAT(rule, HasSubstr("at the border of boxes/left and boxes/right"));
  EXPECT_THAT(rule, HasSubstr("likely cause: coplanar surfaces"));
  const auto root = nlohmann::json::parse(textIn("verdicts.json"));
  EXPECT_EQ(root["verdict"], "different");
  EXPECT_EQ(root["counts"]["unstable"], 1);
  EXPECT_THAT(textIn("junit.xml"), HasSubstr("failures=\"1\" errors=\"0\""));
  EXPECT_THAT(textIn("junit.xml"), HasSubstr("<failure message=\"unstable: drawn again, "));
  const std::string page = textIn("report/index.html");
  EXPECT_THAT(page, HasSubstr("\"verdict\":\"unstable\""));
  EXPECT_THAT(page, HasSubstr("\"can_approve\":false"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report" / "pair.frame.png"));
}

TEST_F(UnstableFrameTest, NamesItsLikelyCause) {
  flaw_ = Flaw::left_behind;
  EXPECT_EQ(run(), cli::Exit::no);
  EXPECT_THAT(std::string(verdict()["rule"]),
              HasSubstr("1 pixel differs at 1,0,1x1; after another frame, not in a fresh context; "
                        "likely cause: state left by another frame"));
  flaw_ = Flaw::uninitialised;
  EXPECT_EQ(run(), cli::Exit::no);
  EXPECT_THAT(
      std::string(verdict()["rule"]),
      HasSubstr("in a fresh context, not after another frame; likely cause: uninitialised"));
}

TEST_F(UnstableFrameTest, IsNeverApprovedAndNeverPassesForAGoldenThatItMissed) {
  flaw_ = Flaw::coplanar;
  EXPECT_EQ(approve(), cli::Exit::no);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "goldens"));
  flaw_ = Flaw::none;
  EXPECT_EQ(approve(), cli::Exit::done);
  EXPECT_EQ(run(), cli::Exit::done);
  const std::string manifest = textIn("goldens/manifest.json");
  flaw_ = Flaw::coplanar;
  EXPECT_EQ(run(), cli::Exit::no);
  EXPECT_EQ(verdict()["verdict"], "unstable");
  EXPECT_EQ(approve(), cli::Exit::no);
  EXPECT_EQ(textIn("goldens/manifest.json"), manifest);
}

}  // namespace
}  // namespace rocinante
