#pragma once

#include <string>

namespace inkedge {

/// Wall time of one stage, milliseconds.
struct StageTime {
    std::string stage;
    double milliseconds = 0.0;
};

}  // namespace inkedge
