#include "core/foreign/decode/decoder_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/document/toml_table.h"
#include "core/foreign/decode/checksum.h"
#include "core/foreign/decode/field_table.h"
#include "core/foreign/decode/line_table.h"
#include "core/foreign/decode/toml_values.h"
#include "core/foreign/protobuf/protobuf_schema.h"
#include "core/packet/text_name.h"

namespace rocinante::decode {
namespace {

constexpr std::size_t kMaxNameBytes = 200;  // "decoded:" is put in front
constexpr std::int64_t kMaxBytes = std::int64_t{1} << 30U;
const std::vector<std::string_view> kKinds{"struct", "delimited", "json", "xml", "dis", "protobuf"};
const std::vector<std::string_view> kSums{"sum8",         "xor8",          "crc16-ccitt",
                                          "crc16-modbus", "crc16-mcrf4xx", "crc32"};

class DecoderTable {
 public:
  DecoderTable(TomlTable& table, DescriptorFiles& files, FaultList& faults)
      : table_(table), files_(files), faults_(faults) {}

  Decoder read() {
    decoder_.place = table_.place();
    readName();
    const auto kind = choiceAt(table_, "kind", kKinds);
    if (!table_.has("kind")) {
      table_.error("decoder.missing-key", "name", "a decoder needs `kind`",
                   "struct, delimited, json, xml, dis or protobuf");
    }
    decoder_.kind = static_cast<Kind>(kind.value_or(0));
    readMatch();
    const bool little = isLittleEndian(table_, true);
    readOfKind(little);
    FieldTable fields(decoder_, faults_);
    fields.read(table_, little);
    readConditions(fields);
    LineTable(decoder_, fields, faults_).read(table_);
    table_.finish();
    return std::move(decoder_);
  }

 private:
  void readName() {
    decoder_.name = table_.requiredName("name").value_or("");
    for (const char each : decoder_.name) {
      if (isNameByte(each) && decoder_.name.size() <= kMaxNameBytes) continue;
      table_.error(kBadValue, "name", quotedInFault(decoder_.name) + " is not a decoder's name",
                   "use at most 200 letters, digits and _ . - :");
      return;
    }
  }

  void readMatch() {
    Match& match = decoder_.match;
    if (const TomlNode* const port = table_.node("port")) {
      const bool several = port->kind == TomlNode::Kind::array;
      const auto add = [&](const TomlNode& node) {
        if (const auto one = wholeOf(node, "port", 1, 65535, faults_)) {
          match.ports.push_back(static_cast<std::uint16_t>(*one));
        }
      };
      if (!several) add(*port);
      for (std::size_t i = 0; several && i < port->items.size(); ++i) add(port->items[i]);
    }
    match.from = oneOrMoreTexts(table_, "from");
    match.topics = oneOrMoreTexts(table_, "topic");
    match.begins = hexBytes(table_, "begins");
    if (const auto text = table_.text("begins_with")) {
      const ByteView bytes = rocinante::bytesOf(*text);
      match.begins.assign(bytes.begin(), bytes.end());
      if (table_.has("begins")) {
        table_.error(kBadValue, "begins_with", "give `begins` or `begins_with`, not both");
      }
    }
    match.least_bytes = match.begins.size();
    const TomlNode* const bytes = table_.node("bytes");
    if (bytes == nullptr) return;
    const bool is_range = bytes->kind == TomlNode::Kind::array && bytes->items.size() == 2;
    const auto least = wholeOf(is_range ? bytes->items[0] : *bytes, "bytes", 0, kMaxBytes, faults_);
    const auto most = wholeOf(is_range ? bytes->items[1] : *bytes, "bytes", 0, kMaxBytes, faults_);
    if (!least || !most) return;
    match.least_bytes = std::max(match.least_bytes, static_cast<std::size_t>(*least));
    match.most_bytes = static_cast<std::size_t>(*most);
  }

  void readOfKind(bool little_endian) {
    const Kind kind = decoder_.kind;
    if (kind == Kind::structure || kind == Kind::delimited) readChecksum(little_endian);
    if (kind == Kind::structure) {
      decoder_.zero_filled = table_.flag("zero_filled").value_or(false);
      if (decoder_.zero_filled && !decoder_.checksum) {
        table_.error(kBadValue, "zero_filled", "`zero_filled` needs a checksum behind the fields");
      }
    }
    if (kind == Kind::dis) readOrigin();
    if (kind == Kind::protobuf) readMessage();
    if (kind == Kind::delimited) {
      decoder_.separator = table_.text("separator").value_or(",");
      if (decoder_.separator.empty() || decoder_.separator.size() > 16) {
        table_.error(kBadValue, "separator", "`separator` must have 1 to 16 bytes");
        decoder_.separator = ",";
      }
    }
  }

  void readMessage() {
    const std::optional<std::string> file = table_.requiredText("descriptor");
    const std::optional<std::string> message = table_.requiredText("message");
    if (!file || !message) return;
    const Result<std::string_view> bytes = files_.read(*file);
    if (!bytes) {
      table_.error(kBadValue, "descriptor", bytes.error().text());
      return;
    }
    auto schema = protobuf::Schema::open(*bytes, *message);
    if (!schema) {
      table_.error(kBadValue, schema.error().kind == ErrorKind::refused ? "kind" : "descriptor",
                   quotedInFault(*file) + ": " + plainText(schema.error().what));
      return;
    }
    decoder_.schema = std::move(*schema);
  }

  void readOrigin() {
    std::optional<TomlTable> table = table_.table("origin", "`origin`");
    if (!table) return;
    const auto within = [&](const char* key, double least, double most) {
      const std::optional<double> number = table->number(key);
      if (number && *number >= least && *number <= most) return *number;
      if (number) {
        table->error(kBadValue, key, fmt::format("`{}` is {} to {}", key, least, most));
      } else if (!table->has(key)) {
        table->error("decoder.missing-key", key, fmt::format("`origin` needs `{}`", key),
                     "latitude and longitude in degrees, height in metres above the ellipsoid");
      }
      return 0.0;
    };
    decoder_.origin = {within("latitude", -90, 90), within("longitude", -360, 360),
                       within("height", -12'000, 1e9)};
    table->finish();
  }

  void readChecksum(bool little_endian) {
    std::optional<TomlTable> table = table_.table("checksum", "`checksum`");
    if (!table) return;
    Checksum sum;
    const auto kind = choiceAt(*table, "kind", kSums);
    if (!table->has("kind")) {
      table->error("decoder.missing-key", "kind", "a checksum needs `kind`", "crc16-ccitt, ...");
    }
    sum.kind = static_cast<ChecksumKind>(kind.value_or(0));
    if (decoder_.kind == Kind::structure) {
      const auto bytes = static_cast<std::int64_t>(checksumBytes(sum.kind));
      sum.from = wholeAt(*table, "from", -kMaxBytes, kMaxBytes).value_or(0);
      sum.at = wholeAt(*table, "at", -kMaxBytes, kMaxBytes).value_or(-bytes);
      sum.until = wholeAt(*table, "until", -kMaxBytes, kMaxBytes).value_or(sum.at);
      sum.little_endian = isLittleEndian(*table, little_endian);
      sum.then = hexBytes(*table, "then");
    } else if (sum.kind != ChecksumKind::xor8 && sum.kind != ChecksumKind::sum8) {
      table->error(kBadValue, "kind", "delimited text has xor8 or sum8 behind `*`");
    }
    table->finish();
    decoder_.checksum = sum;
  }

  void readConditions(FieldTable& fields) {
    const TomlNode* const where = table_.node("where");
    if (where == nullptr) return;
    if (where->kind != TomlNode::Kind::table) {
      table_.error(kBadValue, "where", "`where` is a table: { FIELD = NUMBER }");
      return;
    }
    for (const TomlNode::Entry& entry : where->entries) {
      const auto index = fields.find(entry.key, entry.place);
      const bool is_number =
          entry.value.kind == TomlNode::Kind::integer || entry.value.kind == TomlNode::Kind::number;
      if (!is_number) {
        faults_.error(kBadValue, entry.value.place, "a condition of `where` is a number");
      } else if (index) {
        decoder_.match.where.push_back({*index, entry.value.number});
      }
    }
  }

  TomlTable& table_;
  DescriptorFiles& files_;
  FaultList& faults_;
  Decoder decoder_;
};

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

std::string_view nameOf(Kind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::vector<Decoder> decodersIn(const TomlNode& document, DescriptorFiles& files,
                                FaultList& faults) {
  TomlTable whole(document, "the file", faults);
  std::vector<Decoder> decoders;
  if (const auto format = wholeAt(whole, "format", 0, 1'000'000); format.value_or(1) != 1) {
    whole.error(kBadValue, "format", "only format 1 of decoders is known");
  }
  for (TomlTable& table : whole.tables("decoder", "[[decoder]]")) {
    if (decoders.size() == kMaxDecoders) {
      faults.error(kBadValue, table.place(),
                   fmt::format("a file has at most {} decoders", kMaxDecoders));
      break;
    }
    Decoder decoder = DecoderTable(table, files, faults).read();
    if (std::ranges::find(decoders, decoder.name, &Decoder::name) != decoders.end()) {
      faults.error("decoder.same-name", decoder.place,
                   fmt::format("a second decoder {}", quotedInFault(decoder.name)));
    }
    decoders.push_back(std::move(decoder));
  }
  if (decoders.empty()) {
    faults.error("decoder.missing-key", whole.place(), "the file declares no [[decoder]]");
  }
  whole.finish();
  return decoders;
}

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
