#pragma once

#include <string>

#include "core/base/struct_wire.h"
#include "core/report/account.h"

namespace rocinante {

/// An account among the fields of a struct: its lines.
template <class Fields>
void fields(Fields& io, Taken<Fields, Account>& account) {
  if constexpr (Fields::kReads) {
    std::string lines;
    io(lines);
    account = accountOfLines(lines);
  } else {
    io(accountLines(account));
  }
}

}  // namespace rocinante
