// draw_views MODEL VIEWS SIDE: draws views around a model with the library, as tools/bench_python does with the Python
// module. Prints seconds of the clock and of all threads, and the peak of memory in kilobytes.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <inkedge/inkedge.h>

namespace {

double cpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

long peakKilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const int views = std::atoi(argv[2]);
    inkedge::Settings settings;
    settings.picture.size = {std::atoi(argv[3]), std::atoi(argv[3])};
    settings.maps = {inkedge::Map::Types, inkedge::Map::Depth, inkedge::Map::Normal, inkedge::Map::Ids};
    const inkedge::Scene scene = inkedge::loadScene(argv[1], inkedge::loadSettings(settings));
    inkedge::Renderer renderer;
    const auto draw = [&](int view) {
        inkedge::CameraSettings wanted;
        wanted.azimuthAngle = 360.0 * view / views;
        const inkedge::Camera camera = inkedge::frameCamera(scene, wanted, settings.picture.size);
        return renderer.render(scene, camera, settings).ids.at(0, 0, 2);
    };
    unsigned int sum = draw(0);  // makes programs and the upload
    const auto start = std::chrono::steady_clock::now();
    const double cpuStart = cpuSeconds();
    for (int i = 0; i < views; ++i) sum += draw(i);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    std::printf("%.6f %.6f %ld\n", wall.count(), cpuSeconds() - cpuStart, peakKilobytes());
    return sum > 1'000'000 ? 1 : 0;  // so that the compiler draws them
}
