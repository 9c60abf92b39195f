// Feeds a fuzz target every file of a folder, without a fuzzer: what was found once stays mended.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <vector>

#include "fuzz/promise.h"

namespace {

namespace fs = std::filesystem;

constexpr double longest = 5.0;  // seconds, for one file

double secondsFor(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    const std::vector<char> bytes{std::istreambuf_iterator<char>{stream}, {}};
    const auto begin = std::chrono::steady_clock::now();
    static_cast<void>(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main() try {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{INKEDGE_FINDINGS}) files.push_back(entry.path());
    std::ranges::sort(files);
    bool late = false;
    for (const fs::path& file : files) {
        std::printf("%s: ", file.filename().c_str());
        std::fflush(stdout);
        const double seconds = secondsFor(file);
        std::printf("%.2f s\n", seconds);
        if (seconds <= longest) continue;
        std::fprintf(stderr, "%s: expected at most %.0f s, found %.2f\n", file.c_str(), longest, seconds);
        late = true;
    }
    if (files.empty()) std::fprintf(stderr, "%s: expected files, found none\n", INKEDGE_FINDINGS);
    return late || files.empty() ? 1 : 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "expected nothing thrown but an Error, found: %s\n", error.what());
    return 1;
}
