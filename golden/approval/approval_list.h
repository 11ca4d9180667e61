#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// Pixel hashes by frame: what somebody saw and accepted, as the report's "select and copy" writes
/// it (docs/golden-suites.md, section "Lists of approvals").
using ApprovalList = std::map<std::string, std::string, std::less<>>;

/// bad_argument, with the line, for what is no such list.
Result<ApprovalList> parseApprovalList(std::string_view text, const std::string& file);
std::string approvalListText(const ApprovalList& list);

}  // namespace rocinante
