#include "viewer/ui/program/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/cli/search_options.h"
#include "viewer/view/camera_choice.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// A message line without the program's name.
std::string sentenceOf(std::string line, const std::string& program) {
  if (line.starts_with(program + ": ")) line.erase(0, program.size() + 2);
  return line;
}

std::string firstSentence(const std::string& text, const std::string& program) {
  return sentenceOf(text.substr(0, text.find('\n')), program);
}

}  // namespace

std::string lastSentence(const std::string& text, const std::string& program) {
  return sentenceOf(text.substr(text.rfind('\n') + 1), program);
}

std::vector<std::string> evidenceArguments(const EvidenceRequest& request) {
  std::vector<std::string> words{request.cell.string()};
  if (!request.log.empty()) words.push_back(request.log.string());
  const auto add = [&](std::string option, std::string value) {
    words.push_back(std::move(option));
    words.push_back(std::move(value));
  };
  if (request.part) {
    add("--from", request.part->first);
    add("--until", request.part->second);
  } else if (!request.at.empty()) {
    add("--at", request.at);
  }
  if (!request.beside.empty()) add("--beside", request.beside.string());
  if (!request.align.empty()) words.push_back("--align=" + request.align);
  words.push_back("--camera=" +
                  (request.camera.empty() ? viewpointText(request.view) : request.camera));
  if (!request.backdrop.empty()) {
    add("--backdrop", request.backdrop);
    words.push_back("--backdrop-offset=" + request.backdrop_offset);
    add("--backdrop-opacity", fmt::format("{}", request.backdrop_opacity));
  }
  for (const std::string& joints : request.joints) words.push_back("--joints=" + joints);
  for (const auto& more : {pictureWords(request), cli::searchWords(request)}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  add(request.part ? "--video" : "-o", request.output.string());
  return words;
}

std::vector<std::string> caseArguments(const EvidenceRequest& request, const fs::path& suite,
                                       const std::string& name) {
  std::vector<std::string> words{"add", suite.string(), "--case", name};
  const auto add = [&](const char* option, const std::string& value) {
    words.emplace_back(option);
    words.push_back(value);
  };
  // Names in a suite count from its folder. A suite that exists must be of these files.
  std::error_code fault;
  const auto named = [&](const fs::path& file) {
    const fs::path folder = fs::absolute(suite, fault).parent_path();
    return fs::absolute(file, fault).lexically_relative(folder).string();
  };
  add("--cell", named(request.cell));
  if (!request.log.empty()) add("--log", named(request.log));
  if (!request.at.empty()) add("--at", request.at + "s");
  words.push_back("--camera=" +
                  (request.camera.empty() ? viewpointText(request.view) : request.camera));
  const std::vector<std::string> terms = pictureWords(request, StyleOptions::one);
  words.insert(words.end(), terms.begin(), terms.end());
  return words;
}

Result<EvidenceRun> EvidenceRun::start(const EvidenceRequest& request) {
  return startProgram("rocinante-render", evidenceArguments(request), request.output);
}

Result<EvidenceRun> EvidenceRun::startProgram(const std::string& name,
                                              std::vector<std::string> words, fs::path output) {
  const std::string program = programBeside(name);
  words.insert(words.begin(), program);
  Result<ChildProcess> process = ChildProcess::start(words, {});
  if (!process) {
    return Error{ErrorKind::refused, "cannot start " + name + ": " + process.error().what, program};
  }
  return EvidenceRun(std::move(*process), std::move(output), name);
}

Result<EvidenceMade> EvidenceRun::made(const ChildProcess::End& end) const {
  if (end.ok()) return EvidenceMade{output_, {}};
  // With exit 1 the picture exists, and the first message says what may be wrong with it.
  const bool is_doubt = !end.by_signal && end.code == 1;
  const std::string message = process_.errorOutput();
  std::string why = is_doubt ? firstSentence(message, name_) : lastSentence(message, name_);
  if (why.empty()) why = name_ + " failed without a message";
  if (is_doubt) return EvidenceMade{output_, std::move(why)};
  return Error{ErrorKind::refused, std::move(why), {}};
}

std::optional<Result<EvidenceMade>> EvidenceRun::poll() {
  const auto end = process_.poll();
  if (!end) return std::nullopt;
  return made(*end);
}

fs::path freeEvidenceName(const fs::path& folder, const std::string& stem,
                          const std::string& moment, const std::string& kind) {
  const std::size_t ending = std::min(kind.rfind('.'), kind.size());
  std::error_code ignored;
  for (int number = 1;; ++number) {
    const std::string again = number == 1 ? std::string() : fmt::format("-{}", number);
    const std::string time = moment.empty() ? std::string() : fmt::format("-{}s", moment);
    fs::path name = folder / fmt::format("{}-{}{}{}{}", kind.substr(0, ending), stem, time, again,
                                         kind.substr(ending));
    if (!fs::exists(name, ignored)) return name;
  }
}

}  // namespace rocinante
