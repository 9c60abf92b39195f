#include "job/files_apart.h"

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/file_key.h"

namespace inkedge::job {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& output, std::string_view what, const fs::path& input) {
    throw Error{Error::Kind::Usage,
                fmt::format("{}: expected an output other than what is read, found {} {}; choose another name",
                            output.string(), what, input.string())};
}

}  // namespace

void FilesApart::addInput(const fs::path& file, std::string_view what) {
    inputs_.try_emplace(base::fileKey(file), Input{file, std::string{what}});
}

void FilesApart::addOutput(const fs::path& file, const Owner& owner) {
    const std::string key = base::fileKey(file);
    if (const auto input = inputs_.find(key); input != inputs_.end())
        refuse(file, input->second.what, input->second.file);
    const auto [known, isNew] = outputs_.try_emplace(key, Output{file, owner});
    if (isNew) return;
    const Output& other = known->second;
    if (other.owner.number != owner.number)
        throw Error{Error::Kind::Usage,
                    fmt::format("{}: expected a file for {} alone, found it asked for by {} too{}; put {{model}} and "
                                "{{view}} in its name",
                                file.string(), other.owner.view, owner.view,
                                other.file == file ? "" : fmt::format(", as {}", other.file.string()))};
    throw Error{Error::Kind::Usage,
                fmt::format("{}: expected a file for {} {} alone, found it asked for by {} too; choose another name",
                            file.string(), other.owner.flag, other.file.string(), owner.flag)};
}

void FilesApart::expectNoOutput(const fs::path& input, std::string_view what) const {
    const auto output = outputs_.find(base::fileKey(input));
    if (output != outputs_.end()) refuse(output->second.file, what, input);
}

}  // namespace inkedge::job
