#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/report/finding.h"

namespace rocinante {

/// A place in a file, from 1; zeros when there is none.
struct Place {
  int line = 0;
  int column = 0;
};

/// Adds the faults of one cell, model or mesh file to a list: the first hundred of each rule, then
/// one line that counts the rest, so that a hostile file cannot fill the memory with messages.
class FaultList {
 public:
  FaultList(Findings& faults, std::string file) : faults_(faults), file_(std::move(file)) {}
  ~FaultList();
  FaultList(const FaultList&) = delete;
  FaultList& operator=(const FaultList&) = delete;

  void add(Severity severity, std::string_view rule, Place place, std::string text,
           std::string hint = {});
  void error(std::string_view rule, Place place, std::string text, std::string hint = {}) {
    add(Severity::error, rule, place, std::move(text), std::move(hint));
  }
  void warning(std::string_view rule, Place place, std::string text, std::string hint = {}) {
    add(Severity::warning, rule, place, std::move(text), std::move(hint));
  }
  void note(std::string_view rule, Place place, std::string text, std::string hint = {}) {
    add(Severity::note, rule, place, std::move(text), std::move(hint));
  }

  /// Something of the file that is not used: one note (or warning) for each `kind` and `name`, at
  /// the place of the first, with their count; part of the file's account (core/report/account.h,
  /// which explains the words). `reason` is a clause: "instancing is not drawn". `rule` is another
  /// than model.left-out where a rule of its own explains it; `count` is of things that the caller
  /// has counted.
  void leaveOut(std::string_view kind, std::string_view name, Place place, std::string reason,
                Severity severity = Severity::note, std::string_view rule = "model.left-out",
                std::string hint = {}, std::uint64_t count = 1);

  /// Whether one more of this rule would be listed: hints for the rest are not computed.
  bool lists(std::string_view rule) const;

  const std::string& file() const { return file_; }
  /// The list that this one adds to: for files that this file names.
  Findings& all() { return faults_; }

 private:
  struct Count {
    std::size_t times = 0;
    Severity severity = Severity::note;
  };
  Findings& faults_;
  std::string file_;
  std::map<std::string, Count, std::less<>> counts_;
  std::map<std::string, std::size_t, std::less<>> left_out_;  ///< to their places in faults_
};

/// `text` in backquotes for a fault's message: control characters escaped, cut when very long.
std::string quotedInFault(std::string_view text);
/// The same of a file's name or path: a long one loses its first folders, and keeps the file's own
/// name.
std::string quotedPathInFault(std::string_view path);

}  // namespace rocinante
