#include <inkedge/error.h>

namespace inkedge {

Error::~Error() = default;  // not inline: one type_info, so that an Error can be caught across the library's border

}  // namespace inkedge
