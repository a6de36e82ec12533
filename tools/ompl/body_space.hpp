#pragma once

#include <memory>
#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "tools/ompl/body.hpp"

namespace asv::adaptor {

namespace ob = ompl::base;

/// The C-space of a body for OMPL: states are configurations, the metric and the straight motions
/// are those of the library's own space. Angles that wrap are kept within their ranges and take the
/// short way. Its type is its own, since OMPL knows more about Euclidean spaces than is true here
/// (its direct informed sampler, for one, which BodyCost does without).
class BodySpace : public ob::RealVectorStateSpace {
  public:
    explicit BodySpace(std::shared_ptr<const Body> body);

    const Body& body() const { return *body_; }
    /// The configuration of a state.
    Row row(const ob::State* state) const;
    /// Sets a state, its angles turned into their ranges.
    void assign(Row row, ob::State* state) const;

    double getMaximumExtent() const override;
    double getMeasure() const override;
    void enforceBounds(ob::State* state) const override;
    double distance(const ob::State* a, const ob::State* b) const override;
    bool equalStates(const ob::State* a, const ob::State* b) const override;
    void interpolate(const ob::State* from, const ob::State* to, double t,
                     ob::State* state) const override;
    ob::StateSamplerPtr allocDefaultStateSampler() const override;
    /// To where the body is in the plane; of an arm, to its first two coordinates.
    void registerProjections() override;

  private:
    void turn_into_range(double* values) const;

    std::shared_ptr<const Body> body_;
};

}  // namespace asv::adaptor
