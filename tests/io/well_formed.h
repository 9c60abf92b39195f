#pragma once

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

/// Of the XML that is written here: tags that nest, attributes between double quotes, entities that are closed.
inline void expectWellFormed(const std::string& xml) {
    static const std::regex tag{R"(^<(/?)([A-Za-z]+)((?: [A-Za-z:-]+="[^"<]*")*)(/?)>)"};
    static const std::regex entities{R"(&(?!amp;|lt;|gt;|quot;))"};
    EXPECT_FALSE(std::regex_search(xml, entities));
    const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    ASSERT_EQ(xml.substr(0, head.size()), head);
    std::vector<std::string> open;
    for (std::size_t at = xml.find('<', head.size()); at != std::string::npos; at = xml.find('<', at + 1)) {
        std::smatch match;
        const std::string rest = xml.substr(at, xml.find('>', at) - at + 1);
        ASSERT_TRUE(std::regex_search(rest, match, tag)) << rest.substr(0, 200);
        if (match[1].length() > 0) {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), match[2]);
            open.pop_back();
        } else if (match[4].length() == 0) {
            open.push_back(match[2]);
        }
    }
    EXPECT_TRUE(open.empty()) << open.back();
}
