#include <fmt/format.h>

#include <algorithm>

#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "golden/approval/approval.h"
#include "golden/command/commands.h"
#include "golden/report/report_reader.h"
#include "golden/why/file_change.h"

namespace rocinante {
namespace {

Error refusedFrame(const std::string& name, std::string why) {
  return {ErrorKind::refused, std::move(why), "case " + name};
}

/// A stranger's hash, or nothing: it decides no verdict, and becomes part of the manifest.
std::string hexOrNothing(const std::string& text) {
  const bool is_hash =
      text.size() <= 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
  return is_hash ? text : std::string();
}

/// Whether a frame may become a golden as the report has it; `drawn_case` null when the suite has
/// no such case.
Status mayAccept(const JudgedFrame& judged, const SuiteCase* drawn_case,
                 const std::string& renderer, const Manifest& manifest) {
  const std::string& name = judged.frame.name;
  const auto refuse = [&](std::string why) { return refusedFrame(name, std::move(why)); };
  if (drawn_case == nullptr) {
    return refuse(fmt::format("the suite has no case `{}`", plainText(judged.frame.case_name)));
  }
  if (!canApprove(judged)) {
    return refuse(fmt::format("not approved because its verdict was {}", nameOf(judged.verdict)));
  }
  const Picture& drawn = *judged.drawn;
  const bool is_shaped = drawn.width == drawn_case->width && drawn.height == drawn_case->height;
  if (!is_shaped ||
      judged.key !=
          renderer + " " + shapeText(drawn_case->width, drawn_case->height, drawn_case->samples)) {
    return refuse(fmt::format("its key `{}` in the report is not that of its picture and case",
                              plainText(judged.key)));
  }
  const bool has_masks = !drawn_case->mask.empty() || !drawn_case->judge_only.empty();
  if (has_masks != judged.areas.has_value()) {
    return refuse("its masks in the suite are not those of the report");
  }
  // What was seen beside it must still be what it replaces.
  const auto accepted = manifest.findAll(name);
  const bool is_beside = judged.golden
                             ? std::ranges::any_of(accepted,
                                                   [&](const AcceptedPicture* one) {
                                                     return one->pixels == judged.golden->pixels;
                                                   })
                             : accepted.empty();
  if (!is_beside) return refuse("its goldens have changed since the report was made");
  return {};
}

class ArtifactApprover {
 public:
  ArtifactApprover(const Suite& suite, GoldenFolder folder, Manifest manifest,
                   const SuiteReport& report, const ApproveArguments& arguments)
      : suite_(suite),
        manifest_(manifest),
        report_(report),
        arguments_(arguments),
        approval_(std::move(folder), std::move(manifest)),
        by_(userName()),
        at_(nowText()) {
    describeCell();
  }

  Status approve(const std::string& name, const std::string& pixels) {
    const auto found = std::ranges::find(
        report_.frames, name, [](const JudgedFrame& judged) { return judged.frame.name; });
    if (found == report_.frames.end()) {
      return refusedFrame(name, "the report has no such frame");
    }
    const JudgedFrame& judged = *found;
    if (judged.pixels != pixels) {
      return refusedFrame(name, "the picture in the report is not the one that the list accepts");
    }
    AcceptedPicture accepted{judged.key,
                             {},
                             judged.pixels,
                             hexOrNothing(judged.inputs),
                             hexOrNothing(report_.session),
                             by_,
                             at_,
                             arguments_.message};
    accepted.decoded = hexOrNothing(report_.decoded);
    if (judged.coverage && !accepted.session.empty()) {
      accepted.coverage.emplace(judged.coverage->judged.begin(), judged.coverage->judged.end());
    }
    if (judged.areas) accepted.areas_pixels = pictureXxh3(*judged.areas);
    if (approval_.isAccepted(name, accepted)) {
      accepted_.push_back(name);
      return {};
    }
    const auto of_case = std::ranges::find(suite_.cases, judged.frame.case_name, &SuiteCase::name);
    const SuiteCase* const drawn_case = of_case == suite_.cases.end() ? nullptr : &*of_case;
    if (Status may = mayAccept(judged, drawn_case, report_.renderer, manifest_); !may) return may;
    if (!judged.lacks.empty() && !arguments_.anyway) {
      return refusedFrame(name, lacksRefusal(judged.lacks));
    }
    if (auto staged = approval_.stage(name, std::move(accepted), *judged.drawn,
                                      judged.areas ? &*judged.areas : nullptr, arguments_.also);
        !staged) {
      unwritten_ = staged.error();
      return {};
    }
    accepted_.push_back(name);
    return {};
  }

  /// Why nothing may be approved: a file that could not be written.
  const std::optional<Error>& unwritten() const { return unwritten_; }

  /// Names of the frames that are accepted now; those that another process changed are added to
  /// `refused`.
  Result<std::vector<std::string>> commit(std::size_t& refused) {
    const auto left_alone = approval_.commit();
    if (!left_alone.ok()) return left_alone.error();
    for (const std::string& name : *left_alone) {
      cli::warn("another approve changed it meanwhile, so it was left alone (case " + name + ")");
      std::erase(accepted_, name);
    }
    refused += left_alone->size();
    return accepted_;
  }

 private:
  /// The files are the report's; their texts are those of the cell here, where it is the same.
  void describeCell() {
    if (report_.cell_files.empty()) return;
    FileTexts texts;
    CellOptions options;
    static_cast<ModelSearch&>(options) = arguments_.suite;
    if (!suite_.cell.empty()) {
      const auto cell = collectCellOrLog(suite_.cell, options, BundleRoots::all);
      if (cell.ok() && hashesOf(*cell) == report_.cell_files) texts = recordedTexts(*cell);
    }
    approval_.describeCell(report_.cell_files, std::move(texts));
  }

  const Suite& suite_;
  Manifest manifest_;
  const SuiteReport& report_;
  const ApproveArguments& arguments_;
  Approval approval_;
  std::string by_, at_;
  std::vector<std::string> accepted_;
  std::optional<Error> unwritten_;
};

}  // namespace

Result<cli::Exit> approveArtifact(const ApproveArguments& arguments, const ApprovalList& list) {
  auto suite = readSuite(arguments.suite.suite);
  if (!suite.ok()) return suite.error();
  if (!arguments.suite.cell.empty()) suite->cell = arguments.suite.cell;
  auto manifest = Manifest::read(suite->goldens);
  if (!manifest.ok()) return manifest.error();
  const auto report = readArtifact(arguments.artifact);
  if (!report.ok()) return report.error();
  auto folder = GoldenFolder::of(*suite);
  if (!folder.ok()) return folder.error();
  ArtifactApprover approver(*suite, std::move(*folder), std::move(*manifest), *report, arguments);
  std::size_t refused = 0, runs_approved = 0;
  for (const auto& [name, pixels] : list) {
    const auto run = std::ranges::find(report->runs, name, &JudgedRun::name);
    if (run != report->runs.end()) {
      const auto approved = approveReportedRun(arguments, *run, pixels);
      if (!approved.ok()) cli::warn(approved.error().text());
      ++(approved.ok() ? runs_approved : refused);
      continue;
    }
    const Status done = approver.approve(name, pixels);
    if (approver.unwritten()) return *approver.unwritten();
    if (done) continue;
    cli::warn(done.error().text());
    ++refused;
  }
  if (cli::stopRequested()) {
    return Error{ErrorKind::refused, "interrupted: nothing was approved", suite->file.string()};
  }
  const auto approved = approver.commit(refused);
  if (!approved.ok()) return approved.error();
  for (const std::string& name : *approved) fmt::print("approved {}\n", name);
  fmt::print("{} approved, {} refused; goldens in {}\n", approved->size() + runs_approved, refused,
             suite->goldens.lexically_normal().string());
  return refused > 0 ? cli::Exit::no : cli::Exit::done;
}

}  // namespace rocinante
