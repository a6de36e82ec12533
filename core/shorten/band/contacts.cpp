#include "core/shorten/band/contacts.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

namespace {

/// Gap that taut paths keep to obstacles: what is left of the detour round a corner.
constexpr double hug = 2e-5;
/// How hard a contact is, force per unit of gap: it sinks in by far less than the margin.
constexpr double hardness = 1e8;
/// Slacks begin at this at least, in units of length.
constexpr double min_slack = 1e-6;
/// In one step, slacks and forces fall to this share of themselves at most.
constexpr double min_share = 0.1;

}  // namespace

Contacts::Contacts(const MotionChecker& checker)
    : dimension_(checker.chain().dimension()),
      near_(checker.chain(), checker.constraints(), checker.field()) {}

void Contacts::find(const WayPoints& path, double reach, double barrier) {
    contacts_.clear();
    first_.assign(path.count(), 0);
    for (std::size_t i = 1; i + 1 < path.count(); ++i) {
        first_[i] = contacts_.size();
        for (const NearConstraint& near : near_.find(path.poses[i], reach))
            add(path, near, i, barrier);
    }
    first_.back() = contacts_.size();
    for (std::size_t i = 1; i + 2 < path.count(); ++i) add_switches(path, i, barrier);
    gradients_.resize(contacts_.size() * dimension_);
}

void Contacts::add(const WayPoints& path, const NearConstraint& near, std::size_t node,
                   double barrier) {
    double unit = 1;
    const double length = path.chain.broom_length();
    if (near.kind == NearConstraint::Kind::turn) unit = length;
    if (near.kind == NearConstraint::Kind::area)
        unit = 1 / (length * static_cast<double>(path.chain.asv_count()));
    const double gap = unit * near_.gap(near, path.row(node), path.poses[node]);
    const double slack = std::max(gap - hug, min_slack);
    contacts_.push_back({near, node, unit, slack, barrier / slack});
}

/// Where another axis separates a broom from a box at the next way point, one of the two has to be
/// clear along both axes: the motion between them would cut the corner else. It is the one that is
/// nearer to that.
void Contacts::add_switches(const WayPoints& path, std::size_t node, double barrier) {
    const std::size_t next = first_[node + 1], end = first_[node + 2];
    for (std::size_t a = first_[node]; a < next; ++a) {
        const NearConstraint here = contacts_[a].near;
        for (std::size_t b = next; b < end; ++b) {
            const NearConstraint there = contacts_[b].near;
            if (!here.same_pair(there) || here.same_axis(there)) continue;
            const double on = near_.gap(here, path.row(node + 1), path.poses[node + 1]);
            const double back = near_.gap(there, path.row(node), path.poses[node]);
            if (back >= on)
                add(path, there, node, barrier);
            else
                add(path, here, node + 1, barrier);
        }
    }
}

/// How far the gap of a constraint falls, on the motions to and from a way point, below the lesser
/// of its values at their ends: by a parabola through those and the middle.
double Contacts::dip(const WayPoints& path, const NearConstraint& near, std::size_t node,
                     double gap) const {
    double most = 0;
    for (const std::size_t motion : {node - 1, node}) {
        const std::size_t other = motion == node ? node + 1 : node - 1;
        const double there = near_.gap(near, path.row(other), path.poses[other]);
        const double middle = near_.gap(near, path.row(node), path.middles[motion]);
        const double bend = 2 * (gap + there) - 4 * middle;
        const double rise = std::abs(there - gap);
        if (bend > rise) most = std::max(most, (bend - rise) * (bend - rise) / (4 * bend));
    }
    return most;
}

void Contacts::press(const WayPoints& path, double barrier, BlockTridiagonal& system,
                     std::span<double> force) {
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
        Contact& contact = contacts_[c];
        const std::size_t i = contact.node;
        const auto slope = gradient(c);
        near_.gradient(contact.near, path.poses[i], slope);
        for (double& value : slope) value *= contact.unit;
        const double gap = near_.gap(contact.near, path.row(i), path.poses[i]);
        // Turns are straight along a motion; all else bends.
        const bool straight = contact.near.kind == NearConstraint::Kind::turn;
        const double margin = hug + (straight ? 0 : contact.unit * dip(path, contact.near, i, gap));
        const double give = contact.force / hardness;
        contact.lack = contact.unit * gap - margin + give - contact.slack;
        contact.rest =
            (barrier - contact.force * (contact.slack + contact.lack)) / (contact.slack + give);
        contact.stiff = contact.force / (contact.slack + give);
        double* push = force.data() + (i - 1) * dimension_;
        double* block = system.diagonal(i - 1).data();
        for (std::size_t column = 0; column < dimension_; ++column) {
            push[column] += (contact.force + contact.rest) * slope[column];
            const double part = contact.stiff * slope[column];
            for (std::size_t r = 0; r < dimension_; ++r)
                block[column * dimension_ + r] += part * slope[r];
        }
    }
}

void Contacts::follow(std::span<const double> step) {
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
        Contact& contact = contacts_[c];
        const auto slope = gradient(c);
        const double* moved = step.data() + (contact.node - 1) * dimension_;
        double along = 0;
        for (std::size_t k = 0; k < dimension_; ++k) along += slope[k] * moved[k];
        const double push = contact.rest - contact.stiff * along;
        const double slide = along + push / hardness + contact.lack;
        contact.slack = std::max(contact.slack + slide, min_share * contact.slack);
        contact.force = std::max(contact.force + push, min_share * contact.force);
    }
}

}  // namespace asv::core
