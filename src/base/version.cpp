#include <inkedge/version.h>

namespace inkedge {

std::string_view version() noexcept { return INKEDGE_VERSION; }

}  // namespace inkedge
