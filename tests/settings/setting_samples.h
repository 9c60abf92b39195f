#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "base/expect_error.h"

namespace inkedge::setting_samples {

inline std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

inline bool isChoice(const SettingDescription& row) { return row.range() == "one of these"; }
inline bool isCount(const SettingDescription& row) { return std::holds_alternative<Count>(row.constraint); }

// Texts that a row must take, in the form in which it gives them back, worked out from what the manual says it takes.
inline std::vector<std::string> samples(const SettingDescription& row) {
    if (isChoice(row)) return split(row.values(), '|');
    if (row.values() == "MAP,...") return {"depth", "edges,depth-edges", "depth,normal,depth-edges,normal-edges,edges"};
    if (row.name == "page-size") return {"210mmx297mm", "12.5mmx40mm"};
    if (row.name == "size") return {"1x1", "320x200", "90mmx60mm", "25.4mm", "1063"};
    if (row.name == "crop") return {"0", "12.5", "2mm"};
    if (row.name == "scale") return {"1:2", "5:1", "1:1", "1:3"};
    if (row.name == "up") return {"+Z", "-X", "1,2,3"};
    if (row.values() == "NAME") return {"arm", "arm/hand;leg *"};
    if (row.values() == "COLOR") return {"#000000", "#12ab9f", "#ffffff"};
    if (row.values() == "COLOR|none") return {"none", "#12ab9f"};
    if (row.values() == "X,Y,Z") return {"1,2,3", "-1.5,0.25,1e-300"};
    if (row.values() == "DEG") return {"12.5", "89.75"};
    if (row.values() == "HEIGHT" || row.values() == "FACTOR" || row.values() == "T") return {"0.25", "2", "1000"};
    if (row.name == "tolerance") return {"0.25", "2.5"};
    if (row.name == "dpi") return {"72", "300.5"};
    if (row.values() == "PX" && row.group == "lines") return {"0", "0.25", "2.5"};
    if (row.values() == "%" || (row.group == "lines" && row.values() == "X")) return {"0.25", "2.5"};
    if (row.group == "style" && row.values() == "X") return {"0.25", "1"};
    if (row.group == "style" && row.values() == "PX") return {"1", "1.5"};
    if (row.group == "style" && row.values() == "N") return {"1", "7"};
    if (row.group == "detector" && (row.values() == "PX" || row.values() == "X")) return {"0.25", "2.5"};
    if (row.values() == "PX") return {"0.5", "2.25", "0.35mm"};
    if (row.values() == "TYPE,...") return {"none", "crease", "outline,object"};
    if (row.values() == "TYPE:width=W,color=C;...") {
        return {"crease:width=1", "outline:width=0.5mm,color=#123456",
                "crease:width=1;hidden:width=0.25mm,color=#808080,dash=3mm:1.5mm", "hidden:dash=4:2"};
    }
    if (row.values() == "NAME|N") return {"Run", "2"};
    if (row.values() == "FILE") return {"charcoal.png", "/brushes/dry one.png"};
    if (row.values() == "SAMPLES") return {"256", "1000"};
    if (row.values() == "SECONDS" && row.group != "limits") return {"0", "2.5"};
    if (row.group == "limits") return {"1", "123456"};
    if (row.range() == "0 to 6") return {"0", "6"};
    if (row.values() == "AZIMUTH,ELEVATION") return {"-35,40", "120,-12.5"};
    if (row.values() == "N|u:N,v:N") return {"8", "u:4,v:12"};
    if (row.name == "function") return {"depth", "height:levels=4;normal:kernel=farid"};
    if (row.values() == "N") return {"0", "7"};
    ADD_FAILURE() << "--" << row.name << " takes " << row.values() << ", for which this test knows no samples";
    return {};
}

inline void expectRefusal(std::string_view name, std::string_view text, const std::string& message) {
    Settings settings;
    expectError(Error::Kind::Usage, testing::StrEq(message), [&] { set(settings, name, text, "--flag"); });
}

inline std::string got(std::string_view name, const Settings& settings) {
    return std::ranges::find(settingTable(), name, &SettingDescription::name)->get(settings);
}

template <class Action>
bool throwsError(Action action) {
    try {
        action();
    } catch (const Error&) {
        return true;
    }
    return false;
}

inline Settings with(std::string_view name, std::string_view text) {
    Settings settings;
    set(settings, name, text, "test");
    return settings;
}

}  // namespace inkedge::setting_samples
