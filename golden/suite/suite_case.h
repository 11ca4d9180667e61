#pragma once

#include <string>
#include <string_view>

#include "golden/suite/suite.h"
#include "golden/suite/suite_table.h"

namespace rocinante {

/// True when the text has only letters, digits, `_`, `-` and `.`, as allowed in file names.
bool isFileText(std::string_view text);
/// True for a case name: the same characters, at most 100 bytes, not starting with `.` or `-`.
bool isCaseName(std::string_view name);

/// Reads the keys common to [defaults] and [[case]].
void readCaseLook(SuiteTable& table, const Suite& suite, SuiteCase& made);
/// Reads a [[case]]; `made` holds the defaults.
void readCase(SuiteTable& table, const Suite& suite, SuiteCase& made);
/// Reads [defaults].
void readDefaults(SuiteTable& table, const Suite& suite, SuiteCase& made);
/// Reads the limits of a [tolerance.NAME] or of a case's { ... }.
Tolerance readLimits(SuiteTable& table, std::string name);

}  // namespace rocinante
