#include "golden/compare_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

Json comparisonJson(const Comparison& found, const Tolerance& tolerance) {
  return {{"format", 1},
          {"verdict", nameOf(found.verdict)},
          {"rule", found.rule},
          {"tier", tolerance.name},
          {"max", found.max},
          {"worst", {{"x", found.worst_x}, {"y", found.worst_y}}},
          {"worst_tile_mean", found.worst_tile_mean},
          {"worst_tile_over", found.worst_tile_over},
          {"differing", found.differing},
          {"pixels_over",
           {{"1", found.over_1}, {"2", found.over_2}, {"8", found.over_8}, {"32", found.over_32}}}};
}

void printComparison(const Comparison& found, const Picture& frame, const Picture& golden) {
  fmt::print("{}: {}\n", nameOf(found.verdict), found.rule);
  if (found.differing == 0) return;
  fmt::print("differing pixels: {} of {}; over 1/2/8/32: {}/{}/{}/{}\n", found.differing,
             static_cast<std::int64_t>(frame.width) * frame.height, found.over_1, found.over_2,
             found.over_8, found.over_32);
  fmt::print("largest difference: {} at ({}, {}): rgba {} against {}\n", found.max, found.worst_x,
             found.worst_y, fmt::join(found.worst_frame, " "), fmt::join(found.worst_golden, " "));
  fmt::print("worst 16x16 tile: mean {:.2f}, {} pixels over 32\n", found.worst_tile_mean,
             found.worst_tile_over);
  for (const std::string& line : differenceMap(frame, golden)) fmt::print("    |{}|\n", line);
}

}  // namespace

CLI::App* addCompareCommand(CLI::App& app, CompareArguments& arguments) {
  CLI::App* command = app.add_subcommand("compare", "compare two pictures");
  command->add_option("A", arguments.frame, "a picture")->required();
  command->add_option("B", arguments.golden, "the picture to compare it with")->required();
  command->add_option("--tier", arguments.tier, "exact, cpu or loose")->capture_default_str();
  command->add_flag("--json", arguments.json, "answer with every figure as JSON");
  return command;
}

Result<cli::Exit> runCompareCommand(const CompareArguments& arguments) {
  const auto tolerance = Tolerance::named(arguments.tier);
  if (!tolerance.ok()) return tolerance.error();
  const auto frame = readPicture(arguments.frame);
  if (!frame.ok()) return frame.error();
  const auto golden = readPicture(arguments.golden);
  if (!golden.ok()) return golden.error();
  const Comparison found = compare(*frame, *golden, *tolerance);
  if (arguments.json) {
    std::cout << comparisonJson(found, *tolerance).dump(2) << "\n";
  } else {
    printComparison(found, *frame, *golden);
  }
  return exitOf(found.verdict);
}

cli::Exit exitOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
      return cli::Exit::done;
    case Verdict::different:
      return cli::Exit::no;
    case Verdict::incomparable:
      return cli::Exit::could_not_run;
  }
  return cli::Exit::could_not_run;
}

}  // namespace rocinante
