// Bytes as a configuration file. What it sets can be written down and read again.
#include <inkedge/setting_table.h>

#include "base/temporary_folder.h"
#include "fuzz/promise.h"

namespace {

void expectTextThatReadsBack(const inkedge::Settings& settings) {
    for (const inkedge::SettingDescription& row : inkedge::settingTable()) {
        const std::string text = row.get(settings);
        if (text.empty()) continue;
        inkedge::Settings again;
        inkedge::set(again, row.name, text, row.name);
        inkedge::fuzz::expect(row.get(again) == text, text, row.get(again));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace inkedge::fuzz;
    static const TemporaryFolder folder;
    write(folder / "inkedge.conf", {data, size});
    inkedge::Settings settings;
    mayBeRefused([&] { inkedge::readConfig(settings, folder / "inkedge.conf"); });
    expectTextThatReadsBack(settings);
    return 0;
}
