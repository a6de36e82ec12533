#include "asv/core/path/taut.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

namespace {

/// Gap that taut paths keep to obstacles: what is left of the detour round a corner.
constexpr double hug = 2e-5;
/// Tries of a shorter step where the full one gains nothing.
constexpr int halvings = 2;
/// ASVs that hardly move pull with a bounded force; workspace units.
constexpr double softening = 1e-4;

}  // namespace

TautPuller::TautPuller(MotionChecker& checker, const Metric& metric)
    : checker_(checker),
      metric_(metric),
      dimension_(checker.chain().dimension()),
      constrained_(checker.chain(), checker.constraints(), checker.field(), metric),
      cost_(checker.chain()),
      before_(checker.chain().make_pose()),
      here_(checker.chain().make_pose()),
      behind_(checker.chain().make_pose()),
      wish_(dimension_),
      candidate_(dimension_),
      heading_gradient_(checker.chain().broom_count()) {}

Rows TautPuller::resample(const Rows& path, double spacing) const {
    Rows fine(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(dimension_));
    for (std::size_t i = dimension_; i < path.size(); i += dimension_) {
        const double* a = path.data() + i - dimension_;
        const double* b = path.data() + i;
        const double length = metric_.distance({a, dimension_}, {b, dimension_});
        const auto pieces = static_cast<std::size_t>(length / spacing) + 1;
        for (std::size_t piece = 1; piece < pieces; ++piece) {
            const double t = static_cast<double>(piece) / static_cast<double>(pieces);
            for (std::size_t k = 0; k < dimension_; ++k) fine.push_back(a[k] + t * (b[k] - a[k]));
        }
        fine.insert(fine.end(), b, b + dimension_);
    }
    return fine;
}

double TautPuller::sweep(Rows& path) {
    const std::size_t count = path.size() / dimension_;
    double gained = 0;
    for (std::size_t i = 1; i + 1 < count; ++i) gained += improve(path, i);
    for (std::size_t i = count - 1; i-- > 1;) gained += improve(path, i);
    return gained;
}

double TautPuller::improve(Rows& path, std::size_t index) {
    const auto before = row(path, index - 1), here = row(path, index),
               behind = row(path, index + 1);
    double length = downhill(before, here, behind);
    const double old = cost_(before, here) + cost_(here, behind);
    for (int attempt = 0; attempt <= halvings && length > 1e-6; ++attempt) {
        ++steps_;
        constrained_.linearise(here, length, hug, 0);
        const auto next = constrained_.solve(wish_);
        std::copy(next.begin(), next.end(), candidate_.begin());
        const double gain = old - cost_(before, candidate_) - cost_(candidate_, behind);
        if (gain > 1e-9 && checker_.valid(before, candidate_) &&
            checker_.valid(candidate_, behind)) {
            std::copy(candidate_.begin(), candidate_.end(), here.begin());
            return gain;
        }
        for (double& value : wish_) value *= 0.4;
        length *= 0.4;
    }
    return 0;
}

/// Fills wish_ with a step, in scaled coordinates, down the gradient of the sum of the ASVs'
/// distances to the two neighbours, as long as one that would bring unit springs to rest; returns
/// its length.
double TautPuller::downhill(std::span<const double> before, std::span<const double> here,
                            std::span<const double> behind) {
    const Chain& chain = checker_.chain();
    chain.forward(before, before_);
    chain.forward(here, here_);
    chain.forward(behind, behind_);
    const std::size_t n = chain.asv_count();
    // The derivative by heading k needs the sum of the forces on all ASVs behind broom k.
    double total_x = 0, total_y = 0, stiffness = 0;
    double behind_x = 0, behind_y = 0;
    for (std::size_t j = n; j-- > 0;) {
        double force_x = 0, force_y = 0;
        for (const Pose* neighbour : {&before_, &behind_}) {
            const double dx = neighbour->x[j] - here_.x[j], dy = neighbour->y[j] - here_.y[j];
            const double strength = 1 / std::sqrt(dx * dx + dy * dy + softening * softening);
            force_x += strength * dx;
            force_y += strength * dy;
            stiffness += strength;
        }
        total_x += force_x;
        total_y += force_y;
        behind_x += force_x;
        behind_y += force_y;
        if (j > 0)
            heading_gradient_[j - 1] =
                chain.broom_length() * (here_.ux[j - 1] * behind_y - here_.uy[j - 1] * behind_x);
    }
    for (std::size_t k = 0; k < chain.broom_count(); ++k)
        heading_gradient_[k] += chain.broom_length() * chain.anchor_lever()[k] *
                                (here_.ux[k] * total_y - here_.uy[k] * total_x);
    wish_[0] = total_x;
    wish_[1] = total_y;
    double sum = 0;
    for (std::size_t k = chain.broom_count(); k-- > 0;) {
        sum += heading_gradient_[k];
        if (k > 0) wish_[2 + k] = sum;
    }
    if (chain.broom_count() > 0) wish_[2] = sum / metric_.scale(2);
    for (std::size_t i = 0; i < chain.turn_count(); ++i)
        wish_[3 + i] = (wish_[3 + i] - chain.heading_share()[i] * sum) / metric_.scale(3 + i);
    double square = 0;
    for (double& value : wish_) {
        value /= stiffness;
        square += value * value;
    }
    return std::sqrt(square);
}

void TautPuller::simplify(Rows& path) {
    std::size_t kept = 1;
    const std::size_t count = path.size() / dimension_;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const auto last = row(path, kept - 1), here = row(path, i), next = row(path, i + 1);
        const double past = cost_(last, next);
        if (past <= (cost_(last, here) + cost_(here, next)) * (1 + 1e-9) &&
            checker_.valid(last, next))
            continue;
        if (kept != i) std::copy(here.begin(), here.end(), row(path, kept).begin());
        ++kept;
    }
    const auto goal = row(path, count - 1);
    if (kept != count - 1) std::copy(goal.begin(), goal.end(), row(path, kept).begin());
    path.resize((kept + 1) * dimension_);
}

}  // namespace asv::core
