#pragma once

#include <string>
#include <vector>

namespace asv::io {

/// From data to places on the page along one direction.
struct Axis {
    double low = 0, high = 1;  ///< of the data, low < high; both above 0 where logarithmic
    double from = 0, to = 1;   ///< where they are on the page
    bool logarithmic = false;

    double at(double value) const;
};

struct Tick {
    double value = 0;
    std::string label;
};

/// A logarithmic axis of times in seconds whose ends are 1, 2 or 5 times a power of ten and enclose
/// the given ones. Precondition: 0 < least <= greatest.
Axis time_axis(double least, double greatest, double from, double to);

/// Powers of ten, with 2 and 5 times them where there would be few: "1 ms", "10 s".
std::vector<Tick> time_ticks(const Axis& axis);

/// The same places with plain numbers.
std::vector<Tick> factor_ticks(const Axis& axis);

/// Every quarter from 0 to 1, every half with a label in per cent.
std::vector<Tick> share_ticks();

/// An axis whose ends enclose the given ones with some room. Precondition: least <= greatest.
Axis cost_axis(double least, double greatest, double from, double to);

/// Round numbers with no more than so many steps between them.
inline constexpr double most_cost_steps = 5;
std::vector<Tick> cost_ticks(const Axis& axis, double most_steps = most_cost_steps);

}  // namespace asv::io
