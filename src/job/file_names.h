#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <inkedge/job.h>

namespace inkedge::job {

/// The job's views, of which there is always one.
[[nodiscard]] std::vector<View> viewsOf(const Job&);

/// Where an output of a view goes. Of pictures "{map}" is left in it, which outputFiles() fills in.
[[nodiscard]] std::filesystem::path outputOf(const Job&, const std::string& output, const View&);

/// Where the metadata of a view goes; empty: nowhere.
[[nodiscard]] std::filesystem::path metadataFileOf(const Job&, const View&);

}  // namespace inkedge::job
