#pragma once

#include <string>
#include <vector>

#include <inkedge/compare_lines.h>

#include "cli/settings_sources.h"

namespace inkedge::cli {

/// Whether models are drawn with a setting to compare their lines.
[[nodiscard]] bool actsOnComparedLines(const SettingDescription&);

/// Flags that were given in vain where no model is drawn, one line each.
[[nodiscard]] std::vector<std::string> idleWithoutModels(const SettingsSources&);

/// The lines of two inputs: files of lines or pictures as they are, and models drawn by one camera. That is the camera
/// of the other input where this is lines as JSON, else the one that the settings ask for, framed on the first model.
struct ComparedInputs {
    ComparedLines a;
    ComparedLines b;
    HiddenChanges hidden = HiddenChanges::Count;
    std::vector<std::string> warnings;
};
[[nodiscard]] ComparedInputs readComparedInputs(const std::string& a, const std::string& b, const SettingsSources&);

}  // namespace inkedge::cli
