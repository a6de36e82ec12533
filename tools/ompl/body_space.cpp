#include "tools/ompl/body_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <ompl/base/spaces/RealVectorStateProjections.h>

#include "core/search/trees/interpolate.hpp"

namespace asv::adaptor {

namespace {

double* values_of(ob::State* state) {
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}

/// Draws as the library's space does. OMPL's generator seeds the library's, so that OMPL's seed
/// decides everything.
class BodySampler : public ob::StateSampler {
  public:
    explicit BodySampler(const BodySpace* space)
        : ob::StateSampler(space), body_space_(*space), rng_of_library_(rng_.getLocalSeed()) {}

    void sampleUniform(ob::State* state) override {
        std::vector<double> row(body_space_.getDimension());
        body_space_.body().sample(rng_of_library_, row);
        body_space_.assign(row, state);
    }

    void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
        const Row middle = body_space_.row(near);
        std::vector<double> row(middle.size());
        body_space_.body().perturb(rng_of_library_, middle, distance, row);
        row = unwrapped(row, middle, body_space_.body().wrapping());
        // The direction is that of a normal draw; the length of an even draw from a ball.
        const double drawn = body_space_.body().distance(middle, row);
        const double wanted =
            distance * std::pow(rng_of_library_.uniform(), 1 / static_cast<double>(row.size()));
        if (drawn > wanted) core::interpolate(middle, row, wanted / drawn, row);
        body_space_.assign(row, state);
        body_space_.enforceBounds(state);
    }

    void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
        std::vector<double> row(body_space_.getDimension());
        body_space_.body().perturb(rng_of_library_, body_space_.row(mean), deviation, row);
        body_space_.assign(row, state);
        body_space_.enforceBounds(state);
    }

  private:
    const BodySpace& body_space_;
    core::Rng rng_of_library_;
};

}  // namespace

BodySpace::BodySpace(std::shared_ptr<const Body> body)
    : ob::RealVectorStateSpace(static_cast<unsigned int>(body->ranges().size())),
      body_(std::move(body)) {
    type_ = ob::STATE_SPACE_TYPE_COUNT + 1;
    setName("AsvBodySpace");
    ob::RealVectorBounds bounds(getDimension());
    for (unsigned int i = 0; i < getDimension(); ++i) {
        bounds.setLow(i, body_->ranges()[i].low);
        bounds.setHigh(i, body_->ranges()[i].high);
    }
    setBounds(bounds);
}

Row BodySpace::row(const ob::State* state) const {
    return {state->as<StateType>()->values, getDimension()};
}

void BodySpace::assign(Row row, ob::State* state) const {
    std::copy(row.begin(), row.end(), values_of(state));
    turn_into_range(values_of(state));
}

double BodySpace::getMaximumExtent() const {
    double sum = 0;
    for (std::size_t i = 0; i < getDimension(); ++i) sum += body_->extent(i) * body_->extent(i);
    return std::sqrt(sum);
}

double BodySpace::getMeasure() const {
    double product = 1;
    for (std::size_t i = 0; i < getDimension(); ++i)
        product *= body_->extent(i) * (body_->wrapping().contains(i) ? 2 : 1);
    return product;
}

void BodySpace::turn_into_range(double* values) const {
    constexpr double full = 2 * std::numbers::pi;
    const core::WrappingAngles angles = body_->wrapping();
    for (std::size_t i = angles.first; i < angles.first + angles.count; ++i)
        values[i] -= full * std::floor((values[i] - body_->ranges()[i].low) / full);
}

void BodySpace::enforceBounds(ob::State* state) const {
    turn_into_range(values_of(state));
    ob::RealVectorStateSpace::enforceBounds(state);
}

double BodySpace::distance(const ob::State* a, const ob::State* b) const {
    return body_->distance(row(a), row(b));
}

bool BodySpace::equalStates(const ob::State* a, const ob::State* b) const {
    return distance(a, b) <= std::numeric_limits<double>::epsilon();
}

void BodySpace::interpolate(const ob::State* from, const ob::State* to, double t,
                            ob::State* state) const {
    const std::vector<double> end = unwrapped(row(to), row(from), body_->wrapping());
    core::interpolate(row(from), end, t, {values_of(state), getDimension()});
    turn_into_range(values_of(state));
}

ob::StateSamplerPtr BodySpace::allocDefaultStateSampler() const {
    return std::make_shared<BodySampler>(this);
}

void BodySpace::registerProjections() {
    std::vector<unsigned int> first{0};
    if (getDimension() > 1) first.push_back(1);
    registerDefaultProjection(
        std::make_shared<ob::RealVectorOrthogonalProjectionEvaluator>(this, first));
}

}  // namespace asv::adaptor
