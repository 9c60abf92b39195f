#include <inkedge/error.h>

#include "base/message.h"

namespace inkedge {

Error::Error(Kind kind, const std::string& message) : std::runtime_error{base::printable(message)}, kind_{kind} {}

Error::~Error() = default;  // not inline: one type_info, so that an Error can be caught across the library's border

}  // namespace inkedge
