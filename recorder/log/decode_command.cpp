#include "recorder/log/decode_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/base/count_text.h"
#include "recorder/copy/copy_report.h"
#include "recorder/copy/log_decode.h"
#include "recorder/log/command_support.h"
#include "recorder/log/copy_options.h"

namespace rocinante {
namespace {

struct DecodeArguments {
  std::string log;
  std::string decoders;
  CopyArguments copy;
};

/// One line for each decoder, and what none of them understood.
std::string decodeText(const DecodeReport& report, const decode::DecoderSet& set) {
  std::string text;
  std::uint64_t decoded = 0;
  for (std::size_t i = 0; i < report.counts.size(); ++i) {
    const decode::DecodeCounts& counts = report.counts[i];
    decoded += counts.decoded;
    text += fmt::format("  {}: {}", set.decoders[i].name, countText(counts.decoded, "packet"));
    if (counts.refused > 0) {
      text += fmt::format(", {} refused: {}", counts.refused, counts.last_reason);
    }
    if (counts.empty > 0) text += fmt::format(", {} without its fields", counts.empty);
    text += '\n';
  }
  if (decoded < report.octets) {
    text += fmt::format("  not decoded: {}\n", countText(report.octets - decoded, "datagram"));
  }
  return text;
}

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
  const Result<cli::Exit> told = tellCopy(arguments.copy, *report);
  if (!told) return told;
  if (!arguments.copy.json) {
    if (Status said = toStandardOutput(decodeText(whole, decoders->set())); !said)
      return said.error();
  }
  // Nothing decoded is not what anybody asked for.
  return report->counts.decoded == 0 ? cli::Exit::no : *told;
}

}  // namespace

LogCommand addDecodeCommand(CLI::App& program) {
  auto arguments = std::make_shared<DecodeArguments>();
  CLI::App* const app = program.add_subcommand(
      "decode", "copy a log, with packets made of its octets by declared decoders");
  app->add_option("LOG", arguments->log, "the log; it is not changed")->required();
  app->add_option("--decoders", arguments->decoders, "the file that declares them")->required();
  addCopyArguments(*app, arguments->copy);
  return {app, [arguments] { return runDecode(*arguments); }};
}

}  // namespace rocinante
