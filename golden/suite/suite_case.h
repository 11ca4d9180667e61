#pragma once

#include <string>
#include <string_view>

#include "golden/suite/suite.h"
#include "golden/suite/suite_table.h"

namespace rocinante {

/// True for letters, digits, `_`, `-` and `.` alone: what may stand in a file's name.
bool isFileText(std::string_view text);
/// The same, at most 100 bytes, that does not begin with `.` or `-`: what may name a case.
bool isCaseName(std::string_view name);

/// The keys that [defaults] and a [[case]] share, where they are given. `limit_from` is where the
/// table stands, for the verdicts' sentences.
void readCaseLook(SuiteTable& table, const Suite& suite, SuiteCase& made);
/// A whole [[case]]; `made` holds the defaults.
void readCase(SuiteTable& table, const Suite& suite, SuiteCase& made);
/// [defaults].
void readDefaults(SuiteTable& table, const Suite& suite, SuiteCase& made);
/// The limits of a [tolerance.NAME] or of a case's own { ... }.
Tolerance readLimits(SuiteTable& table, std::string name);

}  // namespace rocinante
