#include "golden/command/compare_command.h"

#include <fmt/format.h>

#include <iostream>

#include "core/base/figure_text.h"
#include "core/report/json_text.h"
#include "golden/compare/compare_files.h"
#include "golden/compare/comparison_text.h"

namespace rocinante {
namespace {

Json pictureJson(const std::filesystem::path& path, const FinePicture& fine) {
  return {{"file", path.string()},
          {"width", fine.picture.width},
          {"height", fine.picture.height},
          {"components", fine.encoding.componentsText()},
          {"depth", fine.encoding.depthText()}};
}

/// Scripts rely on the keys up to pixels_over; later versions only add keys.
Json answerJson(const CompareArguments& arguments, const FilesComparison& files) {
  const Comparison& found = files.comparison;
  Json answer = {
      {"format", 1},
      {"verdict", nameOf(found.verdict)},
      {"rule", found.rule},
      {"tier", arguments.tier},
      {"max", found.max},
      {"worst", {{"x", found.worst_x}, {"y", found.worst_y}}},
      {"worst_tile_mean", found.worst_tile_mean},
      {"worst_tile_over", found.worst_tile_over},
      {"differing", found.differing},
      {"pixels_over",
       {{"1", found.over_1}, {"2", found.over_2}, {"8", found.over_8}, {"32", found.over_32}}},
      {"worst_tile", {{"x", found.worst_tile_x}, {"y", found.worst_tile_y}}},
      {"masked", found.masked}};
  if (files.frame) answer["frame"] = pictureJson(arguments.frame, *files.frame);
  if (files.golden) answer["golden"] = pictureJson(arguments.golden, *files.golden);
  if (files.frame && !files.frame->samples.empty()) {
    answer["samples"] = {{"differing", found.fine_differing}, {"max", found.fine_max}};
  }
  answer["masks"] = Json::array();
  for (const PictureMask::Part& part : files.masks) {
    answer["masks"].push_back({{"mask", part.name}, {"pixels", part.pixels}});
  }
  answer["notes"] = files.notes;
  return answer;
}

void printAnswer(const FilesComparison& files, bool quiet) {
  const Comparison& found = files.comparison;
  fmt::print("{}: {}\n", nameOf(found.verdict), found.rule);
  for (const std::string& note : files.notes) fmt::print("note: {}\n", note);
  if (quiet || !files.comparable()) return;
  if (found.masked > 0)
    fmt::print("masked: {}\n", countText(static_cast<std::uint64_t>(found.masked), "pixel"));
  if (found.fine_differing > 0) {
    fmt::print("differing samples: {} of {}, by at most {:g}\n", found.fine_differing,
               files.frame->samples.size(), found.fine_max);
  }
  fmt::print("{}", differenceText(found, files.judged(), files.golden->picture));
}

}  // namespace

cli::CommandLine addCompareCommand(cli::CommandLine app, CompareArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand("compare", "compare two pictures");
  command.addOption("A", arguments.frame, "a picture; - is standard input").required();
  command.addOption("B", arguments.golden, "the picture to compare it with").required();
  command.addOption("--tier", arguments.tier, kTierNames).showDefault();
  command
      .addOption("--mask", arguments.masks, "X,Y,WIDTHxHEIGHT: leave these pixels out; repeatable")
      .valueName("RECT")
      .oneEach();
  command.addOption("--difference", arguments.difference, "write a picture of the differences");
  command.addFlag("--force", arguments.force, "replace an existing --difference file");
  command.addFlag("-q,--quiet", arguments.quiet, "only the verdict, no figures or map");
  command.addFlag("--json", arguments.json, "print all figures as JSON");
  return command;
}

Result<cli::Exit> runCompareCommand(const CompareArguments& arguments) {
  const auto tolerance = Tolerance::named(arguments.tier);
  if (!tolerance.ok()) return tolerance.error();
  std::vector<MaskRectangle> masks;
  for (const std::string& text : arguments.masks) {
    const auto rectangle = MaskRectangle::parse(text);
    if (!rectangle.ok()) return rectangle.error();
    masks.push_back(*rectangle);
  }
  if (arguments.frame == "-" && arguments.golden == "-") {
    return Error{ErrorKind::bad_argument, "only one picture can be standard input", {}};
  }
  const auto fileOf = [](const std::filesystem::path& path) {
    return path == "-" ? std::filesystem::path("/dev/stdin") : path;
  };
  const FilesComparison files =
      compareFiles(fileOf(arguments.frame), fileOf(arguments.golden), *tolerance, masks);
  // With --json, print an answer in every case.
  if (files.unreadable && !arguments.json) return *files.unreadable;
  if (files.comparable() && !arguments.difference.empty()) {
    const Picture shown = differencePicture(files.judged(), files.golden->picture);
    const Status written = writePng(arguments.difference, shown, arguments.force);
    if (!written.ok()) return written.error();
  }
  if (arguments.json) {
    std::cout << jsonText(answerJson(arguments, files));
  } else {
    printAnswer(files, arguments.quiet);
  }
  return exitOf(files.comparison.verdict);
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
