#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace inkedge::batch {

/// How fast something goes on, of late.
class Pace {
public:
    /// @param seconds  since the beginning, rising
    void add(double seconds, std::uint64_t done);
    /// A second; 0 while it is not known.
    [[nodiscard]] double rate() const;
    /// Seconds that the rest takes; none while it is not known.
    [[nodiscard]] std::optional<double> left(std::uint64_t rest) const;

private:
    struct Moment {
        double seconds;
        std::uint64_t done;
    };
    std::deque<Moment> moments_;
};

}  // namespace inkedge::batch
