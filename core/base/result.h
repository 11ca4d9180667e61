#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace rocinante {

/// What a caller can do about a failure. Names are stable: scripts and exit codes depend on them.
enum class ErrorKind {
  not_found,     ///< the file, channel or device does not exist
  unreadable,    ///< it exists, but the system refused the read or the write
  damaged,       ///< the bytes break the format's own rules
  unsupported,   ///< valid, but made by a newer version or with an option we lack
  bad_argument,  ///< the user asked for something impossible
  refused,       ///< the system denies it: a port in use, no display, no permission
};

/// A failure, complete enough to print as it is.
struct Error {
  ErrorKind kind;
  std::string what;   ///< one sentence, no trailing newline: "chunk 7 fails its checksum"
  std::string where;  ///< file, address or argument, with the byte offset when there is one

  /// "chunk 7 fails its checksum (cell-3.mcap, byte 1048620)"
  std::string text() const { return where.empty() ? what : what + " (" + where + ")"; }
};

/// Either a value or the reason there is none. Dropping one does not compile under -Werror.
template <class T>
class [[nodiscard]] Result : public tl::expected<T, Error> {
 public:
  using Base = tl::expected<T, Error>;
  using Base::Base;
  Result(Error error) : Base(tl::unexpect, std::move(error)) {}

  bool ok() const { return this->has_value(); }
};

/// A Result that carries nothing: `Status{}` is success.
using Status = Result<void>;

}  // namespace rocinante
