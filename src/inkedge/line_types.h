#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string_view>

#include <inkedge/export.h>

namespace inkedge {

/// What a line is: one bit of LineTypes and of Maps::types, which has 16. A pixel of a line may have several types at
/// once. The line is then drawn with the pen of the first type that has a pen of its own (PictureSettings::pens).
enum class LineType : std::uint32_t {
    Outline = 1,         ///< the model against the background
    Occlusion = 2,       ///< a surface in front of another
    Boundary = 4,        ///< where a surface ends: an open mesh's border
    Crease = 8,          ///< two faces that meet at more than the crease angle
    Intersection = 16,   ///< surfaces that run into each other, and borders of surfaces that touch
    Object = 32,         ///< between two nodes of the scene
    Isoparametric = 64,  ///< where a texture coordinate passes a step; only of lines from object space
    /// Lines that the file has besides triangles, and edges that it marks, except those drawn as one of the first three
    /// types. Maps::types has none of them.
    Marked = 128,
    // Lines of form: where a smooth surface bends. They are found on the mesh alone.
    Suggestive = 256,  ///< nearly contours, which they would become in views near this one; DeCarlo et al. 2003
    Ridge = 512,       ///< where a surface bulges the sharpest across the line; Ohtake et al. 2004
    Valley = 1024,     ///< where a surface is hollowed out the sharpest across the line; Ohtake et al. 2004
    Apparent = 2048,   ///< where a surface, as the eye sees it, bends the sharpest; Judd et al. 2007
    /// Where one face of a CAD file goes on into the next without a bend: EdgeKind::Tangent.
    Tangent = 4096,
};
inline constexpr int lineTypeCount = 13;
static_assert(lineTypeCount <= 16, "Maps::types has 16 bits");

/// "outline", "occlusion", "boundary", "crease", "intersection", "object", "isoparametric", "marked", "suggestive",
/// "ridge", "valley", "apparent", "tangent"; empty for a value that is none of them.
[[nodiscard]] INKEDGE_API std::string_view name(LineType) noexcept;

/// The number of a type's bit: 0 for LineType::Outline. The type must be one of the enumerators.
[[nodiscard]] constexpr int bitIndex(LineType type) noexcept {
    return std::countr_zero(static_cast<std::uint32_t>(type));
}

/// Pixels of the lines of each type, by bitIndex().
using LineLengths = std::array<double, lineTypeCount>;

/// A set of line types: 32 bits, each as LineType numbers them. Iteration goes from the lowest bit to the highest.
class LineTypes {
public:
    /// Goes from one bit to the next.
    class Iterator {
    public:
        using value_type = LineType;
        using difference_type = std::ptrdiff_t;
        constexpr Iterator() noexcept = default;
        constexpr explicit Iterator(std::uint32_t rest) noexcept : rest_{rest} {}
        constexpr LineType operator*() const noexcept { return static_cast<LineType>(rest_ & (~rest_ + 1U)); }
        constexpr Iterator& operator++() noexcept {
            rest_ &= rest_ - 1U;
            return *this;
        }
        constexpr Iterator operator++(int) noexcept {
            const Iterator before = *this;
            ++*this;
            return before;
        }
        friend constexpr bool operator==(Iterator, Iterator) noexcept = default;

    private:
        std::uint32_t rest_ = 0;  // the bits that are still to come
    };

    constexpr LineTypes() noexcept = default;
    constexpr LineTypes(LineType type) noexcept : bits_{static_cast<std::uint32_t>(type)} {}
    constexpr LineTypes(std::initializer_list<LineType> types) noexcept {
        for (const LineType type : types) *this |= type;
    }
    /// @param bits  any: also those that no type has yet
    [[nodiscard]] static constexpr LineTypes fromBits(std::uint32_t bits) noexcept {
        LineTypes types;
        types.bits_ = bits;
        return types;
    }

    [[nodiscard]] constexpr std::uint32_t bits() const noexcept { return bits_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return bits_ == 0; }
    [[nodiscard]] constexpr int size() const noexcept { return std::popcount(bits_); }
    [[nodiscard]] constexpr bool contains(LineType type) const noexcept { return !(*this & type).empty(); }

    /// The type of the lowest bit. Of an empty set it is no type: the value 0.
    [[nodiscard]] constexpr LineType first() const noexcept { return *begin(); }
    [[nodiscard]] constexpr Iterator begin() const noexcept { return Iterator{bits_}; }
    [[nodiscard]] constexpr Iterator end() const noexcept { return Iterator{}; }

    constexpr LineTypes& operator|=(LineTypes other) noexcept {
        bits_ |= other.bits_;
        return *this;
    }
    friend constexpr LineTypes operator|(LineTypes a, LineTypes b) noexcept { return fromBits(a.bits_ | b.bits_); }
    friend constexpr LineTypes operator&(LineTypes a, LineTypes b) noexcept { return fromBits(a.bits_ & b.bits_); }
    /// The types of the first set that the second set does not hold.
    friend constexpr LineTypes operator-(LineTypes a, LineTypes b) noexcept { return fromBits(a.bits_ & ~b.bits_); }
    friend constexpr bool operator==(LineTypes, LineTypes) noexcept = default;

private:
    std::uint32_t bits_ = 0;
};

[[nodiscard]] constexpr LineTypes operator|(LineType a, LineType b) noexcept { return LineTypes{a} | LineTypes{b}; }

/// Every type there is.
inline constexpr LineTypes allLineTypes = LineTypes::fromBits((1U << lineTypeCount) - 1U);
/// The types of lines of form: drawn if they are asked for.
inline constexpr LineTypes formLineTypes =
    LineType::Suggestive | LineType::Ridge | LineTypes{LineType::Valley} | LineType::Apparent;
/// What is drawn if nothing else is asked for.
inline constexpr LineTypes standardLineTypes = allLineTypes - formLineTypes;

}  // namespace inkedge
