#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/zip.h"

namespace inkedge::threemf_files {

/// Another file of the archive: its name and what it holds.
using Member = std::pair<std::string, std::string>;

/// A 3MF of a model's XML, and of other files.
inline std::vector<std::uint8_t> archive(const std::string& model, const std::vector<Member>& others = {}) {
    const std::string start = R"(<?xml version="1.0" encoding="UTF-8"?>)";
    const std::string package = "http://schemas.openxmlformats.org/package/2006/";
    io::ZipWriter zip;
    const auto add = [&](const std::string& name, const std::string& text) {
        zip.add(name, {text.begin(), text.end()});
    };
    add("[Content_Types].xml",
        start + "<Types xmlns=\"" + package +
            "content-types\"><Default Extension=\"rels\" "
            "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
            "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>");
    const auto relation = [&](const std::string& target) {
        return start + "<Relationships xmlns=\"" + package + "relationships\"><Relationship Target=\"" + target +
               "\" Id=\"a\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    };
    add("_rels/.rels", relation("/3D/3dmodel.model"));
    add("3D/3dmodel.model", start + model);
    for (const auto& [name, text] : others) add(name, start + text);
    if (!others.empty()) add("3D/_rels/3dmodel.model.rels", relation("/" + others.front().first));
    return std::move(zip).take();
}

/// The root element of a model around others.
inline std::string model(const std::string& inside, const std::string& unit = "millimeter") {
    return "<model unit=\"" + unit +
           "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">" +
           inside + "</model>";
}

/// An object: a cube of side 10 with a corner in the origin.
/// @param attributes   more of the object's
/// @param ofFirst      of the first two triangles, which are its bottom
inline std::string cube(int id, const std::string& attributes = "", const std::string& ofFirst = "") {
    std::string text = "<object id=\"" + std::to_string(id) + "\" type=\"model\" " + attributes + "><mesh><vertices>";
    for (const char* const v : {"0 0 0", "10 0 0", "10 10 0", "0 10 0", "0 0 10", "10 0 10", "10 10 10", "0 10 10"}) {
        const std::string corner{v};
        const std::size_t first = corner.find(' ');
        const std::size_t second = corner.find(' ', first + 1);
        text += "<vertex x=\"" + corner.substr(0, first) + "\" y=\"" + corner.substr(first + 1, second - first - 1) +
                "\" z=\"" + corner.substr(second + 1) + "\"/>";
    }
    text += "</vertices><triangles>";
    const char* const triangles[]{"321", "103", "456", "674", "015", "540", "126", "651", "237", "762", "304", "473"};
    for (std::size_t i = 0; i < std::size(triangles); ++i)
        text += std::string{"<triangle v1=\""} + triangles[i][0] + "\" v2=\"" + triangles[i][1] + "\" v3=\"" +
                triangles[i][2] + "\" " + (i < 2 ? ofFirst : "") + "/>";
    return text + "</triangles></mesh></object>";
}

/// A 3MF of one cube.
inline std::vector<std::uint8_t> oneCube() {
    return archive(
        model("<resources>" + cube(1, "name=\"cube\"") + "</resources><build><item objectid=\"1\"/></build>"));
}

}  // namespace inkedge::threemf_files
