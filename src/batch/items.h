#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "batch/find_models.h"
#include "batch/item.h"
#include "batch/portion.h"

namespace inkedge::batch {

/// The items of a batch, one after the other: never are all of them held.
class Items {
public:
    /// @param input   a folder, a file with an item a line, or "-" for stdin
    /// @param output  the batch's folder, where no model is looked for
    /// @param portion the items that next() gives; a line that is no item is one portion's, too
    /// @throws Error  (Kind::Input) if it is none of these, or cannot be read; (Kind::Usage) if it is a model
    Items(const std::filesystem::path& input, const std::filesystem::path& output, Portion portion = {});
    ~Items();

    /// The next item, its number set; none: that was the last.
    /// @throws Error  (Kind::Input) if a line is no item: the message names it; the next call goes on after it
    [[nodiscard]] std::optional<Item> next();

private:
    [[nodiscard]] std::optional<Item> nextFound();
    [[nodiscard]] std::optional<Item> nextLine();
    [[nodiscard]] bool readLine();

    std::filesystem::path input_;
    Portion portion_;
    std::optional<FindModels> models_;
    std::ifstream file_;
    std::istream* stream_ = nullptr;
    std::string line_;
    std::uint64_t lineNumber_ = 0;
    std::uint64_t items_ = 0;
};

}  // namespace inkedge::batch
