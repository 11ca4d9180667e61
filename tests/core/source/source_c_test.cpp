// The C header as controllers use it: compiled as C, and byte for byte what the C++ class sends.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/base/atomic_file.h"
#include "tests/core/source/source_driver.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

const std::string kWarnings = "-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror ";
const std::string kTree = ROCINANTE_SOURCE_DIR;
const std::string kSender = kTree + "/tests/core/source/c_sender.c";

bool runs(const std::string& command) { return std::system(command.c_str()) == 0; }

TEST(SourceInC, CompilesWithoutAWarning) {
  // The unit that only uses it, and as one file of static functions.
  test::TemporaryFolder folder;
  const std::string use = (folder.path() / "use.c").string();
  test::writeFile(use,
                  "#include \"core/source/rocinante/rocinante_source.h\"\n"
                  "int main(void) { return rk_world().link != NULL; }\n");
  const std::string all = (folder.path() / "static.c").string();
  test::writeFile(
      all,
      "#define RK_SOURCE_STATIC\n#define RK_SOURCE_IMPLEMENTATION\n"
      "#include \"core/source/rocinante/rocinante_source.h\"\nint main(void) { return 0; }\n");
  for (const std::string& file : std::array{kSender, use, all}) {
    for (const char* how : {"-x c -std=c99 ", "-x c -std=c11 ", "-x c++ -std=c++20 "}) {
      SCOPED_TRACE(std::string(how) + file);
      EXPECT_TRUE(runs(std::string(ROCINANTE_COMPILER " ") + how + kWarnings +
                       "-O2 -fsyntax-only -I" + kTree + " " + file));
    }
  }
}

TEST(SourceInC, CompilesForArm64) {
  if (!runs("command -v aarch64-linux-gnu-gcc >/dev/null")) {
    GTEST_SKIP() << "aarch64-linux-gnu-gcc is not installed (gcc-aarch64-linux-gnu)";
  }
  for (const char* standard : {"c99", "c11"}) {
    EXPECT_TRUE(runs("aarch64-linux-gnu-gcc -std=" + std::string(standard) + " " + kWarnings +
                     "-O2 -c -o /dev/null -I" + kTree + " " + kSender));
  }
}

/// The datagrams of a script, each with its size in a line before it.
std::string sentByCpp(const std::vector<std::string>& script) {
  std::string sent;
  SourceSettings settings;
  settings.source = "s";
  settings.run = "r";
  auto source = Source::open(settings, [&](std::span<std::byte> datagram) {
                  sent += std::to_string(datagram.size()) + "\n" + std::string(textOf(datagram));
                  return true;
                }).value();
  for (const std::string& line : script)
    static_cast<void>(test::follow(source, test::wordsOf(line)));
  return sent;
}

TEST(SourceInC, SendsTheSameBytesAsTheCppClass) {
  test::TemporaryFolder folder;
  const std::string program = (folder.path() / "sender").string();
  for (const char* standard : {"c99", "c11"}) {
    ASSERT_TRUE(runs(ROCINANTE_COMPILER " -x c -std=" + std::string(standard) + " " + kWarnings +
                     "-O2 -fsanitize=undefined -fno-sanitize-recover=all -I" + kTree + " " +
                     kSender + " -o " + program));
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      test::UpdateScript updates(seed);
      std::vector<std::string> script;
      std::string text;
      for (int i = 0; i < 2000; ++i) {
        script.push_back(i % 6 == 5 ? "flush " + std::to_string(i * 5'000'001LL) : updates.next());
        text += script.back() + "\n";
      }
      const std::string input = (folder.path() / "script").string();
      const std::string output = (folder.path() / "sent").string();
      test::writeFile(input, text);
      ASSERT_TRUE(runs(program + " <" + input + " >" + output));
      const std::string expected = sentByCpp(script);
      EXPECT_GT(expected.size(), 50'000U);
      EXPECT_TRUE(readFile(output).value() == expected) << "seed " << seed;
    }
  }
}

/// Compiles examples/sending/NAME.c in its folder by the command in its first comment.
::testing::AssertionResult compilesAsItStates(const std::string& name,
                                              const std::filesystem::path& program) {
  const std::filesystem::path folder = std::filesystem::path(kTree) / "examples" / "sending";
  const std::string text = readFile(folder / (name + ".c")).value();
  const std::size_t begin = text.find("cc -std=c99 ");
  const std::string command = text.substr(begin, text.find(" -o ", begin) - begin);
  if (runs("cd '" + folder.string() + "' && " + command + " -o '" + program.string() + "'"))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << command;
}

TEST(SourceInC, ExamplesCompileAsTheyStateAndHearEachOther) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(compilesAsItStates("sender", folder.path() / "sender"));
  ASSERT_TRUE(compilesAsItStates("receiver", folder.path() / "receiver"));
  const std::string bin = folder.path().string();
  FILE* const heard = popen((bin + "/receiver 127.0.0.1 0 3").c_str(), "r");
  ASSERT_NE(heard, nullptr);
  std::array<char, 256> line{};
  ASSERT_NE(fgets(line.data(), line.size(), heard), nullptr);
  std::string port = line.data();
  ASSERT_EQ(port.substr(0, 13), "listening on ");
  port = port.substr(13, port.find('\n') - 13);
  EXPECT_TRUE(runs(bin + "/sender 127.0.0.1 " + port + " 20"));
  std::string text;
  while (fgets(line.data(), line.size(), heard) != nullptr) text += line.data();
  EXPECT_EQ(pclose(heard), 0);
  EXPECT_EQ(text, "joints arm 0 0\njoints arm 0.004 0.006\njoints arm 0.008 0.012\n");
}

}  // namespace
}  // namespace rocinante
