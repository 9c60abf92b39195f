#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/settings.h>

namespace inkedge {

/// A setting that takes a finite number.
struct Number {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::string_view unit = {};  ///< as the manual calls it: "PX", "DEG"
    bool open = false;           ///< min and max themselves are not allowed
    bool zeroToo = false;        ///< 0 is, although it lies below min
};

/// A setting that takes a whole number.
struct Count {
    std::uint64_t min = 0;
    std::uint64_t max = std::numeric_limits<int>::max();
    std::string_view unit = "N";
    std::string_view last = {};         ///< max in words, where a file or a machine decides it
    bool suffixes = false;              ///< k, M and G stand for thousands, millions, thousands of millions
    std::span<const int> choices = {};  ///< if there are any: these numbers alone
};

/// A setting that takes one of these names. The index of a name is the value of its enumerator.
struct Choice {
    std::span<const std::string_view> names;
};

/// A setting that takes several of these names, with commas between them.
struct List {
    std::span<const std::string_view> names;
    std::string_view unit;  ///< as the manual calls one: "MAP"
};

/// A setting whose text has a form of its own.
struct Custom {
    std::string_view form;   ///< "WIDTHxHEIGHT"
    std::string (*range)();  ///< what is allowed, in words
    char separator = ',';    ///< of the texts that one is made of: SettingDescription::joined()
};

using Constraint = std::variant<Number, Count, Choice, List, Custom>;

/// What settings act on.
struct OutputKinds {
    bool pictures = false;  ///< of pixels, but for OpenEXR
    bool exr = false;
    bool vectors = false;  ///< SVG and PDF
    bool dxf = false;
    bool json = false;      ///< lines as JSON
    std::size_t views = 1;  ///< of each model
};

/// One setting: what flags, environment variables, configuration files, metadata and the manual derive from, and what
/// validate() holds settings to.
struct SettingDescription {
    std::string_view name;       ///< as on the command line without its dashes: "line-color"
    std::string_view shortName;  ///< a second name, or empty: "eye" for "camera-position"
    std::string_view group;      ///< heading in the help: "camera"
    std::string_view help;       ///< one line
    Constraint constraint;
    std::string_view rangeNote = {};       ///< what the manual adds to the constraint's range
    std::string_view defaultInWords = {};  ///< where the default depends on something, or has a better name
    /// A flag that may be given several times: the character that joins its texts. 0: it may be given once.
    char joinedBy = '\0';
    /// Why a value other than the default cannot act on such outputs, beside the other settings; empty: it acts.
    /// None: it always does.
    std::string_view (*idle)(const Settings&, const OutputKinds&) = nullptr;

    /// What the setting takes, with the unit: "DEG" or "sobel|farid".
    [[nodiscard]] INKEDGE_API std::string values() const;
    /// What is allowed, in words.
    [[nodiscard]] INKEDGE_API std::string range() const;
    /// The default as text, or in words where the default depends on something; empty: there is none.
    [[nodiscard]] INKEDGE_API std::string defaultValue() const;
    /// Sets the value from text.
    /// @throws Error  (Kind::Usage) if the setting cannot take the text: what was expected and what was found
    INKEDGE_API void set(Settings&, std::string_view text) const;
    /// Several texts as one, as set() takes them: "640x480", "1,2,3", "depth,types", "arm;leg".
    [[nodiscard]] INKEDGE_API std::string joined(std::span<const std::string> texts) const;
    /// The value as text that set() takes; empty where no value is given.
    [[nodiscard]] INKEDGE_API std::string get(const Settings&) const;
    /// @throws Error  (Kind::Usage) if the settings hold a value that set() would not take, with the same words
    INKEDGE_API void check(const Settings&) const;

    /// Where in Settings the value lies, and how it is read and written.
    struct Field {
        void (*set)(const Constraint&, Settings&, std::string_view text);
        std::string (*get)(const Constraint&, const Settings&);
        void (*check)(const Settings&) = nullptr;  ///< none: what get() gives must be a text that set() takes
    };
    Field field;
};

/// All settings in the order of the manual.
[[nodiscard]] INKEDGE_API std::span<const SettingDescription> settingTable();

/// The setting with a name or a second name, without dashes; none: there is none.
[[nodiscard]] INKEDGE_API const SettingDescription* findSetting(std::string_view name);

/// Sets one setting from text.
/// @param source  where the text comes from, for the message: "--kernel" or "INKEDGE_KERNEL"
/// @throws Error  (Kind::Usage) if no setting bears the name or it cannot take the text
INKEDGE_API void set(Settings&, std::string_view name, std::string_view text, std::string_view source);

/// The settings that differ from their defaults and cannot act, one line each, by the command's flags: "--page-size
/// does nothing: it is for .svg; --size takes millimetres".
[[nodiscard]] INKEDGE_API std::vector<std::string> idleSettings(const Settings&, const OutputKinds&);

/// Holds every value to its row of the table. What draws, loads and frames does so first.
/// @throws Error  (Kind::Usage) at the first that its row does not allow: "sumi-width: expected a number from 1 to 32,
///                found '-5'"
INKEDGE_API void validate(const Settings&);
INKEDGE_API void validate(const RenderSettings&);
INKEDGE_API void validate(const LoadSettings&);
INKEDGE_API void validate(const CameraSettings&);
INKEDGE_API void validate(const FrameSettings&);
INKEDGE_API void validate(const BackendSettings&);

/// A named set of settings.
struct Preset {
    std::string_view name;
    std::string_view help;
    std::vector<std::pair<std::string_view, std::string_view>> values;  ///< setting, text
};
[[nodiscard]] INKEDGE_API const std::vector<Preset>& presets();

/// Sets what a preset says; what it does not say stays.
/// @param source  where its name comes from, for the message: "--preset"
/// @throws Error  (Kind::Usage) if no preset bears the name
INKEDGE_API void setPreset(Settings&, std::string_view name, std::string_view source);

/// The settings that differ from their defaults as lines of a configuration file: readConfig() of them gives the same.
[[nodiscard]] INKEDGE_API std::string configText(const Settings&);

/// Sets what a configuration file says: lines name = value in the words of settingTable(), the value between double
/// quotes or not; empty lines and those that start with # are left out. A later line wins over an earlier one.
/// @throws Error  (Kind::Input) if the file cannot be read or has over 1 MiB; (Kind::Usage) if a line is none of these,
///                names no setting or has a value that it cannot take: the message names file and line. What earlier
///                lines say is then set.
INKEDGE_API void readConfig(Settings&, const std::filesystem::path& file);

}  // namespace inkedge
