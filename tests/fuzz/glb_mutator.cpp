// Mutates the JSON or the data of a .glb by itself and puts the lengths right, as wrong lengths end every reading
// early.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximumSize);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t headers = 28;  // of the file and of two chunks

std::uint32_t wordAt(const std::uint8_t* data) {
    std::uint32_t word = 0;
    std::memcpy(&word, data, sizeof word);
    return word;
}

void append(Bytes& bytes, std::size_t number, const char* tag) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i) & 255));
    bytes.insert(bytes.end(), tag, tag + 4);
}

void mutate(Bytes& part, std::size_t maximumSize) {
    const std::size_t size = part.size();
    part.resize(std::max(maximumSize, size));
    part.resize(LLVMFuzzerMutate(part.data(), size, part.size()));
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maximumSize,
                                               unsigned int seed) {
    const bool whole = seed % 16 == 0;
    if (whole || size <= headers || std::memcmp(data, "glTF", 4) != 0) return LLVMFuzzerMutate(data, size, maximumSize);
    const std::size_t jsonSize = wordAt(data + 12);
    if (jsonSize > size - headers) return LLVMFuzzerMutate(data, size, maximumSize);

    Bytes json{data + 20, data + 20 + jsonSize};
    Bytes binary{data + headers + jsonSize, data + size};
    Bytes& part = seed % 3 == 0 && !binary.empty() ? binary : json;
    mutate(part, maximumSize - size + part.size());

    Bytes file{'g', 'l', 'T', 'F', 2, 0, 0, 0};
    append(file, headers + json.size() + binary.size(), "    ");
    file.resize(12);
    append(file, json.size(), "JSON");
    file.insert(file.end(), json.begin(), json.end());
    append(file, binary.size(), "BIN");
    file.insert(file.end(), binary.begin(), binary.end());
    std::copy_n(file.begin(), std::min(file.size(), maximumSize), data);
    return std::min(file.size(), maximumSize);
}
