#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <inkedge/export.h>

namespace inkedge {

enum class Kernel : int;

/// A function on surfaces whose edges become lines: Hertzmann 1999, section 2.1.3. surfaceFunction() makes one.
struct FunctionSettings {
    std::string name;                ///< of a row of functionTable()
    Kernel kernel{};                 ///< Sobel's unless given
    std::optional<float> threshold;  ///< T of equation 7; none: the row's, for the kernel in force
    std::vector<double> options;     ///< one for each of the row's, in its order
    std::string file;                ///< a picture, or the shader of "custom"; empty: none
};

/// A number that a function takes.
struct FunctionOption {
    std::string_view name;
    std::string_view help;  ///< with the unit
    double defaultValue;
    double low;  ///< smallest value that is allowed
    double high;
    std::span<const std::string_view> choices = {};  ///< if there are any: the value is the index of one of these
};

/// How differences are taken of a function whose values start again from 0 at some point. Such a function has values in
/// its first two channels only.
enum class Wrapping {
    None,
    Unit,   ///< modulo 1, as for coordinates of a repeated texture; not where the function has a picture
    Steps,  ///< values count steps of the first option's size; modulo the number of steps that make 1
};

/// What a function reads besides the shape; a model is loaded with it only then.
struct FunctionNeeds {
    bool coordinates = false;  ///< Mesh::textureCoordinates
    bool paint = false;        ///< vertex colours, the materials' colours and pictures
    bool curvature = false;    ///< Mesh::curvatures
};

/// The name of the function that a user's file defines.
inline constexpr std::string_view customFunction = "custom";

/// A function: its shader is shaders/functions/NAME.glsl.
struct FunctionDescription {
    std::string_view name;
    std::string_view help;  ///< one line
    std::span<const FunctionOption> options;
    /// What FunctionSettings::file holds: "PICTURE" (PNG, JPEG or WebP) or "GLSL"; empty: nothing.
    std::string_view file;
    float threshold;  ///< the default T with Sobel's kernels, which give a step of 1 the magnitude 4
    /// The value on the background; none: borders of surfaces against the background are no edges.
    std::optional<float> background;
    Wrapping wrapping;
    FunctionNeeds needs;
};

/// All functions in the order of the manual.
[[nodiscard]] INKEDGE_API std::span<const FunctionDescription> functionTable() noexcept;

/// The row of this name.
/// @throws Error  (Kind::Usage) if there is none; the message lists all names
[[nodiscard]] INKEDGE_API const FunctionDescription& functionDescription(std::string_view name);

/// A function from text: NAME[:key=value,...]. The keys are kernel, threshold, file and the options of the function's
/// row. A first item without = is the file.
/// @throws Error  (Kind::Usage) if the text has another form; the message lists what is allowed
[[nodiscard]] INKEDGE_API FunctionSettings surfaceFunction(std::string_view text);

/// A function as text that surfaceFunction() takes: what differs from the defaults.
/// @throws Error  (Kind::Usage) if no row has its name, or its row has another number of options
[[nodiscard]] INKEDGE_API std::string text(const FunctionSettings&);

/// The threshold T in force.
[[nodiscard]] INKEDGE_API float threshold(const FunctionSettings&);

/// Differences of the function's values are taken modulo this; 0: as they are.
[[nodiscard]] INKEDGE_API double wrapPeriod(const FunctionSettings&);

}  // namespace inkedge
