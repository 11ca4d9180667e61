
#include "core/copy/copy_report.h"
#include "core/copy/log_edits.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct DecodeArguments {
  std::string log;
  std::string decoders;
  CopyArguments copy;
};

Result<cli::Exit> runDecode(const DecodeArguments& arguments) {
  auto decoders = decode::DatagramDecoders::open(arguments.decoders);
  if (!decoders) return decoders.error();
  DecodeReport whole;
  const Result<CopyReport> report = runCopy(arguments.copy, "reading " + arguments.log,
                                            [&](const MakeOptions& make) -> Result<CopyReport> {
                                              Result<DecodeReport> made =
                                                  decodeLog(arguments.log, *decoders, make);
                                              if (!made) return made.error();
                                              whole = std::move(*made);
                                              return whole.copy;
                                            });
  if (!report) return report.error();
  const Result<cli::Exit> summarized = tellCopy(arguments.copy, *report);
  if (!summarized) return summarized;
  if (!arguments.copy.json) {
    if (Status printed = toStandardOutput(decode::accountText(whole.account)); !printed)
      return printed.error();
  }
  // Nothing decoded is not what anybody asked for.
  return report->counts.decoded == 0 ? cli::Exit::no : *summarized;
}

}  // namespace

cli::Subcommand addDecodeCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<DecodeArguments>();
  const cli::CommandLine app = program.addSubcommand(
      "decode", "copy a log, with packets made of its octets by declared decoders");
  app.addOption("LOG", arguments->log, "the log; it is not changed").required();
  app.addOption("--decoders", arguments->decoders, "the file that declares them").required();
  addCopyArguments(app, arguments->copy);
  return {app, [arguments] { return runDecode(*arguments); }};
}

}  // namespace rocinante
