#pragma once

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace inkedge::cad {

/// What the library asks a program for, by the program's arguments.
struct Request {
    std::string format;             ///< as nameOf(FileKind)
    std::uint64_t maxVertices = 0;  ///< as LoadLimits
    std::uint64_t maxInstances = 0;
    std::uint64_t maxNodes = 0;

    /// @throws std::runtime_error  if there are more than there may be
    void expectVertices(std::uint64_t count) const {
        expectFew(count, maxVertices, "vertices and indices", "max-vertices");
    }
    void expectInstances(std::uint64_t count) const { expectFew(count, maxInstances, "instances", "max-instances"); }
    void expectNodes(std::uint64_t count) const { expectFew(count, maxNodes, "nodes", "max-nodes"); }

    [[nodiscard]] std::vector<std::string> arguments() const {
        return {format, std::to_string(maxVertices), std::to_string(maxInstances), std::to_string(maxNodes)};
    }
    /// @param arguments  of main()
    [[nodiscard]] static Request of(int count, char** arguments) {
        if (count != 5) throw std::runtime_error{"expected a format and three limits, found others"};
        const auto number = [&](int i) { return std::strtoull(arguments[i], nullptr, 10); };
        return {arguments[1], number(2), number(3), number(4)};
    }

private:
    static void expectFew(std::uint64_t count, std::uint64_t max, const char* what, const char* setting) {
        if (count > max)
            throw std::runtime_error{fmt::format("expected at most {} {}, found more; raise {}", max, what, setting)};
    }
};

}  // namespace inkedge::cad
