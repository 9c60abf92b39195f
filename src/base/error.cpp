#include <inkedge/error.h>

namespace inkedge {

Error::~Error() = default;  // out of line: one type_info, so that catching works across the library's border

}  // namespace inkedge
