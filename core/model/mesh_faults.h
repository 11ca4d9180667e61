#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/model/model_fault.h"

namespace rocinante {

/// Adds the faults of one mesh file to a list: the first twenty of each rule with their lines, then
/// one line that counts the rest, so that a broken file of a million lines stays readable.
class MeshFaults {
 public:
  MeshFaults(ModelFaults& faults, std::string file) : faults_(faults), file_(std::move(file)) {}
  ~MeshFaults();
  MeshFaults(const MeshFaults&) = delete;
  MeshFaults& operator=(const MeshFaults&) = delete;

  void add(Severity severity, std::string_view rule, int line, std::string text,
           std::string hint = {});
  /// The list that the faults go to, for those of another file.
  ModelFaults& list() { return faults_; }

 private:
  struct Count {
    std::size_t times = 0;
    Severity severity = Severity::note;
  };
  ModelFaults& faults_;
  std::string file_;
  std::map<std::string, Count, std::less<>> counts_;
};

/// `text` in backquotes for a fault's sentence: control characters escaped, cut when very long.
std::string quotedInFault(std::string_view text);

}  // namespace rocinante
