#include "batch/gallery.h"

#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/message.h"
#include "base/staged_files.h"
#include "batch/old_shards.h"
#include "batch/results.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

// A line of the results for a script in HTML: no text of it ends the script.
std::string scriptText(std::string_view line) {
    std::string text;
    for (const char c : line) c == '<' ? text += "\\u003c" : text += c;
    return text;
}

void expectFolders(const fs::path& output) {
    std::error_code ignored;
    if (resultsFiles(output).empty())
        base::refuse(
            fmt::format("{}: expected what inkedge batch wrote, found none", resultsFile(output, {}).string()));
    if (!shardsIn(output).empty())
        base::refuse(
            fmt::format("{}: expected a batch that wrote folders, found shards, whose pictures no page can "
                        "show; draw it without --shards",
                        output.string()));
}

}  // namespace

std::uint64_t writeGallery(const fs::path& output) {
    expectFolders(output);
    constexpr std::string_view mark = "{results}";
    const std::string_view page = galleryPage();
    const std::size_t at = page.find(mark);
    std::string text{page.substr(0, at)};
    base::StagedFiles files;
    files.add(output / "gallery.html", {});
    const auto flush = [&](std::size_t enough) {
        if (text.size() < enough) return;
        files.extend({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        text.clear();
    };
    std::uint64_t items = 0;
    readChosenResults(output, [&](std::string_view line) {
        if (items++ > 0) text += ",\n";
        text += scriptText(line);
        flush(std::size_t{1} << 20U);
    });
    text += page.substr(at + mark.size());
    flush(0);
    files.commit();
    return items;
}

}  // namespace inkedge::batch
