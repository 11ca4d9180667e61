#pragma once

#include "core/foreign/decode/decode_account.h"
#include "core/report/json_text.h"

namespace rocinante::decode {

/// {"octets", "packets", "decoders": [{"decoder", "packets", "refused", "empty", "reason"}]}.
Json accountJson(const DecodeAccount& account);

}  // namespace rocinante::decode
