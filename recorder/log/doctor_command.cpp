#include <cstdio>

#include "recorder/doctor/log_doctor.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct DoctorOptions {
  std::vector<std::string> logs;
  bool json = false;
};

Result<cli::Exit> runDoctor(const DoctorOptions& options) {
  cli::Exit exit = cli::Exit::done;
  for (const std::string& log : options.logs) {
    ProgressLine progress("examining " + log);
    const Result<DoctorReport> report = examineLog(log, [&](double part) { progress.show(part); });
    if (!report) return report.error();
    const std::string text =
        options.json ? doctorJson(*report, options.logs.size() == 1) : doctorText(*report);
    if (Status written = toStandardOutput(text); !written) return written.error();
    if (!report->clean()) exit = cli::Exit::no;
  }
  return exit;
}

}  // namespace

cli::Subcommand addDoctorCommand(cli::CommandLine program) {
  auto options = std::make_shared<DoctorOptions>();
  const cli::CommandLine app =
      program.addSubcommand("doctor", "check a log against every rule of its format");
  app.addOption("LOG", options->logs, "logs to examine; other MCAP files too").required();
  app.addFlag("--json", options->json, "print JSON; for several logs, one object per line");
  return {app, [options] { return runDoctor(*options); }};
}

}  // namespace rocinante
