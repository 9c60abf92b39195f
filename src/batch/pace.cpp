#include "batch/pace.h"

namespace inkedge::batch {

constexpr double ofLate = 60.0;  // seconds
constexpr double apart = 1.0;    // seconds

void Pace::add(double seconds, std::uint64_t done) {
    while (moments_.size() > 2 && seconds - moments_[1].seconds > ofLate) moments_.pop_front();
    if (moments_.size() > 1 && seconds - moments_[moments_.size() - 2].seconds < apart) moments_.pop_back();
    moments_.push_back({seconds, done});
}

double Pace::rate() const {
    if (moments_.size() < 2) return 0.0;
    const Moment& from = moments_.front();
    const Moment& to = moments_.back();
    return to.seconds > from.seconds ? static_cast<double>(to.done - from.done) / (to.seconds - from.seconds) : 0.0;
}

std::optional<double> Pace::left(std::uint64_t rest) const {
    const double rate = this->rate();
    if (rate <= 0.0) return {};
    return static_cast<double>(rest) / rate;
}

}  // namespace inkedge::batch
