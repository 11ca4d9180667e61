#include <gtest/gtest.h>

#include "golden/command/commands.h"
#include "golden/suite/suite.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

/// Each away from its default. By name, so that a new term does not compile until it is here.
PictureTerms unusualTerms() {
  PictureTerms terms;
  auto& [width, height, scale, samples, hide, show, style, insets, panel] = terms;
  width = 64;
  height = 48;
  scale = 1.5;
  samples = 1;
  hide = {"layer/labels", "arm/hand"};
  show = {"arm"};
  for (const char* word : {"shadows=on", "edges=only", "transparent=arm@0.4", "transparent=hall",
                           "measure=arm@0,0,0.5~hall@1,0,0", "lengths=m"}) {
    EXPECT_TRUE(setStyle(style, word).ok()) << word;
  }
  insets = {*parseInset("map:top-left"), *parseInset("fit:arm:bottom-right:160x120px")};
  panel = true;
  return terms;
}

/// The case that `golden add` makes of the words that the window writes for these terms.
PictureTerms addedTerms(const PictureTerms& terms) {
  const test::TemporaryFolder folder;
  const std::string suite = (folder / "new.suite.toml").string();
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  std::vector<std::string> words{"rocinante-golden", "add",    suite,     "--case",
                                 "unusual",          "--cell", "arm.urdf"};
  for (std::string& word : pictureWords(terms, StyleOptions::one)) {
    words.push_back(std::move(word));
  }
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  cli::Program program("", "rocinante-golden");
  AddArguments arguments;
  addCaseCommand(program, arguments);
  EXPECT_EQ(cli::run(program, static_cast<int>(argv.size()), argv.data(), "",
                     [&] { return runAddCommand(arguments); }),
            0);
  const auto read = readSuite(suite);
  EXPECT_TRUE(read.ok() && read->cases.size() == 1);
  return read.ok() && !read->cases.empty() ? PictureTerms(read->cases.front()) : PictureTerms();
}

TEST(AddCommand, TakesEveryTermOfAPicture) {
  const PictureTerms terms = unusualTerms();
  EXPECT_EQ(addedTerms(terms), terms);
}

TEST(AddCommand, TakesTheTermsOfAPictureWithoutInsets) {
  PictureTerms terms = unusualTerms();
  terms.insets.emplace();
  EXPECT_EQ(addedTerms(terms), terms);
  terms.insets.reset();
  EXPECT_EQ(addedTerms(terms), terms);
}

}  // namespace
}  // namespace rocinante
