#pragma once

#include <map>
#include <optional>
#include <vector>

#include <inkedge/lines.h>

namespace inkedge::lines {

/// A stretch of a line. Positions along a line count its straight pieces, as those of a Part count segments.
struct Run {
    double begin;
    double end;  ///< of a closed line it may be over the number of pieces: the run goes on at the start
    std::optional<LineType> type;  ///< none: it goes
};

/// What becomes of a line on which others fall.
class CoincidentRuns {
public:
    explicit CoincidentRuns(const Line&);

    /// @param type  of the stretch from now on, if it comes before the type that it has; none: the stretch goes
    void add(double from, double to, std::optional<LineType> type);

    [[nodiscard]] bool hasGone(double position) const;

    /// What is left, without stretches too short to be meant.
    [[nodiscard]] std::vector<Run> cleaned() const;

private:
    [[nodiscard]] double length(const Run&) const;
    [[nodiscard]] double lengthAt(double position) const;
    [[nodiscard]] std::vector<Run> parted() const;
    void absorb(std::vector<Run>&, double shorterThan) const;

    LineType own_;
    bool closed_;
    std::vector<double> lengths_;    // pixels from the line's start to each joint
    std::map<double, double> gone_;  // begins and ends, apart from each other
    std::vector<Run> typed_;
};

}  // namespace inkedge::lines
