#include <inkedge/setting_table.h>

namespace inkedge {

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"paper", "the classic detector with the 5x5 kernels", {{"detector", "classic"}, {"kernel", "farid"}}},
        {"blueprint", "white lines on blue", {{"line-color", "#ffffff"}, {"background", "#1f4e8c"}}},
        {"overlay", "black lines on nothing", {{"line-color", "#000000"}, {"background", "none"}}},
    };
    return all;
}

}  // namespace inkedge
