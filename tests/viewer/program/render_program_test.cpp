// The same bits from every run of the program, whatever its environment says.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>

#include "tests/support/environment.h"
#include "tests/support/programs.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

using test::Environment;

std::string hashesOf(const std::vector<std::string>& arguments) {
  const test::ProgramResult result = test::runProgram("rocinante-render", arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(result.out.empty());
  return result.out;
}

TEST(RenderProgram, AHostileEnvironmentChangesNoPixel) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeArmSession(folder / "arm.mcap");
  const std::vector<std::string> arguments{
      folder / "arm.urdf", folder / "arm.mcap", "--hash", "--at", "4.25", "--at", "-1s"};
  const std::string plain = hashesOf(arguments);
  const std::vector<std::map<std::string, std::string>> environments{
      {{"LP_NATIVE_VECTOR_WIDTH", "256"}},
      {{"GALLIUM_DRIVER", "softpipe"}, {"LIBGL_ALWAYS_SOFTWARE", "0"}},
      {{"GALLIUM_OVERRIDE_CPU_CAPS", "nosse"}, {"LP_PERF", "no_mipmap,no_linear,no_tex"}},
      {{"GALLIVM_PERF", "brilinear,rho_approx,no_quad_lod,no_aos_sampling,nopt"}},
      {{"DRAW_USE_LLVM", "0"}},  // these two end in a crash or in wire frames where they are heard
      {{"ST_DEBUG", "wf"}},
      {{"TGSI_PRINT_SANITY", "1"}, {"NIR_DEBUG", "print"}},
      {{"MESA_GL_VERSION_OVERRIDE", "2.1"}, {"MESA_EXTENSION_OVERRIDE", "-GL_ARB_clip_control"}},
      {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}, {"TZ", "Asia/Kathmandu"}},
      {{"LP_NUM_THREADS", "0"}},
      {{"LP_NUM_THREADS", "1"}},
      {{"LP_NUM_THREADS", "2"}},
  };
  for (const auto& variables : environments) {
    SCOPED_TRACE(variables.begin()->first + "=" + variables.begin()->second);
    const Environment environment(variables);
    EXPECT_EQ(hashesOf(arguments), plain);
  }
}

// Each of these would choose another driver, another display, or none.
TEST(RenderProgram, EglDrawsTheBitsOfOsmesaWhateverTheEnvironmentSays) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeArmSession(folder / "arm.mcap");
  std::vector<std::string> arguments{folder / "arm.urdf",
                                     folder / "arm.mcap",
                                     "--hash",
                                     "--at",
                                     "4.25",
                                     "--at",
                                     "-1s",
                                     "--context",
                                     "osmesa"};
  const auto by_osmesa = test::runProgram("rocinante-render", arguments);
  arguments.back() = "egl";
  const std::string by_egl = hashesOf(arguments);
  if (by_osmesa.exit_code == 0) {
    EXPECT_EQ(by_egl, by_osmesa.out);
  } else {
    std::cout << "not compared with OSMesa: " << by_osmesa.err;
  }
  const std::vector<std::map<std::string, std::string>> environments{
      {{"DISPLAY", ":77"}, {"EGL_PLATFORM", "x11"}},
      {{"LIBGL_DRIVERS_PATH", "/nowhere"}, {"GALLIUM_DRIVER", "softpipe"}},
      {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/usr/share/glvnd/egl_vendor.d/10_nvidia.json"}},
      {{"__EGL_VENDOR_LIBRARY_DIRS", "/nowhere"}},
      {{"MESA_LOADER_DRIVER_OVERRIDE", "zink"}, {"LIBGL_ALWAYS_SOFTWARE", "0"}},
      {{"DRIRC_CONFIGDIR", "/nowhere"}, {"force_glsl_version", "110"}},
      {{"HOME", "/proc/nowhere"}, {"LP_NUM_THREADS", "0"}},
  };
  for (const auto& variables : environments) {
    SCOPED_TRACE(variables.begin()->first + "=" + variables.begin()->second);
    const Environment environment(variables);
    EXPECT_EQ(hashesOf(arguments), by_egl);
  }
}

TEST(RenderProgram, AnUnknownContextIsExitTwo) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  const Environment environment(
      std::map<std::string, std::string>{{"ROCINANTE_CONTEXT", "vulkan"}});
  const auto result = test::runProgram("rocinante-render", {folder / "arm.urdf", "--hash"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("ROCINANTE_CONTEXT is \"vulkan\", and may be osmesa or egl"),
            std::string::npos)
      << result.err;
}

// OSMesa reads none, EGL must see none; the same of the window is
// tests/cli/view/drirc_changes_nothing.sh.
TEST(RenderProgram, ADrircChangesNoPixel) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeArmSession(folder / "arm.mcap");
  const std::vector<std::string> arguments{folder / "arm.urdf", folder / "arm.mcap", "--hash",
                                           "--at", "4.25"};
  const std::string plain = hashesOf(arguments);
  test::writeText(folder / ".drirc", R"(<driconf><device><application name="all">
<option name="force_integer_tex_nearest" value="true"/>
<option name="force_glsl_version" value="110"/>
<option name="pp_celshade" value="1"/>
</application></device></driconf>)");
  const Environment environment({{"HOME", folder.path().string()},
                                 {"force_integer_tex_nearest", "true"},
                                 {"force_glsl_version", "110"}});
  EXPECT_EQ(hashesOf(arguments), plain);
  const Environment by_egl(std::map<std::string, std::string>{{"ROCINANTE_CONTEXT", "egl"}});
  EXPECT_EQ(hashesOf(arguments), plain);
}

TEST(RenderProgram, TwentyRunsGiveOneHash) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeArmSession(folder / "arm.mcap");
  const std::vector<std::string> arguments{folder / "arm.urdf", folder / "arm.mcap", "--hash",
                                           "--at", "5.5"};
  const std::string first = hashesOf(arguments);
  for (int run = 1; run < 20; ++run) EXPECT_EQ(hashesOf(arguments), first) << "run " << run;
}

class RenderSession : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeArmSession(folder_ / "arm.mcap");
  }
  test::ProgramResult render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"arm.urdf", "arm.mcap", "--size", "80x60"});
    return test::runProgram("rocinante-render", arguments, folder_.path());
  }
  bool there(const std::string& name) { return std::filesystem::exists(folder_ / name); }

  test::TemporaryFolder folder_;
};

TEST_F(RenderSession, ATimeOutsideTheLogIsExitTwoAndWritesNothing) {
  for (const char* time : {"10.001", "-10.001s", "1e9", "2020-01-01T00:00:00Z"}) {
    SCOPED_TRACE(time);
    const auto result = render({"--at", "1", "--at", time, "--sheet", "sheet.png"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(there("sheet.png"));
  }
  EXPECT_NE(render({"--at", "10.001", "--hash"})
                .err.find("10.001 is outside the log, which has 0.000 to 10.000 s"),
            std::string::npos);
  EXPECT_EQ(render({"--at", "10", "--hash"}).exit_code, 0);
}

TEST_F(RenderSession, AMomentIsWrittenInManyWaysAndIsOnePicture) {
  const std::string hash = render({"--at", "9", "--hash"}).out;
  EXPECT_EQ(hash.size(), 65U);
  for (const char* time : {"9.0s", "9000ms", "-1s", "2023-11-14T22:13:29Z", "9.05"}) {
    EXPECT_EQ(render({"--at", time, "--hash"}).out, hash) << time;
  }
  EXPECT_EQ(render({"--at", "9", "--at", "9.0s", "--hash"}).out, "9 " + hash + "9.0s " + hash);
}

TEST_F(RenderSession, FramesAndSheetsAreWrittenOnceAndReplacedOnlyByForce) {
  ASSERT_EQ(render({"--every", "2.5s", "--frames", "out", "--sheet", "sheet.png"}).exit_code, 0);
  for (const char* name : {"out/frame-00001.png", "out/frame-00005.png", "sheet.png"}) {
    EXPECT_TRUE(there(name)) << name;
  }
  EXPECT_FALSE(there("out/frame-00006.png"));
  const auto again = render({"--every", "2.5s", "--frames", "out"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("the file exists; --force replaces it"), std::string::npos);
  EXPECT_EQ(render({"--every", "2.5s", "--frames", "out", "--force"}).exit_code, 0);
}

TEST_F(RenderSession, OneFileForSeveralMomentsIsRefused) {
  EXPECT_EQ(render({"--at", "1", "--at", "2", "-o", "f.png"}).exit_code, 2);
  EXPECT_EQ(render({"--every", "1s", "-o", "f.png"}).exit_code, 2);
  EXPECT_EQ(render({"--every", "1ns", "--hash"}).exit_code, 2);
  EXPECT_EQ(render({"--every", "0s", "--hash"}).exit_code, 2);
  EXPECT_EQ(render({"--hash"}).exit_code, 2);
  EXPECT_FALSE(there("f.png"));
}

TEST_F(RenderSession, APictureThatCannotBeWrittenIsExitTwo) {
  EXPECT_EQ(render({"--at", "1", "-o", "no/such/folder/f.png"}).exit_code, 2);
}

/// Every 100th sample of the real Panda's motion, named as its joints are.
std::vector<std::pair<std::int64_t, std::string>> pandaMotion() {
  std::ifstream file(test::sharedData("recordings/panda_exciting_trajectory/panda_joints.csv"));
  std::string line;
  std::getline(file, line);
  std::vector<std::string> names;
  const auto fieldsOf = [](const std::string& row) {
    std::vector<std::string> fields;
    std::size_t from = 0;
    for (std::size_t comma = 0; comma != std::string::npos; from = comma + 1) {
      comma = row.find(',', from);
      fields.push_back(row.substr(from, comma - from));
    }
    return fields;
  };
  if (!line.empty() && line.back() == '\r') line.pop_back();
  names = fieldsOf(line);
  std::vector<std::pair<std::int64_t, std::string>> packets;
  double begin = -1;
  for (int row = 0; std::getline(file, line); ++row) {
    if (row % 100 != 0) continue;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto fields = fieldsOf(line);
    double time = 0;
    std::from_chars(fields[0].data(), fields[0].data() + fields[0].size(), time);
    if (begin < 0) begin = time;
    std::string text = "joint panda";
    for (std::size_t i = 1; i < fields.size(); ++i) text += " " + names[i] + "=" + fields[i];
    packets.emplace_back(static_cast<std::int64_t>((time - begin) * 1000), text + "\n");
  }
  return packets;
}

TEST(RenderProgram, TheRealPandaInTheWasteYardIsStable) {
  ROCINANTE_NEEDS_SHARED_DATA("env/waste_yard");
  const test::TemporaryFolder folder;
  test::writeSession(folder / "panda.mcap", pandaMotion());
  test::writeText(
      folder / "yard.cell.toml",
      "format = 1\nsearch = [\"" + test::sharedData("robots/franka_panda").string() + "\", \"" +
          test::sharedData("env/waste_yard").string() +
          "\"]\n"
          "[[device]]\nname = \"panda\"\nmodel = \"panda.urdf\"\n"
          "[[device]]\nname = \"yard\"\nmodel = \"yard\"\n"
          "[[model]]\nname = \"yard\"\nobj = \"waste_yard.obj\"\nunit = \"m\"\nup = \"z\"\n"
          "[[camera]]\nname = \"near\"\neye = [2.2, -1.9, 1.3]\ntarget = [-0.6, 1.2, 0.7]\n");
  const std::vector<std::string> arguments{folder / "yard.cell.toml",
                                           folder / "panda.mcap",
                                           "--hash",
                                           "--at",
                                           "2",
                                           "--at",
                                           "9.5",
                                           "--at",
                                           "-1s",
                                           "--size",
                                           "320x240"};
  const std::string first = hashesOf(arguments);
  // Three moments, three pictures.
  std::map<std::string, int> hashes;
  for (std::size_t at = 0, end = 0; (end = first.find('\n', at)) != std::string::npos;
       at = end + 1) {
    ++hashes[first.substr(first.find(' ', at), end - first.find(' ', at))];
  }
  EXPECT_EQ(hashes.size(), 3U) << first;
  const int runs = ::getenv("ROCINANTE_LONG") != nullptr ? 20 : 5;
  for (int run = 1; run < runs; ++run) {
    const std::map<std::string, std::string> threads{{"LP_NUM_THREADS", run % 2 == 0 ? "1" : "2"}};
    const Environment environment(threads);
    EXPECT_EQ(hashesOf(arguments), first) << "run " << run;
  }
}

}  // namespace
}  // namespace rocinante
