#pragma once

#include <png.h>

#include <gtest/gtest.h>

#include <string>

struct Picture {
    unsigned width = 0;
    unsigned height = 0;
    std::string grey;  ///< a byte a pixel
};

/// Fails the test if the bytes are no whole PNG.
inline Picture decodePng(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
        ADD_FAILURE() << "expected a PNG, found " << bytes.size() << " bytes: " << image.message;
        return {};
    }
    image.format = PNG_FORMAT_GRAY;
    Picture picture{image.width, image.height, std::string(PNG_IMAGE_SIZE(image), '\0')};
    EXPECT_NE(png_image_finish_read(&image, nullptr, picture.grey.data(), 0, nullptr), 0) << image.message;
    return picture;
}
