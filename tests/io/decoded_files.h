#pragma once

#include <array>
#include <csignal>
#include <cstring>

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <png.h>
#include <sys/resource.h>
#include <glm/ext/matrix_transform.hpp>

#include <inkedge/write.h>

namespace inkedge::decoded_files {

using namespace inkedge;
namespace fs = std::filesystem;

inline constexpr std::array allMaps{Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges, Map::Edges};

struct DecodedPng {
    int bitDepth = 0;
    int colorType = 0;
    Image<std::uint8_t> image;
};

inline DecodedPng decodePng(const std::string& bytes) {
    DecodedPng result;
    if (bytes.size() < 26) throw std::runtime_error{"no PNG"};
    result.bitDepth = bytes[24];  // IHDR begins at byte 16: width, height, bit depth, colour type
    result.colorType = bytes[25];
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
        throw std::runtime_error{header.message};
    }
    header.format &= ~static_cast<png_uint_32>(PNG_FORMAT_FLAG_COLORMAP);
    result.image = Image<std::uint8_t>{{static_cast<int>(header.width), static_cast<int>(header.height)},
                                       static_cast<int>(PNG_IMAGE_SAMPLE_CHANNELS(header.format))};
    if (png_image_finish_read(&header, nullptr, result.image.mutablePixels().data(), 0, nullptr) == 0) {
        throw std::runtime_error{header.message};
    }
    return result;
}

inline DecodedPng decodePng(const std::vector<std::uint8_t>& bytes) {
    return decodePng(std::string{bytes.begin(), bytes.end()});
}

inline Image<std::uint8_t> noise(Size size, int channels) {
    Image<std::uint8_t> image{size, channels};
    std::uint32_t state = 1;
    for (std::uint8_t& value : image.mutablePixels())
        value = static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24);
    return image;
}

/// Every map of a 2 x 1 picture, each with values of its own.
inline Maps smallMaps() {
    const Size size{2, 1};
    Maps maps;
    maps.picture = Image<std::uint8_t>{size, 1, {0, 255}};
    maps.depth = Image<float>{size, 1, {2.5F, 4.0F}};
    maps.normal = Image<float>{size, 3, {0.6F, -0.8F, 0.0F, 0.0F, 0.0F, -1.0F}};
    maps.depthEdges = Image<std::uint8_t>{size, 1, {255, 0}};
    maps.normalEdges = Image<std::uint8_t>{size, 1, {0, 255}};
    maps.edges = Image<std::uint8_t>{size, 1, 255};
    maps.camera.near = 2.0;
    maps.camera.far = 4.0;
    maps.camera.view = glm::translate(glm::dmat4{1.0}, glm::dvec3{1.0, 2.0, -3.0});
    return maps;
}

inline Scene triangle() {
    Scene::Data data;
    Mesh& mesh = data.meshes.emplace_back();
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    data.instances.push_back({"triangle", 0, glm::dmat4{1.0}});
    data.warnings = {"a warning", "a name that is no UTF-8: \xff"};
    return Scene{std::move(data)};
}

/// While it lives no file may grow over `bytes`: what a full disk does, for root too.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : oldHandler_{std::signal(SIGXFSZ, SIG_IGN)} {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error{"setrlimit"};
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, oldHandler_);
    }

private:
    rlimit old_{};
    void (*oldHandler_)(int);
};

struct DecodedFile {
    OIIO::ImageSpec spec;
    Image<float> image;

    /// One channel's values by name.
    [[nodiscard]] std::vector<float> channel(const std::string& name) const {
        std::vector<float> values;
        const int index = spec.channelindex(name);
        if (index < 0) return values;
        for (int y = 0; y < spec.height; ++y) {
            for (int x = 0; x < spec.width; ++x) values.push_back(image.at(x, y, index));
        }
        return values;
    }
    [[nodiscard]] std::vector<float> matrix(const std::string& name) const {
        const OIIO::ParamValue* const entry = spec.find_attribute(name, OIIO::TypeMatrix44);
        if (entry == nullptr) return {};
        const auto* const values = static_cast<const float*>(entry->data());
        return {values, values + 16};
    }
};

inline DecodedFile decodeFile(const fs::path& file) {
    OIIO::ImageSpec cameraSettings;
    cameraSettings.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &cameraSettings);
    if (!input) throw std::runtime_error{OIIO::geterror()};
    DecodedFile result;
    result.spec = input->spec();
    result.image = Image<float>{{result.spec.width, result.spec.height}, result.spec.nchannels};
    if (!input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeFloat, result.image.mutablePixels().data())) {
        throw std::runtime_error{input->geterror()};
    }
    return result;
}

}  // namespace inkedge::decoded_files
