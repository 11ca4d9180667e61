#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/protobuf/protobuf_module.h"

namespace rocinante::protobuf {

/// A value of a message, in words.
struct NamedValue {
  std::string path;
  std::string value;
};

/// A message type of a FileDescriptorSet, by the module that knows libprotobuf. Any threads; what
/// it makes keeps it alive.
class Schema : public std::enable_shared_from_this<Schema> {
 public:
  /// refused: the module is not there; bad_argument: the set or the name, with one sentence.
  static Result<std::shared_ptr<const Schema>> open(std::string_view descriptor_set,
                                                    const std::string& message);
  ~Schema();
  Schema(const Schema&) = delete;
  Schema& operator=(const Schema&) = delete;

  /// Whether "a.b[2].c" leads to one value; bad_argument with one sentence.
  Status find(const std::string& path) const;

 private:
  friend class Reader;
  explicit Schema(RocinanteProtobufSchema* schema) : schema_(schema) {}

  RocinanteProtobufSchema* schema_;
};

/// Reads values of messages. One thread.
class Reader {
 public:
  /// Each path is one that Schema::find() found.
  Reader(std::shared_ptr<const Schema> schema, const std::vector<std::string>& paths);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Empty, or the reason why the bytes are no such message, which lives as long as the program.
  /// Texts of values() live until the next call.
  std::string_view read(ByteView message);
  const std::vector<RocinanteProtobufValue>& values() const { return values_; }
  /// Every value, also those of unknown fields ("a.#7"), but `known` ones; at most `most`.
  std::vector<NamedValue> others(ByteView message, const std::vector<std::string>& known,
                                 std::size_t most);

 private:
  std::shared_ptr<const Schema> schema_;
  RocinanteProtobufReader* reader_;
  std::vector<RocinanteProtobufValue> values_;
};

}  // namespace rocinante::protobuf
