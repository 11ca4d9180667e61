// rocinante-self-test: what `rocinante --self-test` runs. Reports what works on this machine, and
// how to fix the rest. A separate program checks drawing; it is installed beside this one together
// with the programs that draw.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/program.h"
#include "core/self_test/fact.h"
#include "core/self_test/fact_jobs.h"
#include "core/self_test/network_facts.h"
#include "core/self_test/system_facts.h"

namespace {

using namespace rocinante;

constexpr std::string_view kExamples =
    "  rocinante --self-test\n"
    "  rocinante --self-test --only context,key,frame   does this machine draw?\n"
    "  rocinante --self-test --json\n";

// Everything together takes a fraction of a second; on a busy machine, a few seconds.
constexpr Nanoseconds kLimit = std::chrono::seconds(10);

std::filesystem::path folderOfPrograms() {
  std::error_code fault;
  return std::filesystem::read_symlink("/proc/self/exe", fault).parent_path();
}

std::vector<FactJob> allJobs() {
  const std::filesystem::path programs = folderOfPrograms();
  std::vector<FactJob> jobs;
  const auto add = [&](const char* name, std::function<SelfTestFact()> find) {
    jobs.push_back({{name}, [find] { return std::vector{find()}; }, {}, {}, {}});
  };
  // Pictures are separate: their library takes as long as all the rest.
  for (std::vector<std::string> names :
       {std::vector<std::string>{"context", "key", "frame", "cache"}, {"pictures"}}) {
    jobs.push_back({std::move(names),
                    {},
                    programs / "rocinante-self-test-draw",
                    {},
                    "install the programs that draw: render, view and golden"});
  }
  add("sdf", [] { return sdfFact(); });
  add("multicast", [] { return multicastFact(); });
  add("ipv6", [] { return ipv6Fact(); });
  add("receive_buffer", [] { return receiveBufferFact(); });
  add("capture", [programs] { return captureFact(programs); });
  add("scheduling", [programs] { return schedulingFact(programs); });
  add("priority", [programs] { return priorityFact(programs); });
  add("clock", [] { return clockFact(); });
  add("files", [] {
    std::error_code fault;
    const auto here = std::filesystem::current_path(fault);
    return filesFact(fault ? std::filesystem::path(".") : here);
  });
  return jobs;
}

/// The jobs that answer one of `only`; empty: all.
Result<std::vector<FactJob>> jobsFor(const std::vector<std::string>& only) {
  std::vector<FactJob> jobs = allJobs();
  std::string known;
  for (const FactJob& job : jobs) {
    for (const std::string& name : job.names) known += (known.empty() ? "" : ", ") + name;
  }
  const auto wanted = [&](const std::string& name) {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  };
  std::size_t found = 0;
  for (FactJob& job : jobs) {
    std::erase_if(job.names, [&](const std::string& name) { return !wanted(name); });
    found += job.names.size();
    if (job.program.empty()) continue;
    job.arguments.push_back("--only");
    job.arguments.push_back(fmt::format("{}", fmt::join(job.names, ",")));
  }
  std::erase_if(jobs, [](const FactJob& job) { return job.names.empty(); });
  if (!only.empty() && found < only.size()) {
    for (const std::string& name : only) {
      if ((", " + known + ",").find(", " + name + ",") == std::string::npos) {
        return Error{ErrorKind::bad_argument, "unknown fact `" + name + "`; the facts are " + known,
                     "--only"};
      }
    }
  }
  return jobs;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Reports what works on this machine, and how to fix the rest.",
               "rocinante-self-test");
  std::vector<std::string> only;
  bool json = false;
  app.add_option("--only", only, "check only these facts, separated by commas")
      ->type_name("FACT,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_flag("--json", json, "print the facts as JSON");
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    const Result<std::vector<FactJob>> jobs = jobsFor(only);
    if (!jobs) return jobs.error();
    const std::vector<SelfTestFact> facts = findFacts(*jobs, kLimit);
    cli::say(json ? factsJson(facts) : factsText(facts));
    const bool ok = std::all_of(facts.begin(), facts.end(), [](const SelfTestFact& fact) {
      return fact.state == SelfTestFact::State::ok;
    });
    return ok ? cli::Exit::done : cli::Exit::no;
  });
}
