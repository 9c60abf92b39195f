#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <inkedge/image.h>

#include "io/zip.h"

namespace inkedge::io {

/// Arrays as a file that NumPy's load() reads: a ZIP of .npy files.
class NpzWriter {
public:
    /// Numbers in C order: of floats, or of whole numbers that are not negative.
    template <class Number>
    void add(std::string_view name, const std::vector<std::size_t>& shape, std::span<const Number> values) {
        const char* const kind = std::numeric_limits<Number>::is_integer ? "u" : "f";
        addBytes(name, kind + std::to_string(sizeof(Number)), shape,
                 {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
    }

    /// Height x width, and x channels if there are several.
    template <class Number>
    void add(std::string_view name, const Image<Number>& image) {
        std::vector<std::size_t> shape{static_cast<std::size_t>(image.size().height),
                                       static_cast<std::size_t>(image.size().width)};
        if (image.channels() > 1) shape.push_back(static_cast<std::size_t>(image.channels()));
        add(name, shape, std::span<const Number>{image.pixels()});
    }

    /// Texts as an array of one dimension. What is no UTF-8 becomes U+FFFD.
    /// @throws Error  (Kind::Output) if they take more than a gibibyte, each as long as the longest
    void addTexts(std::string_view name, std::span<const std::string> texts);

    [[nodiscard]] std::vector<std::uint8_t> take() && { return std::move(zip_).take(); }

private:
    void addBytes(std::string_view name, const std::string& type, const std::vector<std::size_t>& shape,
                  std::span<const std::uint8_t> values);

    ZipWriter zip_;
};

}  // namespace inkedge::io
