
#include "recorder/contents/log_verify.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct VerifyOptions {
  std::string log;
  std::string trust;
  bool json = false;
};

Result<cli::Exit> runVerify(const VerifyOptions& options) {
  Result<TrustFile> trust = TrustFile::read(options.trust);
  if (!trust) return trust.error();
  TrustJudge judge(std::move(*trust));
  Result<LogReader> log = LogReader::open(options.log);
  if (!log) return log.error();
  cli::catchStopSignals();
  Result<VerifyReport> report = [&] {
    ProgressLine progress("verifying " + options.log);
    return verifyLog(*log, judge, [&](double part) {
      progress.show(part);
      return !cli::stopRequested();
    });
  }();
  if (!report) return report.error();
  const std::string text = options.json ? verifyJson(*report) : verifyText(*report);
  if (Status written = toStandardOutput(text); !written) return written.error();
  const bool is_empty = report->messages == 0 && report->damage.empty();
  if (is_empty || report->stopped) return cli::Exit::could_not_run;
  return report->isWhole() ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addVerifyCommand(cli::CommandLine program) {
  auto options = std::make_shared<VerifyOptions>();
  const cli::CommandLine app =
      program.addSubcommand("verify", "check the signatures of all datagrams");
  app.addOption("LOG", options->log, "the log to verify").required();
  app.addOption("--trust", options->trust, "the keys and what each may say (docs/signing.md)")
      .valueName("FILE")
      .required();
  app.addFlag("--json", options->json, "print JSON");
  return {app, [options] { return runVerify(*options); }};
}

}  // namespace rocinante
