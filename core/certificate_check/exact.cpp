#include "core/certificate_check/exact.hpp"

namespace asv::core::certificate_check {

namespace {

using Whole = boost::multiprecision::cpp_int;

/// Roots are told in these.
const Whole parts_of_roots = Whole(1) << 60;

/// Of the value, in parts.
Whole root_in_parts(const Number& value) {
    const Number scaled = value * Number(parts_of_roots * parts_of_roots);
    return sqrt(Whole(numerator(scaled) / denominator(scaled)));
}

}  // namespace

double rounded(const Number& value) {
    return value.convert_to<double>();
}

Number root_below(const Number& value) {
    return Number(root_in_parts(value), parts_of_roots);
}

Number root_above(const Number& value) {
    return Number(root_in_parts(value) + 1, parts_of_roots);
}

// pi is 3.14159265358979323846...
Number pi_below() {
    return Number(314159265358979323, Whole(100000000000000000));
}

Number pi_above() {
    return Number(314159265358979324, Whole(100000000000000000));
}

std::size_t whole(const Number& value) {
    return Whole(numerator(value) / denominator(value)).convert_to<std::size_t>();
}

bool agrees(double stated, const Number& found) {
    const Number slack = exact(1e-9) * (1 + abs(found));
    return abs(exact(stated) - found) <= slack;
}

}  // namespace asv::core::certificate_check
