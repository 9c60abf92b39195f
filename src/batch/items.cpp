#include "batch/items.h"

#include <algorithm>
#include <iostream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/load_scene.h>

#include "base/file_extension.h"
#include "base/message.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxLine = std::size_t{1} << 16U;  // bytes: two of them fit into a socket
constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

void expectList(const fs::path& input) {
    std::error_code ignored;
    if (!fs::exists(input, ignored))
        base::refuse(
            fmt::format("{}: expected a folder of models or a file with an item a line, found none", input.string()));
    const std::string extension = base::lowerCaseExtension(input);
    for (const ModelFormat& format : readableFormats())
        if (std::ranges::find(format.extensions, extension) != format.extensions.end())
            throw Error{Error::Kind::Usage,
                        fmt::format("{}: expected a folder of models or a file with an item a line, found a model; "
                                    "inkedge render draws it",
                                    input.string())};
}

}  // namespace

Items::Items(const fs::path& input, const fs::path& output, Portion portion) : input_{input}, portion_{portion} {
    std::error_code ignored;
    if (input == "-") {
        stream_ = &std::cin;
    } else if (fs::is_directory(input, ignored)) {
        models_.emplace(input, output);
    } else {
        expectList(input);
        file_.open(input, std::ios::binary);
        if (!file_) base::refuse(fmt::format("{}: expected a readable file, found one that is not", input.string()));
        stream_ = &file_;
    }
}

Items::~Items() = default;

std::optional<Item> Items::next() {
    while (true) {
        try {
            std::optional<Item> item = models_ ? nextFound() : nextLine();
            if (item && !holds(portion_, item->id)) continue;
            if (item) item->number = items_++;
            return item;
        } catch (const Error& error) {
            if (holds(portion_, error.what())) throw;
        }
    }
}

std::optional<Item> Items::nextFound() {
    const std::optional<fs::path> model = models_->next();
    if (!model) return {};
    return base::within(model->string(), [&] { return itemOf(*model, model->lexically_relative(input_)); });
}

// Into line_, without its end; of a line that is too long only so much that it can be seen.
bool Items::readLine() {
    line_.clear();
    std::streambuf& bytes = *stream_->rdbuf();
    std::size_t size = 0;
    for (int c = bytes.sbumpc(); c != std::char_traits<char>::eof(); c = bytes.sbumpc()) {
        if (c == '\n') {
            ++lineNumber_;
            return true;
        }
        if (++size <= maxLine + 1) line_ += static_cast<char>(c);
    }
    if (size == 0) return false;
    ++lineNumber_;
    return true;
}

std::optional<Item> Items::nextLine() {
    while (readLine()) {
        std::string_view line = line_;
        if (lineNumber_ == 1 && line.starts_with(byteOrderMark)) line.remove_prefix(byteOrderMark.size());
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
        return base::within(fmt::format("{}:{}", input_.string(), lineNumber_), [&] {
            if (line_.size() > maxLine) base::refuse(fmt::format("expected at most {} bytes, found more", maxLine));
            return itemFrom(line);
        });
    }
    return {};
}

}  // namespace inkedge::batch
