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

/// Stretches of a line that are apart from each other: begins and ends.
class Stretches {
public:
    void add(double from, double to);
    [[nodiscard]] bool hold(double position) const;
    /// Whether they hold all of a stretch but for gaps no longer than longestGap.
    [[nodiscard]] bool hold(double from, double to, double longestGap) const;
    [[nodiscard]] auto begin() const { return stretches_.begin(); }
    [[nodiscard]] auto end() const { return stretches_.end(); }

private:
    std::map<double, double> stretches_;
};

/// What becomes of a line on which others fall.
class CoincidentRuns {
public:
    /// @param shortest  pixels: dashes need as much to be seen as such. A shorter stretch along another line is none,
    ///                  and a shorter one between two such does not stay if it is beside the other line
    CoincidentRuns(const Line&, double within, double shortest);

    /// @param type  of the stretch from now on, if it comes before the type that it has; none: the stretch goes
    void add(double from, double to, std::optional<LineType> type);

    /// Tells of a stretch that is not much further from another line than those that go.
    void addBeside(double from, double to) { beside_.add(from, to); }

    [[nodiscard]] bool hasGone(double position) const { return gone_.hold(position); }
    [[nodiscard]] bool hasGone(double from, double to, double longestGap) const {
        return gone_.hold(from, to, longestGap);
    }

    /// What is left, but so short that it does not stay if it is beside another line.
    [[nodiscard]] std::vector<Run> doubtful() const;

    /// What is left, without stretches too short to be meant.
    [[nodiscard]] std::vector<Run> cleaned() const;

private:
    [[nodiscard]] double length(const Run&) const;
    [[nodiscard]] double lengthAt(double position) const;
    [[nodiscard]] std::vector<Run> parted() const;
    void absorb(std::vector<Run>&, double shorterThan) const;
    void absorbBeside(std::vector<Run>&) const;
    [[nodiscard]] bool isBeside(const Run&) const;
    [[nodiscard]] bool isBeside(double from, double to) const;

    LineType own_;
    bool closed_;
    double within_;
    double shortest_;
    std::vector<double> lengths_;  // pixels from the line's start to each joint
    Stretches gone_;
    Stretches beside_;
    std::vector<Run> typed_;
};

}  // namespace inkedge::lines
