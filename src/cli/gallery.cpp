#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "batch/gallery.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {

void addGallery(CLI::App& app, Action& action) {
    const auto output = std::make_shared<std::filesystem::path>();
    CLI::App* verb = app.add_subcommand("gallery", "Write a page that shows what a batch has drawn.");
    verb->add_option("FOLDER", *output, "that inkedge batch has written; the page is gallery.html in it")->required();
    verb->callback([output, &action] {
        action = [output] {
            const std::uint64_t items = batch::writeGallery(*output);
            print(fmt::format("{}: {} items\n", (*output / "gallery.html").string(), items));
            return 0;
        };
    });
}

}  // namespace inkedge::cli
