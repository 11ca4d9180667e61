#include "core/foreign/decode/decoder_set.h"

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/foreign/decode/declaration_reader.h"

namespace rocinante::decode {
namespace {

Error firstFault(const Findings& found) {
  const Finding& first = found.front();
  std::string text = first.text;
  if (!first.hint.empty()) text += " (" + first.hint + ")";
  if (found.size() > 1) text += fmt::format("; {} more", found.size() - 1);
  return {ErrorKind::bad_argument, std::move(text), first.place()};
}

std::string sha256Of(std::string_view text) {
  Sha256 hash;
  hash.add(rocinante::bytesOf(text));
  return hexOf(hash.finish());
}

}  // namespace

Result<std::shared_ptr<const DecoderSet>> parseDecoders(std::string_view text,
                                                        const std::string& file) {
  const Result<TomlNode> document = parseToml(text, file);
  if (!document) return document.error();
  auto set = std::make_shared<DecoderSet>();
  set->file = file;
  set->text = text;
  Findings found;
  {
    FaultList faults(found, file);
    DescriptorFiles files(file);
    set->decoders = decodersIn(*document, files, faults);
    set->descriptors = files.files();
  }
  if (!found.empty()) return firstFault(found);
  std::string hashed(text);
  for (const DescriptorFiles::File& each : set->descriptors) hashed += sha256Of(each.bytes);
  set->hash = sha256Of(hashed);
  return std::shared_ptr<const DecoderSet>(std::move(set));
}

Result<std::shared_ptr<const DecoderSet>> readDecoders(const std::filesystem::path& file) {
  const Result<std::string> text = readFile(file, kMaxFileBytes);
  if (!text) return text.error();
  return parseDecoders(*text, file.string());
}

}  // namespace rocinante::decode
