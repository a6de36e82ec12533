#include "core/validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace asv::core {
namespace {

std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

std::string numbered(const char* what, const std::optional<std::size_t>& index) {
    if (!index) return std::string(what) + " ?";
    return std::string(what) + " " + std::to_string(*index + 1);
}

/// What a point and what a line of a body is called.
struct PartNames {
    const char* point;
    const char* link;
};

PartNames part_names(BodyKind body) {
    return body == BodyKind::chain ? PartNames{"ASV", "broom"} : PartNames{"point", "link"};
}

std::string point_name(const Offender& offender) {
    if (offender.body == BodyKind::point) return "the point";
    return numbered(part_names(offender.body).point, offender.asv);
}

std::string link_name(const Offender& offender) {
    if (offender.body == BodyKind::point) return "the point";
    return numbered(part_names(offender.body).link, offender.broom);
}

/// With so many digits that it is not the same as what is wanted.
std::string telling_number(double value, double other, double apart) {
    constexpr int fewest = 3, most = 17;
    const double scale = std::max(std::abs(value), std::abs(other));
    constexpr double rounding = 1e-17;
    int digits = fewest;
    for (double told = 100 * std::max(apart, rounding * scale); told < scale; told *= 10) ++digits;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", std::min(digits, most), value);
    return text.data();
}

std::string describe_length(const Offender& offender, const std::string& by) {
    const std::string link = link_name(offender);
    const double wanted = offender.wanted_length, off = std::abs(offender.length - wanted);
    // Points very far apart may have no distance that a number holds.
    if (!(wanted > 0 && std::isfinite(off))) return link + " is too long or too short" + by;
    std::string tolerance = short_number(off + offender.room);
    if (const auto zero = tolerance.find("e-0"); zero != std::string::npos)
        tolerance.erase(zero + 2, 1);
    return link + " is " + telling_number(offender.length, wanted, off) + " long, " +
           telling_number(wanted, offender.length, off) + " within " + tolerance + " is wanted";
}

std::string describe_turn(const Offender& offender, const std::string& by) {
    if (!offender.asv) return "the turns add up to more than 3 pi" + by + " rad";
    const std::string asv = "the turn at " + numbered("ASV", offender.asv);
    if (offender.room >= 0 && offender.time) {
        return "the side after " + numbered("ASV", offender.asv) + " shrinks to a point";
    }
    if (offender.room >= 0) return asv + " is exactly pi";
    return asv + " is against the others" + by + " rad";
}

std::string describe_place(Check check, const Offender& offender) {
    std::string place;
    const auto append = [&](const std::string& what) {
        place += (place.empty() ? " at " : ", ") + what;
    };
    const bool joint = check == Check::joint_limits;
    const bool parts = offender.body != BodyKind::point;
    if (offender.asv && parts)
        append(joint ? numbered("joint", offender.asv) : point_name(offender));
    if (offender.broom && parts) append(link_name(offender));
    if (offender.obstacle) append(numbered("obstacle", offender.obstacle));
    return place;
}

}  // namespace

std::string_view name(Check check) {
    static constexpr std::array<std::string_view, 15> names = {
        "ends",         "steps",  "cost",       "broom lengths", "convexity",
        "area",         "bounds", "collisions", "link lengths",  "base",
        "joint limits", "times",  "same path",  "speed",         "acceleration"};
    return names[static_cast<std::size_t>(check)];
}

std::string describe(Check check, const Offender& offender) {
    const std::string asv = point_name(offender);
    if (offender.asv && !std::isfinite(offender.room)) return asv + " has no finite position";
    const std::string by = " by " + short_number(std::abs(offender.room));
    switch (check) {
        case Check::ends:
            return asv + " misses its place" + by;
        case Check::steps:
            return asv + " moves too far" + by;
        case Check::cost:
            return "the written cost is wrong" + by;
        case Check::broom_lengths:
        case Check::link_lengths:
            return describe_length(offender, by);
        case Check::convexity:
            return describe_turn(offender, by);
        case Check::area:
            return "the area is too small" + by;
        case Check::bounds:
            return asv + " is out of bounds" + by;
        case Check::collisions:
            return link_name(offender) + " meets " + numbered("obstacle", offender.obstacle) + by;
        case Check::base:
            return "the base has moved" + by;
        case Check::joint_limits:
            return numbered("joint", offender.asv) + " is past its limit" + by + " rad";
        case Check::times:
            return "the time does not increase: it changes" + by + " s";
        case Check::same_path:
            return asv + " leaves the path" + by;
        case Check::speed:
            return asv + " is too fast" + by;
        case Check::acceleration:
            return asv + " changes its velocity too fast" + by;
    }
    return {};
}

bool ValidationReport::valid() const {
    const auto holds = [](const CheckResult& result) { return result.ok(); };
    return std::all_of(checks.begin(), checks.end(), holds) &&
           std::all_of(motion.begin(), motion.end(), holds);
}

std::string describe(const CheckResult& result) {
    if (!result.worst) return "nothing to check";
    if (!result.ok()) return describe(result.check, *result.worst);
    return "room " + short_number(result.worst->room) + describe_place(result.check, *result.worst);
}

}  // namespace asv::core
