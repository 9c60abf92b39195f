#pragma once

#include <map>
#include <string>
#include <string_view>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge::tune {

/// What the page begins with, as JSON: the model, the presets, and the table of settings: of each its name, group,
/// help, what it takes, its default and its value.
[[nodiscard]] std::string beginningJson(const Scene&, const std::string& model, const Settings&);

/// Settings of texts by name; what is not named is as by default.
/// @throws Error  (Kind::Usage) if a name is none or a text is not taken: the message begins with the flag
[[nodiscard]] Settings settingsOf(const std::map<std::string, std::string>& texts);

/// The settings as a command line, as a configuration file and as Python, each of which makes the same picture, and
/// why those that cannot act on a picture do not, by name; as JSON: "command", "config", "python", "idle". What Python
/// does not have, lengths on paper and margins, it refuses.
[[nodiscard]] std::string takeAwayJson(const std::string& model, const Settings&);

}  // namespace inkedge::tune
