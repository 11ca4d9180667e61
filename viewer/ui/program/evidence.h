#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/child_process.h"
#include "core/base/model_search.h"
#include "core/base/result.h"
#include "viewer/view/camera.h"
#include "viewer/view/picture_terms.h"

namespace rocinante {

/// A picture of the window's content, drawn by rocinante-render in the reproducible profile, so
/// that anyone can reproduce its bytes.
struct EvidenceRequest : ModelSearch, PictureTerms {
  std::filesystem::path cell, log;  ///< as given to the viewer; `log` may be empty
  std::filesystem::path beside;     ///< as given to the viewer; empty: none
  std::string align;                ///< of it; may be empty
  std::string backdrop;             ///< as `--backdrop` takes it; empty: none
  std::string backdrop_offset;      ///< a duration
  double backdrop_opacity = 0;
  std::string at;      ///< RFC 3339, to the nanosecond; empty without a log
  std::string camera;  ///< by name; empty: `view`
  CameraView view;
  std::vector<std::string> joints;  ///< of `--joints`
  std::filesystem::path output;
  /// A video of this part instead of a picture at `at`: as `--from` and `--until` take them.
  std::optional<std::pair<std::string, std::string>> part;
};

/// The arguments of `rocinante-render`, without the program's name.
std::vector<std::string> evidenceArguments(const EvidenceRequest& request);

/// The arguments of `rocinante-golden` that append the picture to a suite as a case of this name; a
/// suite that is not there yet is made, of the same cell and log.
std::vector<std::string> caseArguments(const EvidenceRequest& request,
                                       const std::filesystem::path& suite, const std::string& name);

/// The last line of what `program` of ours wrote to its standard error, without its name.
std::string lastSentence(const std::string& text, const std::string& program);

/// A finished picture.
struct EvidenceMade {
  std::filesystem::path file;
  std::string doubt;  ///< why it may be wrong, as a sentence; empty: no doubt
};

/// A running rocinante-render process, so that the window stays responsive. It is ended with this,
/// and leaves no partial file. Not thread-safe.
class EvidenceRun {
 public:
  /// Starts the program beside this one, else the one in PATH. refused when it cannot be started.
  static Result<EvidenceRun> start(const EvidenceRequest& request);
  /// The same with another program of ours: `output` is what it makes.
  static Result<EvidenceRun> startProgram(const std::string& name, std::vector<std::string> words,
                                          std::filesystem::path output);

  /// Empty while it runs; then the file or its error. Does not wait.
  std::optional<Result<EvidenceMade>> poll();
  Result<EvidenceMade> wait() { return made(process_.wait()); }

 private:
  EvidenceRun(ChildProcess process, std::filesystem::path output, std::string name)
      : process_(std::move(process)), output_(std::move(output)), name_(std::move(name)) {}
  Result<EvidenceMade> made(const ChildProcess::End& end) const;

  ChildProcess process_;
  std::filesystem::path output_;
  std::string name_;  ///< of the program
};

/// "evidence-STEM-12.500s.png" in `folder`, or with -2, -3 appended if that exists; `kind` is
/// "evidence.png": what the name begins and ends with.
std::filesystem::path freeEvidenceName(const std::filesystem::path& folder, const std::string& stem,
                                       const std::string& moment,
                                       const std::string& kind = "evidence.png");

}  // namespace rocinante
