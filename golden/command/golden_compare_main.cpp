// rocinante-golden-compare: what `rocinante golden compare` runs. The renderer's libraries take
// longer to load than two pictures take to compare, and comparing needs none of them.
#include <vector>

#include "core/cli/program.h"
#include "golden/command/compare_command.h"

int main(int argc, char** argv) {
  // The arguments of `rocinante-golden compare`, so that both print the same help and messages.
  std::vector<char*> words(argv, argv + argc);
  char verb[] = "compare";
  words.insert(words.begin() + (argc > 0 ? 1 : 0), verb);
  words.push_back(nullptr);

  rocinante::cli::Program app("Visual regression: any two pictures against each other.",
                              "rocinante-golden");
  app.requireSubcommand();
  rocinante::CompareArguments arguments;
  rocinante::addCompareCommand(app, arguments);
  return rocinante::cli::run(app, argc + 1, words.data(),
                             "  rocinante golden compare before.png after.png --tier cpu\n"
                             "  rocinante golden compare frame.exr golden.exr --mask 0,0,200x24\n"
                             "  rocinante golden compare a.png b.png --difference where.png\n",
                             [&] { return rocinante::runCompareCommand(arguments); });
}
