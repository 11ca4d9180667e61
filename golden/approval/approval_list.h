#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// Pixel hashes by frame name: the frames that a person accepted, as the report page copies them
/// (docs/golden-suites.md, section "Lists of approvals").
using ApprovalList = std::map<std::string, std::string, std::less<>>;

/// bad_argument, with the line, when the text is not such a list.
Result<ApprovalList> parseApprovalList(std::string_view text, const std::string& file);
std::string approvalListText(const ApprovalList& list);

}  // namespace rocinante
