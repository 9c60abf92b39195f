#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <inkedge/job.h>

namespace inkedge::job {

/// The job's views, of which there is always one.
[[nodiscard]] std::vector<View> viewsOf(const Job&);

/// Where an output of a view goes: lines to one file, a picture as outputFiles() says.
/// @throws Error  (Kind::Usage) as filesOf()
[[nodiscard]] std::vector<std::filesystem::path> filesOfOutput(const Job&, const std::string& output, const View&);

/// Where the metadata of a view goes; empty: nowhere.
/// @throws Error  (Kind::Usage) as filesOf()
[[nodiscard]] std::filesystem::path metadataFileOf(const Job&, const View&);

}  // namespace inkedge::job
