#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/export.h>
#include <inkedge/lines.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge {

/// On which side of the front view another one lies: ISO 5456-2.
enum class Projection {
    First,  ///< beyond the part: the view from the right lies on the left, the one from above below
    Third,  ///< on the side that it is seen from
};

/// One of the pages of ISO 216, which ISO 5457 makes sheets of.
struct SheetPage {
    int series = 3;  ///< 0 to 4: A0 to A4
    bool landscape = true;
    friend bool operator==(const SheetPage&, const SheetPage&) = default;
};

/// What a drawing sheet is made of.
struct SheetSettings {
    Projection projection = Projection::First;
    /// Each once. Those of six sides are aligned with each other; the others lie where room is left.
    std::vector<NamedView> views{NamedView::Front, NamedView::Top, NamedView::Right, NamedView::Iso};
    SheetPage page;
    std::optional<double> scale;               ///< paper : model; none: the largest of ISO 5455 that fits
    HiddenLines hidden = HiddenLines::Dashed;  ///< of the views of six sides; the others have none
    std::string title;                         ///< UTF-8; empty: the model's name
    std::string date;                          ///< as it is to be read; empty: none
};

/// One of the command's options for a sheet.
struct SheetOption {
    std::string_view name;       ///< without its dashes: "projection"
    std::string_view values;     ///< what it takes: "first|third"
    std::string_view help;       ///< one line
    std::string_view byDefault;  ///< in words; empty: none
    /// @throws Error  (Kind::Usage) if the text has no value: what was expected and what was found
    void (*set)(SheetSettings&, std::string_view text);
};

/// All of them, in the order of the manual.
[[nodiscard]] INKEDGE_API std::span<const SheetOption> sheetOptions() noexcept;

/// A view on a sheet.
struct SheetView {
    NamedView view;
    glm::dvec2 middle;  ///< of what is drawn: mm from the page's top left corner, y down
    glm::dvec2 size;    ///< of what is drawn, mm
    Lines lines;        ///< in pixels of a tenth of a millimetre, the middle in the middle of Lines::size
};

/// A drawing sheet: several views of a model at one scale on one page.
struct Sheet {
    SheetSettings settings;
    Settings drawn;      ///< the lines and pens of the views
    double dpi = 150.0;  ///< of a picture of it: PictureSettings::dpi, if it is given
    double scale = 1.0;  ///< paper : model
    std::string model;   ///< the file's name
    std::vector<SheetView> views;
    std::vector<std::string> warnings;  ///< one line each
};

/// Draws a sheet. Views that are opposite or beside each other share an axis, and are aligned along it. Visible lines
/// are wide, 0.5 mm up to A2 and 0.7 mm over it, and hidden ones, lines of form and others that are fine by default
/// half of it: ISO 128-20. What settings say of pens, lines and up holds; their cameras, sizes, styles and shades do
/// not.
/// @throws Error  (Kind::Usage) if the scale does not fit on the page, or as Renderer::lines()
[[nodiscard]] INKEDGE_API Sheet drawSheet(Renderer&, const Scene&, const Settings&, const SheetSettings&,
                                          const std::stop_token& = {});

/// Writes a sheet as .svg, .pdf, .dxf or .png, by the extension: the views, a frame with centring marks and fields (ISO
/// 5457) and a title block (ISO 7200), all in millimetres of paper. The same sheet gives the same bytes.
/// @throws Error  (Kind::Usage) if the extension is none of these, or the picture would have over
///                PictureSettings::maxSide pixels along a side; (Kind::Output) if the file cannot be written
INKEDGE_API void writeSheet(const Sheet&, const std::filesystem::path&);

/// Checks a name before the work.
/// @throws Error  (Kind::Usage) if writeSheet() does not take it
INKEDGE_API void expectSheetFile(const std::filesystem::path&);

}  // namespace inkedge
