#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/json_parse.h"
#include "core/foreign/decode/field_reader.h"
#include "core/packet/text_number.h"

namespace rocinante::decode {
namespace {

using Tree = nlohmann::json;

/// "/joints/0" in its parts; ~1 is / and ~0 is ~ (RFC 6901).
std::vector<std::string> tokensOf(std::string_view pointer) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < pointer.size(); ++at) {
    if (pointer[at] == '/') {
      tokens.emplace_back();
    } else if (pointer[at] == '~' && at + 1 < pointer.size()) {
      tokens.back() += pointer[++at] == '1' ? '/' : '~';
    } else {
      tokens.back() += pointer[at];
    }
  }
  return tokens;
}

class JsonReader final : public FieldReader {
 public:
  explicit JsonReader(const Decoder& decoder) : decoder_(decoder) {
    for (const Field& field : decoder.fields) pointers_.push_back(tokensOf(field.path));
  }

  bool read(ByteView datagram, std::span<FieldValue> values) override {
    if (!parse(datagram)) return refuse("it is not JSON");
    for (std::size_t i = 0; i < pointers_.size(); ++i) {
      const Tree* const found = valueAt(pointers_[i]);
      values[i] = found == nullptr ? FieldValue() : valueOf(*found);
    }
    return true;
  }

  std::vector<FoundField> undeclared(ByteView datagram, std::size_t most) override {
    std::vector<FoundField> found;
    if (!parse(datagram)) return found;
    std::vector<std::pair<std::string, const Tree*>> open{{"", &tree_}};
    while (!open.empty() && found.size() < most) {
      const auto [path, node] = std::move(open.back());
      open.pop_back();
      if (!node->is_structured()) {
        const auto declares = [&where = path](const Field& field) { return field.path == where; };
        if (std::any_of(decoder_.fields.begin(), decoder_.fields.end(), declares)) continue;
        found.push_back({path, node->is_string() ? node->get<std::string>() : node->dump()});
        continue;
      }
      std::vector<std::pair<std::string, const Tree*>> inside;
      for (const auto& [key, value] : node->items()) {
        inside.emplace_back(path + "/" + escaped(key), &value);
      }
      open.insert(open.end(), inside.rbegin(), inside.rend());
    }
    return found;
  }

 private:
  bool parse(ByteView datagram) {
    std::string_view text = textOf(datagram);
    while (text.ends_with('\0')) text.remove_suffix(1);
    tree_ = parseJsonOrDiscard<Tree>(text);
    return !tree_.is_discarded() && tree_.is_structured();
  }

  /// Not the library's pointers: those throw.
  const Tree* valueAt(const std::vector<std::string>& tokens) const {
    const Tree* node = &tree_;
    for (const std::string& token : tokens) {
      if (node->is_object()) {
        const auto found = node->find(token);
        if (found == node->end()) return nullptr;
        node = &*found;
      } else if (node->is_array()) {
        const std::optional<std::uint64_t> index = readUnsigned(token);
        if (!index || *index >= node->size()) return nullptr;
        node = &(*node)[static_cast<std::size_t>(*index)];
      } else {
        return nullptr;
      }
    }
    return node;
  }

  static FieldValue valueOf(const Tree& value) {
    if (value.is_boolean()) return FieldValue::of(value.get<bool>() ? 1.0 : 0.0);
    if (value.is_number()) return FieldValue::of(value.get<double>());
    if (value.is_string())
      return FieldValue::of(std::string_view(value.get_ref<const std::string&>()));
    return {};
  }

  static std::string escaped(const std::string& key) {
    std::string text;
    for (const char byte : key) {
      if (byte == '~') {
        text += "~0";
      } else if (byte == '/') {
        text += "~1";
      } else {
        text += byte;
      }
    }
    return text;
  }

  const Decoder& decoder_;
  std::vector<std::vector<std::string>> pointers_;
  Tree tree_;
};

}  // namespace

std::unique_ptr<FieldReader> makeJsonReader(const Decoder& decoder) {
  return std::make_unique<JsonReader>(decoder);
}

}  // namespace rocinante::decode
