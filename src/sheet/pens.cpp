#include "sheet/pens.h"

#include "settings/lengths.h"
#include "settings/pens.h"
#include "sheet/ink.h"
#include "sheet/page.h"

namespace inkedge::sheet {

PictureSettings sheetPens(PictureSettings picture, const SheetPage& page) {
    const PictureSettings defaults;
    const auto usual = settings::pens(defaults);
    const double wide = picture.lineWidth == defaults.lineWidth ? wideLine(page) : picture.lineWidth.value;
    picture.dpi = pixelsPerMillimetre * settings::millimetresPerInch;
    if (picture.lineWidth == defaults.lineWidth) picture.lineWidth = {wide, true};
    const PictureLength narrow{0.5 * wide, picture.lineWidth.millimetres};
    for (std::size_t i = 0; i < picture.pens.size(); ++i)
        if (!picture.pens[i].width && usual[i].width < usual[0].width) picture.pens[i].width = narrow;
    HiddenPenSettings& hidden = picture.hiddenPen;
    if (!hidden.width) hidden.width = narrow;
    const auto times = [&](double widths) {
        return PictureLength{widths * hidden.width->value, hidden.width->millimetres};
    };
    if (!hidden.dash) hidden.dash = DashPattern{times(11.0), times(4.0)};  // round ends are half a width long
    return picture;
}

}  // namespace inkedge::sheet
