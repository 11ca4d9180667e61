#include "core/foreign/decode/decode_account_json.h"

namespace rocinante::decode {

Json accountJson(const DecodeAccount& account) {
  Json json;
  json["octets"] = account.octets;
  json["packets"] = account.decoded();
  json["decoders"] = Json::array();
  for (const DecodeAccount::Decoder& each : account.decoders) {
    Json decoder;
    decoder["decoder"] = each.name;
    decoder["packets"] = each.counts.decoded;
    decoder["refused"] = each.counts.refused;
    decoder["empty"] = each.counts.empty;
    decoder["reason"] = orNull(std::string(each.counts.last_reason));
    json["decoders"].push_back(std::move(decoder));
  }
  return json;
}

}  // namespace rocinante::decode
