// rocinante-self-test: what `rocinante --self-test` runs. Reports what works on this machine, and
// how to fix the rest. A separate program checks drawing; it is installed beside this one together
// with the programs that draw.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/program.h"
#include "core/self_test/fact.h"
#include "core/self_test/fact_jobs.h"
#include "core/self_test/machine_facts.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante --self-test\n"
    "  rocinante --self-test --only context,key,frame   does this machine draw?\n"
    "  rocinante --self-test --json\n";

// Everything together takes a fraction of a second; on a busy machine, a few seconds.
constexpr Nanoseconds kLimit = std::chrono::seconds(10);

/// The jobs that answer one of `only`; empty: all.
Result<std::vector<FactJob>> jobsFor(const std::vector<std::string>& only) {
  std::error_code fault;
  const std::filesystem::path programs =
      std::filesystem::read_symlink("/proc/self/exe", fault).parent_path();
  std::string known;
  const auto isWanted = [&](const std::string& name) {
    known += (known.empty() ? "" : ", ") + name;
    return only.empty() || std::ranges::find(only, name) != only.end();
  };
  std::vector<FactJob> jobs;
  // Pictures are separate: their library takes as long as all the rest.
  for (std::vector<std::string> names :
       {std::vector<std::string>{"context", "key", "frame", "cache"}, {"pictures"}}) {
    std::erase_if(names, [&](const std::string& name) { return !isWanted(name); });
    if (names.empty()) continue;
    jobs.push_back(jobOfProgram(names, programs / "rocinante-self-test-draw",
                                "install the programs that draw: render, view and golden"));
  }
  for (const MachineCheck& check : machineChecks()) {
    if (!isWanted(check.name)) continue;
    jobs.push_back(
        {{check.name}, [&check, programs] { return std::vector{check.find(programs)}; }});
  }
  for (const std::string& name : only) {
    if ((", " + known + ",").find(", " + name + ",") != std::string::npos) continue;
    return Error{ErrorKind::bad_argument, "unknown fact `" + name + "`; the facts are " + known,
                 "--only"};
  }
  return jobs;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app("Reports what works on this machine, and how to fix the rest.",
                   "rocinante-self-test");
  std::vector<std::string> only;
  bool json = false;
  app.addOption("--only", only, "check only these facts, separated by commas")
      .valueName("FACT,...")
      .separatedBy(',')
      .oneEach();
  app.addFlag("--json", json, "print the facts as JSON");
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    const Result<std::vector<FactJob>> jobs = jobsFor(only);
    if (!jobs) return jobs.error();
    const std::vector<SelfTestFact> facts = findFacts(*jobs, kLimit);
    cli::say(json ? factsJson(facts) : factsText(facts));
    const bool ok = std::ranges::all_of(
        facts, [](const SelfTestFact& fact) { return fact.state == SelfTestFact::State::ok; });
    return ok ? cli::Exit::done : cli::Exit::no;
  });
}
