// `rocinante VERB ...` runs `rocinante-VERB ...`: from this program's folder if it is there, else
// from PATH. Links only the base library.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/name_hint.h"
#include "core/base/version.h"
#include "core/cli/parts_text.h"

namespace {

struct Verb {
  const char* name;
  const char* does;
};

constexpr std::array kVerbs{
    Verb{"record", "capture live datagrams to a log"},
    Verb{"spy", "what arrives, and why nothing moves"},
    Verb{"play", "re-emit a log as UDP, at any speed"},
    Verb{"source", "send kinematic state: from a CSV file, a log or the demo"},
    Verb{"relay", "send packets on: to addresses, and to who subscribes"},
    Verb{"key", "make keys that sign datagrams, and entries of trust files"},
    Verb{"log", "inspect logs, repair them, and make logs from logs"},
    Verb{"model", "what is in a model: info, tree, fk, convert"},
    Verb{"check", "does this session still fit this model?"},
    Verb{"render", "draw frames of a cell and a log without a window"},
    Verb{"view", "the interactive viewer"},
    Verb{"page", "one HTML file that shows a session in any browser"},
    Verb{"serve", "the same page over HTTP, with a log or live"},
    Verb{"golden", "visual regression: frames against accepted pictures"},
    Verb{"self-test", "what works on this machine, and what to do: also `rocinante --self-test`"},
};

std::filesystem::path folderOfThisProgram() {
  std::error_code fault;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", fault);
  return fault ? std::filesystem::path() : self.parent_path();
}

void printHelp() {
  std::printf("usage: rocinante VERB [OPTIONS]\n\n");
  for (const Verb& verb : kVerbs) std::printf("  %-9s %s\n", verb.name, verb.does);
  std::printf("\n`rocinante VERB --help` describes each one.\n");
  std::printf("`rocinante --version --parts` lists the optional parts of this build.\n");
}

bool isKnown(std::string_view verb) {
  return std::any_of(kVerbs.begin(), kVerbs.end(),
                     [verb](const Verb& each) { return each.name == verb; });
}

std::string hintAt(std::string_view verb) {
  std::vector<std::string_view> known;
  for (const Verb& each : kVerbs) known.emplace_back(each.name);
  const std::string hint = rocinante::didYouMean(verb, known);
  return hint.empty() ? hint : "; " + hint;
}

}  // namespace

int main(int argc, char** argv) {
  std::string help_option = "--help";
  if (argc > 2 && std::string_view(argv[1]) == "help") {  // `help VERB` is `VERB --help`
    std::copy(argv + 2, argv + argc, argv + 1);
    argv[argc - 1] = help_option.data();
  }
  std::string_view verb = argc > 1 ? argv[1] : "";
  if (verb.empty()) {
    std::fprintf(stderr, "rocinante: which verb? (see rocinante --help)\n");
    return 2;
  }
  if (verb == "--help" || verb == "-h" || verb == "help") {
    printHelp();
    return 0;
  }
  if (verb == "--version") {
    const bool with_parts = argc > 2 && std::string_view(argv[2]) == "--parts";
    if (argc > (with_parts ? 3 : 2)) {
      std::fprintf(stderr, "rocinante: --version takes only --parts, not `%s`\n", argv[argc - 1]);
      return 2;
    }
    std::printf("%s\n", rocinante::version());
    if (with_parts) std::printf("%s", rocinante::partsText(folderOfThisProgram()).c_str());
    return 0;
  }
  const bool is_self_test = verb == "--self-test";
  if (is_self_test) verb.remove_prefix(2);
  if (verb.find('/') != std::string_view::npos || verb.starts_with('-')) {
    std::fprintf(stderr, "rocinante: `%s` is not a verb (see rocinante --help)\n", argv[1]);
    return 2;
  }

  std::string program = "rocinante-" + std::string(verb);
  // A sub-verb may be a program of its own, which starts faster than the full one.
  const std::string_view sub_verb = argc > 2 ? argv[2] : "";
  if (!is_self_test && !sub_verb.empty() &&
      sub_verb.find_first_of("/-.") == std::string_view::npos) {
    const std::string own_program = program + "-" + argv[2];
    ::execv((folderOfThisProgram() / own_program).c_str(), argv + 2);
  }
  argv[1] = program.data();
  const auto beside = folderOfThisProgram() / program;
  ::execv(beside.c_str(), argv + 1);
  if (errno == ENOENT) ::execvp(program.c_str(), argv + 1);
  if (errno == ENOENT && isKnown(verb)) {
    // Not in this build, as on a recorder's machine without a display.
    std::fprintf(stderr, "rocinante: %s is not installed here%s\n", program.c_str(),
                 verb == "view"    ? ": install the package rocinante-view"
                 : verb == "serve" ? ": install the package rocinante-serve"
                                   : "");
  } else if (errno == ENOENT) {
    std::fprintf(stderr, "rocinante: there is no verb `%.*s`%s (see rocinante --help)\n",
                 static_cast<int>(verb.size()), verb.data(), hintAt(verb).c_str());
  } else {
    std::fprintf(stderr, "rocinante: cannot run %s: %s\n", program.c_str(), std::strerror(errno));
  }
  return 2;
}
