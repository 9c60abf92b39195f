#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <inkedge/job.h>

namespace inkedge::job {

/// The files that jobs read and write, by what they are rather than how they are called: no output is an input, and no
/// two are one file.
class FilesApart {
public:
    /// @param what  for messages: "the model"
    void addInput(const std::filesystem::path&, std::string_view what);

    /// Whose output a file is.
    struct Owner {
        std::size_t number;     ///< of the view, among those of all jobs
        std::string view;       ///< for messages
        std::string_view flag;  ///< what asks for it: "--output"
    };
    /// @throws Error  (Kind::Usage) if it is an input, or an output already; the message has both names
    void addOutput(const std::filesystem::path&, const Owner&);

    /// The same of an input that is known only now.
    /// @throws Error  (Kind::Usage) if it is an output
    void expectNoOutput(const std::filesystem::path& input, std::string_view what) const;

private:
    struct Input {
        std::filesystem::path file;
        std::string what;
    };
    struct Output {
        std::filesystem::path file;
        Owner owner;
    };
    std::map<std::string, Input> inputs_;  // by fileKey()
    std::map<std::string, Output> outputs_;
};

/// What checkJobs() does.
/// @return  the jobs' files
[[nodiscard]] FilesApart checkedFiles(std::span<const Job>);

}  // namespace inkedge::job
