#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <inkedge/line_types.h>

#include "batch/agreement.h"
#include "batch/batch.h"
#include "io/metadata.h"

namespace inkedge::batch {

/// What became of an item: a line of the results.
struct Result {
    std::string id = {};
    State state = State::Drawn;
    std::string model = {};
    std::string key = {};                 ///< keyOf() it
    std::vector<std::string> files = {};  ///< within the output or its shard
    double seconds = 0.0;  ///< of work on it, without those in which it waited for other items
    std::uint64_t triangles = 0;
    LineLengths lengths{};  ///< of all views
    std::optional<Agreement> score = {};
    std::vector<std::string> warnings = {};
    std::string error = {};            ///< empty: none
    std::optional<double> limit = {};  ///< seconds or bytes, of State::Timeout and State::Memory
    io::Json others = {};              ///< the model's other files, by name, with the hashes of what they hold; or null
};

/// Names of line types and their lengths in pixels, as far as there are any.
[[nodiscard]] io::Json lengthsJson(const LineLengths&);

/// One line of JSON, its end included. It begins with the id and the state.
[[nodiscard]] std::string lineOf(const Result&);

/// What a line says that decides what is still to be done; none: it is no result.
struct EarlierResult {
    std::string id = {};
    State state = State::Drawn;
    std::string key = {};
    std::string error = {};
    std::optional<double> limit = {};
    io::Json others = {};
};
[[nodiscard]] std::optional<EarlierResult> earlierResult(std::string_view line);

/// Its start alone: the id, as the line has it, and the state; none: it is no result.
struct ResultStart {
    std::string_view id;
    bool drawn = false;
};
[[nodiscard]] std::optional<ResultStart> startOf(std::string_view line);

}  // namespace inkedge::batch
