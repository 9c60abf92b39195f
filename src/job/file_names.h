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

/// Refuses a field in braces that is none of those that are filled in.
/// @param text  a name of an output or of metadata
/// @throws Error  (Kind::Usage)
void expectKnownFields(const std::string& text);

/// Whether the metadata of several views go into one file.
[[nodiscard]] bool hasOneMetadataFile(const Job&);

/// The maps that go into an output of pixels.
[[nodiscard]] std::vector<Map> mapsIn(const std::string& output, const Settings&);

/// The settings with all maps that go into these outputs.
[[nodiscard]] Settings withMapsOf(const std::vector<std::string>& outputs, Settings);

}  // namespace inkedge::job
