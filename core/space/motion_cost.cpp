#include "core/space/motion_cost.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/elementary/sine_cosine.hpp"

namespace asv::core {

namespace {

/// A chord over an arc of this angle, radians, is 0.1 % shorter than the arc.
constexpr double arc = 0.16;

}  // namespace

MotionCost::MotionCost(const Chain& chain)
    : chain_(chain),
      row_(chain.dimension()),
      step_(chain.dimension()),
      heading_rate_(chain.broom_count()) {
    for (auto* array : {&x_, &y_, &last_x_, &last_y_}) array->resize(chain.asv_count());
}

double MotionCost::operator()(std::span<const double> from, std::span<const double> to) {
    for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = to[i] - from[i];
    chain_.headings(step_, heading_rate_);
    double most = 0;
    for (const double rate : heading_rate_) most = std::max(most, std::abs(rate));
    const auto pieces = static_cast<std::size_t>(most / arc) + 1;

    // The sines of all moments at once: those of a few headings fill no vector.
    const std::size_t brooms = chain_.broom_count();
    places_.resize(pieces + 1);
    for (auto* array : {&headings_, &sines_, &cosines_}) array->resize((pieces + 1) * brooms);
    for (std::size_t moment = 0; moment <= pieces; ++moment) {
        const double t = static_cast<double>(moment) / static_cast<double>(pieces);
        for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = from[i] + t * step_[i];
        // Most motions are one piece; theirs are the very poses of the ends.
        if (pieces == 1 && moment == 1) std::copy(to.begin(), to.end(), row_.begin());
        places_[moment] = {row_[0], row_[1]};
        chain_.headings(row_, {headings_.data() + moment * brooms, brooms});
    }
    elementary::sine_cosine(headings_, sines_, cosines_);

    double sum = 0;
    for (std::size_t moment = 0; moment <= pieces; ++moment) {
        chain_.positions(places_[moment], {cosines_.data() + moment * brooms, brooms},
                         {sines_.data() + moment * brooms, brooms}, x_, y_);
        for (std::size_t j = 0; moment > 0 && j < x_.size(); ++j) {
            const double dx = x_[j] - last_x_[j], dy = y_[j] - last_y_[j];
            sum += std::sqrt(dx * dx + dy * dy);
        }
        std::swap(x_, last_x_);
        std::swap(y_, last_y_);
    }
    return sum;
}

double MotionCost::path(const Configurations& rows) {
    const std::size_t d = chain_.dimension();
    double sum = 0;
    for (std::size_t i = d; i < rows.size(); i += d)
        sum += (*this)({rows.data() + i - d, d}, {rows.data() + i, d});
    return sum;
}

}  // namespace asv::core
