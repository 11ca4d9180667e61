// The same bits from every run of the program, whatever its environment says.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <charconv>
#include <map>

#include "tests/support/programs.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/render/test_session.h"

namespace rocinante {
namespace {

/// Sets variables for programs started while it lives.
class Environment {
 public:
  explicit Environment(std::map<std::string, std::string> variables) {
    for (auto& [name, value] : variables) {
      const char* old = ::getenv(name.c_str());
      before_[name] = old == nullptr ? std::optional<std::string>() : old;
      ::setenv(name.c_str(), value.c_str(), 1);
    }
  }
  ~Environment() {
    for (const auto& [name, value] : before_) {
      if (value) {
        ::setenv(name.c_str(), value->c_str(), 1);
      } else {
        ::unsetenv(name.c_str());
      }
    }
  }

 private:
  std::map<std::string, std::optional<std::string>> before_;
};

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

TEST(RenderProgram, TwentyRunsGiveOneHash) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeArmSession(folder / "arm.mcap");
  const std::vector<std::string> arguments{folder / "arm.urdf", folder / "arm.mcap", "--hash",
                                           "--at", "5.5"};
  const std::string first = hashesOf(arguments);
  for (int run = 1; run < 20; ++run) EXPECT_EQ(hashesOf(arguments), first) << "run " << run;
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
  for (int run = 1; run < 20; ++run) {
    const std::map<std::string, std::string> threads{{"LP_NUM_THREADS", run % 2 == 0 ? "1" : "2"}};
    const Environment environment(threads);
    EXPECT_EQ(hashesOf(arguments), first) << "run " << run;
  }
}

}  // namespace
}  // namespace rocinante
