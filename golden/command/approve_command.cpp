#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/plain_text.h"
#include "core/cli/progress_line.h"
#include "golden/approval/approval.h"
#include "golden/approval/approval_list.h"
#include "golden/command/commands.h"
#include "golden/suite/suite_neighbours.h"
#include "golden/why/frame_explainer.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxListBytes = 16U << 20U;

/// The user's answer about one frame.
enum class Answer : std::uint8_t { yes, no, quit };

struct Counts {
  std::size_t approved = 0, refused = 0, unchanged = 0, skipped = 0;
};

Error refusal(const SuiteFrame& frame, std::string why) {
  return {ErrorKind::refused, std::move(why), "case " + frame.name};
}

/// Refuses unstable frames.
Status mayApprove(SuiteSession& session, const SuiteFrame& frame, const Picture& drawn) {
  const auto rule = session.instability(frame, drawn);
  if (!rule.ok()) return rule.error();
  if (!rule->empty()) return refusal(frame, "not approved because it is unstable: " + *rule);
  return {};
}

/// Writes the pictures to a temporary folder and prints their paths.
Status showPictures(const JudgedFrame& judged) {
  std::string folder =
      (std::filesystem::temp_directory_path() / "rocinante-golden-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) {
    return Error{ErrorKind::unreadable, "cannot create a folder", folder};
  }
  const auto write = [&](const char* what, const Picture& picture) {
    const std::string file = fmt::format("{}/{}.{}.png", folder, judged.frame.name, what);
    const Status written = writePng(file, picture);
    if (written) fmt::print("  {}\n", file);
    return written;
  };
  if (auto written = write("frame", *judged.drawn); !written) return written;
  if (!judged.accepted) return {};
  if (auto written = write("golden", *judged.accepted); !written) return written;
  if (judged.accepted->width != judged.drawn->width ||
      judged.accepted->height != judged.drawn->height) {
    return {};
  }
  return write("difference", differencePicture(judged.compared(), *judged.accepted));
}

Result<Answer> ask(const JudgedFrame& judged) {
  fmt::print("{:<13} {}: {}\n", nameOf(judged.verdict), judged.frame.name, judged.rule);
  while (true) {
    fmt::print("approve {}? [y]es, [n]o, [v]iew, [q]uit: ", judged.frame.name);
    std::fflush(stdout);
    std::string answer;
    if (!std::getline(std::cin, answer) || cli::stopRequested()) return Answer::quit;
    if (answer == "y" || answer == "yes") return Answer::yes;
    if (answer == "n" || answer == "no") return Answer::no;
    if (answer == "q" || answer == "quit") return Answer::quit;
    if (answer != "v" && answer != "view") continue;
    if (auto shown = showPictures(judged); !shown) cli::warn(shown.error().text());
  }
}

/// Approves the frames of one session.
class Approver {
 public:
  Approver(SuiteSession& session, const SuiteOptions& options, const ApproveArguments& arguments,
           std::optional<ApprovalList> list)
      : session_(session),
        arguments_(arguments),
        list_(std::move(list)),
        neighbours_(neighboursOf(session.suite())),
        approval_(session.folder(), session.manifest()),
        by_(userName()),
        at_(nowText()) {
    if (const auto cell = collectSessionCell(session, options); cell.ok()) {
      approval_.describeCell(hashesOf(*cell), recordedTexts(*cell));
    }
  }

  /// Counts frames that may not be approved. A write error ends the run, and nothing is approved.
  Result<Counts> run() {
    const std::size_t frames = session_.frames().size();
    cli::ProgressLine line("approving");
    for (std::size_t i = 0; i < frames && !quit_; ++i) {
      const SuiteFrame& frame = session_.frames()[i];
      if (list_ && !list_->contains(frame.name)) continue;
      if (!arguments_.interactive) {
        line.show(static_cast<double>(i) / static_cast<double>(frames));
      }
      const Status done = approveOne(frame);
      if (cli::stopRequested()) return interrupted();
      if (unwritten_) return *unwritten_;
      if (done) continue;
      line.clear();
      cli::warn(done.error().text());
      ++counts_.refused;
    }
    line.clear();
    const auto left_alone = approval_.commit();
    if (!left_alone.ok()) return left_alone.error();
    for (const std::string& name : *left_alone) {
      cli::warn("another approve changed it meanwhile, so it was left alone (case " + name + ")");
      std::erase(approved_, name);
    }
    for (const std::string& name : approved_) fmt::print("approved {}\n", name);
    counts_.approved -= left_alone->size();
    counts_.refused += left_alone->size();
    return counts_;
  }

 private:
  Status approveOne(const SuiteFrame& frame) {
    if (!frame.time) return refusal(frame, frame.why);
    if (!session_.incomplete().empty()) {
      return refusal(frame, session_.incomplete() + "; --incomplete approves it anyway");
    }
    const auto drawer = session_.drawer();
    if (!drawer.ok()) return drawer.error();
    const auto drawn = (*drawer)->frame(session_.request(frame));
    if (!drawn.ok()) return drawn.error();
    auto areas = session_.areas(frame);
    if (!areas.ok()) return areas.error();
    auto key = session_.key(*frame.suite_case);
    if (!key.ok()) return key.error();
    AcceptedPicture accepted{std::move(*key),
                             {},
                             pictureXxh3(*drawn),
                             (*drawer)->inputsHash(),
                             session_.sessionHash(),
                             by_,
                             at_,
                             arguments_.message};
    accepted.decoded = session_.decodedHash();
    if (session_.log() != nullptr) {
      const auto covered = session_.coverage(frame);
      if (!covered.ok()) return covered.error();
      accepted.coverage.emplace(covered->judged.begin(), covered->judged.end());
    }
    std::optional<Picture> areas_picture;
    if (*areas) {
      areas_picture = areasPicture(*frame.suite_case, **areas);
      accepted.areas_pixels = pictureXxh3(*areas_picture);
    }
    // Unchanged: keep the first acceptance.
    if (approval_.isAccepted(frame.name, accepted)) {
      ++counts_.unchanged;
      if (!arguments_.interactive) approved_.push_back(frame.name);
      return {};
    }
    if (list_ && list_->find(frame.name)->second != accepted.pixels) {
      return refusal(frame, "the frame drawn now is not the picture that the list accepts");
    }
    if (const auto lacks = session_.lacks(); !lacks.empty() && !arguments_.anyway) {
      return refusal(frame, lacksRefusal(lacks));
    }
    if (auto may = mayApprove(session_, frame, *drawn); !may) return may;
    if (arguments_.interactive) {
      const auto answer = askAbout(frame);
      if (!answer.ok()) return answer.error();
      if (*answer == Answer::quit) quit_ = true;
      if (*answer != Answer::yes) {
        ++counts_.skipped;
        return {};
      }
    }
    if (auto staged = approval_.stage(frame.name, std::move(accepted), *drawn,
                                      areas_picture ? &*areas_picture : nullptr, arguments_.also);
        !staged) {
      unwritten_ = staged.error();
      return {};
    }
    approved_.push_back(frame.name);
    tellOfShared(*frame.suite_case);
    ++counts_.approved;
    return {};
  }

  /// Once for each case.
  void tellOfShared(const SuiteCase& made) {
    const std::string shared = sharedGolden(neighbours_, GoldenKind::picture, made.name);
    if (!shared.empty() && reported_shared_.insert(shared).second) cli::warn(shared);
  }

  Error interrupted() const {
    return {ErrorKind::refused, "interrupted: nothing was approved",
            session_.suite().file.string()};
  }

  Result<Answer> askAbout(const SuiteFrame& frame) {
    auto judged = session_.judge(frame);
    if (!judged.ok()) return judged.error();
    // Within the tolerance, though not the accepted pixels.
    if (!judged->drawn) return Answer::no;
    return ask(*judged);
  }

  SuiteSession& session_;
  const ApproveArguments& arguments_;
  std::optional<ApprovalList> list_;
  std::vector<Suite> neighbours_;
  std::set<std::string> reported_shared_;
  Approval approval_;
  std::string by_, at_;
  Counts counts_;
  std::vector<std::string> approved_;  ///< frames accepted once commit() succeeds
  std::optional<Error> unwritten_;
  bool quit_ = false;
};

Result<std::optional<ApprovalList>> listOf(const ApproveArguments& arguments) {
  if (arguments.from.empty()) return std::optional<ApprovalList>();
  const auto text = readFile(arguments.from == "-" ? "/dev/stdin" : arguments.from, kMaxListBytes);
  if (!text.ok()) return text.error();
  auto list = parseApprovalList(*text, arguments.from.string());
  if (!list.ok()) return list.error();
  return std::optional(std::move(*list));
}

}  // namespace

cli::CommandLine addApproveCommand(cli::CommandLine app, ApproveArguments& arguments) {
  const cli::CommandLine command =
      app.addSubcommand("approve", "accept the frames drawn now as goldens");
  addSuiteOptions(command, arguments.suite);
  addIncompleteOption(command, arguments.suite);
  command.addOption("-m,--message", arguments.message, "why; kept in the manifest").required();
  command
      .addOption("--from", arguments.from,
                 "only frames and runs of this list that match it (as copied from the report)")
      .valueName("LIST");
  const cli::Option artifact =
      command
          .addOption("--artifact", arguments.artifact,
                     "take the pictures of this report of CI (a folder or ZIP file) instead of "
                     "drawing")
          .valueName("DIR|ZIP")
          .needs("--from");
  for (const char* of_drawing :
       {"--log", "--only", "--tag", "--not-tag", "--shard", "--incomplete"}) {
    artifact.excludes(command.option(of_drawing));
  }
  command.addFlag("--also", arguments.also, "keep the pictures accepted so far");
  command.addFlag("-i,--interactive", arguments.interactive, "ask about each frame")
      .excludes(artifact);
  const cli::Option run =
      command
          .addOption("--run", arguments.run,
                     "add the log under test of this [[run]] to its accepted ones; draws nothing")
          .valueName("RUN")
          .excludes(artifact);
  command.addFlag("--replace", arguments.replace, "with --run: instead of those accepted so far")
      .needs(run);
  command.addFlag("--anyway", arguments.anyway,
                  "also a log of a run that `check` finds incompatible, or that widens what is "
                  "accepted very far; also pictures that lack a texture");
  return command;
}

std::string lacksRefusal(const std::vector<std::string>& lacks) {
  return fmt::format("not approved since {}{}; --anyway approves it all the same",
                     plainText(lacks.front()),
                     lacks.size() == 1 ? "" : fmt::format(", and {} more", lacks.size() - 1));
}

Result<cli::Exit> runApproveCommand(const ApproveArguments& arguments) {
  if (!arguments.run.empty()) return approveRunOfSuite(arguments);
  if (arguments.interactive && ::isatty(STDIN_FILENO) != 1) {
    return Error{ErrorKind::refused, "--interactive needs a terminal as standard input", {}};
  }
  auto list = listOf(arguments);
  if (!list.ok()) return list.error();
  if (!arguments.artifact.empty()) return approveArtifact(arguments, **list);
  const auto options = suiteOptions(arguments.suite);
  if (!options.ok()) return options.error();
  auto session = SuiteSession::open(arguments.suite.suite, *options);
  if (!session.ok()) return session.error();
  std::size_t runs_approved = 0, runs_refused = 0;
  if (*list) {
    for (const SuiteRun& run : session->suite().runs) {
      const auto listed = (*list)->find(run.name);
      if (listed == (*list)->end()) continue;
      const auto done = approveListedRun(arguments, run.name, listed->second);
      if (!done.ok()) cli::warn(done.error().text());
      ++(done.ok() ? runs_approved : runs_refused);
      (*list)->erase(listed);
    }
    if ((*list)->empty()) return runs_refused > 0 ? cli::Exit::no : cli::Exit::done;
  }
  if (session->frames().empty()) {
    return Error{ErrorKind::bad_argument, "no case is selected; --run RUN accepts the log of a run",
                 arguments.suite.suite.string()};
  }
  warnOfModelFaults(session->cell());
  std::size_t unknown = 0;
  if (*list) {
    for (const auto& [name, pixels] : **list) {
      if (std::ranges::find(session->frames(), name, &SuiteFrame::name) !=
          session->frames().end()) {
        continue;
      }
      cli::warn("the suite has no frame named in the list: " + name);
      ++unknown;
    }
  }
  auto counts = Approver(*session, *options, arguments, std::move(*list)).run();
  if (!counts.ok()) return counts.error();
  const std::size_t refused = counts->refused + unknown + runs_refused;
  fmt::print("{} approved, {} refused; goldens in {}\n",
             counts->approved + counts->unchanged + runs_approved, refused,
             session->suite().goldens.lexically_normal().string());
  if (counts->skipped > 0) fmt::print("{} left unchanged\n", counts->skipped);
  return refused > 0 ? cli::Exit::no : cli::Exit::done;
}

}  // namespace rocinante
