// The library's calls from C: the same results as from C++, and no call that can bring a program down.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <inkedge/inkedge.h>

#include "base/temporary_folder.h"
#include "c/inkedge.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* gear = INKEDGE_SOURCE_DIR "/assets/gear.glb";

template <class Handle, void (*release)(Handle*)>
struct Owned {
    Handle* handle = nullptr;
    Owned() = default;
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() { release(handle); }
    operator Handle*() const { return handle; }
    Handle** operator&() { return &handle; }  // as C hands out
};
using OwnSettings = Owned<inkedge_settings, inkedge_settings_free>;
using OwnScene = Owned<inkedge_scene, inkedge_scene_free>;
using OwnCamera = Owned<inkedge_camera, inkedge_camera_free>;
using OwnRenderer = Owned<inkedge_renderer, inkedge_renderer_free>;
using OwnMaps = Owned<inkedge_maps, inkedge_maps_free>;
using OwnLines = Owned<inkedge_lines, inkedge_lines_free>;

#define EXPECT_OK(call) EXPECT_EQ(call, INKEDGE_OK) << inkedge_message()
#define ASSERT_OK(call) ASSERT_EQ(call, INKEDGE_OK) << inkedge_message()

class CApi : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_OK(inkedge_settings_create(&settings_));
        for (const auto& [name, text] :
             {std::pair{"size", "96x64"}, {"maps", "depth,types,ids,normal,edges"}, {"azimuth", "40"}})
            ASSERT_OK(inkedge_set(settings_, name, text));
        ASSERT_OK(inkedge_scene_load(gear, settings_, &scene_));
        ASSERT_OK(inkedge_renderer_create(settings_, &renderer_));

        for (const auto& [name, text] :
             {std::pair{"size", "96x64"}, {"maps", "depth,types,ids,normal,edges"}, {"azimuth", "40"}})
            inkedge::set(sameSettings_, name, text, "test");
    }

    // What C++ makes of the same settings.
    inkedge::Maps fromCpp() {
        const inkedge::Scene scene = inkedge::loadScene(gear, inkedge::loadSettings(sameSettings_, {}));
        const inkedge::View view{.name = {}, .camera = sameSettings_.camera};
        const inkedge::FramedView framed = inkedge::frameViews(scene, {&view, 1}, sameSettings_).front();
        inkedge::Renderer renderer;
        inkedge::Settings settings = sameSettings_;
        settings.picture = framed.picture;
        return renderer.render(scene, framed.camera, settings);
    }

    OwnSettings settings_;
    OwnScene scene_;
    OwnRenderer renderer_;
    inkedge::Settings sameSettings_;
};

template <class Sample>
std::vector<Sample> samplesOf(const inkedge_buffer& buffer) {
    std::vector<Sample> samples;
    for (int y = 0; y < buffer.height; ++y) {
        for (int x = 0; x < buffer.width; ++x) {
            const auto* const pixel =
                static_cast<const std::byte*>(buffer.data) + y * buffer.row_stride + x * buffer.pixel_stride;
            for (int k = 0; k < buffer.channels; ++k) {
                Sample sample;
                std::memcpy(&sample, pixel + static_cast<std::size_t>(k) * sizeof(Sample), sizeof(Sample));
                samples.push_back(sample);
            }
        }
    }
    return samples;
}

template <class Sample>
void expectSame(inkedge_maps* maps, const char* name, inkedge_type type, const inkedge::Image<Sample>& image) {
    inkedge_buffer buffer{};
    ASSERT_OK(inkedge_maps_get(maps, name, &buffer)) << name;
    EXPECT_EQ(buffer.type, type) << name;
    EXPECT_EQ(buffer.width, image.size().width) << name;
    EXPECT_EQ(buffer.height, image.size().height) << name;
    EXPECT_EQ(buffer.channels, image.channels()) << name;
    EXPECT_TRUE(std::ranges::equal(samplesOf<Sample>(buffer), image.pixels())) << name;
}

TEST_F(CApi, DrawsTheMapsThatCppDraws) {
    OwnMaps maps;
    ASSERT_OK(inkedge_render(renderer_, scene_, nullptr, settings_, &maps));
    const inkedge::Maps same = fromCpp();
    expectSame(maps, "picture", INKEDGE_UINT8, same.picture);
    expectSame(maps, "depth", INKEDGE_FLOAT32, same.depth);
    expectSame(maps, "normal", INKEDGE_FLOAT32, same.normal);
    expectSame(maps, "types", INKEDGE_UINT16, same.types);
    expectSame(maps, "ids", INKEDGE_UINT32, same.ids);
    expectSame(maps, "edges", INKEDGE_UINT8, same.edges);
    EXPECT_GT(std::ranges::count_if(same.types.pixels(), [](std::uint16_t bits) { return bits != 0; }), 100);

    inkedge_buffer buffer{};
    EXPECT_EQ(inkedge_maps_get(maps, "shade", &buffer), INKEDGE_USAGE);
    EXPECT_THAT(inkedge_message(), HasSubstr("found 'shade'"));

    const TemporaryFolder folder;
    EXPECT_OK(inkedge_maps_write(maps, (folder / "a.npz").c_str()));
    EXPECT_TRUE(std::filesystem::exists(folder / "a.npz"));
    EXPECT_EQ(inkedge_maps_write(maps, (folder / "none/a.png").c_str()), INKEDGE_OUTPUT);
    const char* json = nullptr;
    EXPECT_OK(inkedge_maps_metadata(maps, scene_, settings_, &json));
    EXPECT_THAT(json, AllOf(StartsWith("{"), HasSubstr("world_to_camera")));
}

TEST_F(CApi, FindsTheLinesThatCppFinds) {
    OwnLines lines;
    ASSERT_OK(inkedge_find_lines(renderer_, scene_, nullptr, settings_, &lines));
    const inkedge::Scene scene = inkedge::loadScene(gear, inkedge::loadSettings(sameSettings_, {}));
    inkedge::Renderer renderer{{}, inkedge::ContextTime::WhenNeeded};
    const inkedge::Lines same = renderer.lines(
        scene, inkedge::frameCamera(scene, sameSettings_.camera, sameSettings_.picture.size), sameSettings_);
    ASSERT_EQ(inkedge_lines_count(lines), same.lines.size());
    ASSERT_FALSE(same.lines.empty());
    for (std::size_t i = 0; i < same.lines.size(); ++i) {
        inkedge_line line{};
        ASSERT_OK(inkedge_lines_get(lines, i, &line));
        const inkedge::Line& expected = same.lines[i];
        EXPECT_EQ(line.type, inkedge::name(expected.type));
        EXPECT_EQ(line.visible != 0, expected.visible);
        EXPECT_EQ(line.object, expected.object);
        ASSERT_EQ(line.points, expected.points.size());
        for (std::size_t p = 0; p < line.points; ++p) {
            const auto at = [&](const double* first) {
                return reinterpret_cast<const double*>(reinterpret_cast<const std::byte*>(first) + p * line.stride);
            };
            EXPECT_EQ(at(line.pixels)[1], expected.points[p].pixel.y);
            EXPECT_EQ(at(line.positions)[2], expected.points[p].position.z);
            EXPECT_EQ(at(line.strengths)[0], expected.points[p].strength);
        }
    }
    inkedge_line line{};
    EXPECT_EQ(inkedge_lines_get(lines, same.lines.size(), &line), INKEDGE_USAGE);
    const TemporaryFolder folder;
    EXPECT_OK(inkedge_lines_write(lines, settings_, (folder / "a.svg").c_str()));
    EXPECT_TRUE(std::filesystem::exists(folder / "a.svg"));
}

TEST_F(CApi, TakesAModelAsArrays) {
    const std::array<double, 12> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::array<std::uint16_t, 12> triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const std::array<float, 32> transforms{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                                           1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const char* const names[]{"left", "right"};
    inkedge_mesh mesh{};
    mesh.name = "tetrahedron";
    mesh.positions = {corners.data(), INKEDGE_FLOAT64, 4, 3, 0, 0};
    mesh.indices = {triangles.data(), INKEDGE_UINT16, 4, 3, 0, 0};
    mesh.transforms = {transforms.data(), INKEDGE_FLOAT32, 2, 16, 0, 0};
    mesh.names = names;
    OwnScene scene;
    ASSERT_OK(inkedge_scene_make(&mesh, 1, nullptr, &scene));
    EXPECT_EQ(inkedge_scene_triangles(scene), 8U);
    std::array<double, 6> box{};
    inkedge_scene_box(scene, box.data());
    EXPECT_THAT(box, testing::ElementsAre(0, 0, 0, 6, 1, 1));
    OwnMaps maps;
    ASSERT_OK(inkedge_render(renderer_, scene, nullptr, settings_, &maps));
    const char* json = nullptr;
    ASSERT_OK(inkedge_maps_metadata(maps, scene, settings_, &json));
    EXPECT_THAT(json, AllOf(HasSubstr("left"), HasSubstr("right")));

    mesh.positions.columns = 2;
    OwnScene none;
    EXPECT_EQ(inkedge_scene_make(&mesh, 1, nullptr, &none), INKEDGE_USAGE);
    EXPECT_EQ(none.handle, nullptr);
    EXPECT_THAT(inkedge_message(), HasSubstr("positions"));
}

TEST_F(CApi, CamerasGiveAndTakeTheirMatrices) {
    OwnCamera framed;
    ASSERT_OK(inkedge_camera_frame(scene_, settings_, &framed));
    std::array<double, 16> view{};
    std::array<double, 16> projection{};
    inkedge_camera_view(framed, view.data());
    inkedge_camera_projection(framed, scene_, 96, 64, projection.data());
    OwnCamera again;
    ASSERT_OK(inkedge_camera_from_matrices(view.data(), projection.data(), 96, 64, &again));
    OwnMaps maps;
    OwnMaps same;
    ASSERT_OK(inkedge_render(renderer_, scene_, framed, settings_, &maps));
    ASSERT_OK(inkedge_render(renderer_, scene_, again, settings_, &same));
    inkedge_buffer a{};
    inkedge_buffer b{};
    ASSERT_OK(inkedge_maps_get(maps, "ids", &a));
    ASSERT_OK(inkedge_maps_get(same, "ids", &b));
    EXPECT_TRUE(samplesOf<std::uint32_t>(a) == samplesOf<std::uint32_t>(b));

    std::array<double, 9> k{};
    std::array<double, 16> worldToCamera{};
    inkedge_camera_intrinsics(framed, 96, 64, k.data());
    inkedge_camera_world_to_camera(framed, worldToCamera.data());
    EXPECT_NEAR(k[2], 47.5, 1e-9);
    EXPECT_NEAR(k[5], 31.5, 1e-9);
    EXPECT_EQ(k[8], 1.0);
    // OpenCV's camera space is view space with y and z the other way round.
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(worldToCamera[i], i < 4 ? view[i] : -view[i]) << i;

    const std::array<double, 16> sheared{1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    OwnCamera none;
    EXPECT_EQ(inkedge_camera_from_intrinsics(k.data(), sheared.data(), 1, 96, 64, &none), INKEDGE_USAGE);
    EXPECT_EQ(none.handle, nullptr);
}

TEST_F(CApi, SaysWhatIsWrong) {
    EXPECT_EQ(inkedge_set(settings_, "line-widht", "2"), INKEDGE_USAGE);
    EXPECT_THAT(inkedge_message(), HasSubstr("is it line-width?"));
    EXPECT_EQ(inkedge_set(settings_, "line-width", "wide"), INKEDGE_USAGE);
    EXPECT_THAT(inkedge_message(), AllOf(StartsWith("line-width: expected"), HasSubstr("found 'wide'")));
    EXPECT_OK(inkedge_set(settings_, "line-width", "2.5"));
    EXPECT_STREQ(inkedge_get(settings_, "line-width"), "2.5");
    EXPECT_EQ(inkedge_get(settings_, "line-widht"), nullptr);
    EXPECT_EQ(inkedge_set_preset(settings_, "papr"), INKEDGE_USAGE);
    EXPECT_OK(inkedge_set_preset(settings_, "paper"));
    EXPECT_EQ(inkedge_read_config(settings_, "/nowhere.conf"), INKEDGE_INPUT);
    OwnScene scene;
    EXPECT_EQ(inkedge_scene_load("/nowhere.glb", nullptr, &scene), INKEDGE_INPUT);
    EXPECT_THAT(inkedge_message(), HasSubstr("/nowhere.glb: expected a file, found none"));
    std::thread{[] { EXPECT_STREQ(inkedge_message(), ""); }}.join();  // each thread has its own
    EXPECT_EQ(inkedge_scene_read("glTF", 4, "a.glb", nullptr, &scene), INKEDGE_INPUT);
    EXPECT_STREQ(inkedge_version(), std::string{inkedge::version()}.c_str());
}

TEST_F(CApi, TakesNullForWhatIsMissing) {
    OwnMaps maps;
    OwnScene scene;
    EXPECT_EQ(inkedge_settings_create(nullptr), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_set(nullptr, "a", "b"), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_set(settings_, nullptr, "b"), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_set(settings_, "size", nullptr), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_get(nullptr, "size"), nullptr);
    EXPECT_EQ(inkedge_scene_load(nullptr, nullptr, &scene), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_scene_read(nullptr, 4, "a.glb", nullptr, &scene), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_scene_make(nullptr, 1, nullptr, &scene), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_render(nullptr, scene_, nullptr, nullptr, &maps), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_render(renderer_, nullptr, nullptr, nullptr, &maps), INKEDGE_USAGE);
    EXPECT_EQ(inkedge_render(renderer_, scene_, nullptr, nullptr, nullptr), INKEDGE_USAGE);
    EXPECT_THAT(inkedge_message(), HasSubstr("found NULL"));
    inkedge_buffer buffer{};
    EXPECT_EQ(inkedge_maps_get(nullptr, "depth", &buffer), INKEDGE_USAGE);
    for (const auto release : {+[] { inkedge_scene_free(nullptr); }, +[] { inkedge_maps_free(nullptr); },
                               +[] { inkedge_lines_free(nullptr); }, +[] { inkedge_camera_free(nullptr); },
                               +[] { inkedge_renderer_free(nullptr); }, +[] { inkedge_settings_free(nullptr); }})
        release();
}

TEST_F(CApi, StopsFromAnotherThread) {
    ASSERT_OK(inkedge_set(settings_, "size", "4096x4096"));
    ASSERT_OK(inkedge_set(settings_, "tile-size", "256"));  // looked at between tiles
    std::atomic<bool> ended = false;
    std::thread stopper{[&] {
        while (!ended) inkedge_renderer_stop(renderer_);
    }};
    OwnMaps maps;
    EXPECT_EQ(inkedge_render(renderer_, scene_, nullptr, settings_, &maps), INKEDGE_STOPPED);
    ended = true;
    stopper.join();
    EXPECT_EQ(maps.handle, nullptr);
    ASSERT_OK(inkedge_set(settings_, "size", "64x64"));
    EXPECT_OK(inkedge_render(renderer_, scene_, nullptr, settings_, &maps));
}

}  // namespace
