#pragma once

#include <cstddef>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace asv::core {

/// Throws std::invalid_argument "NAME must be between LOW and HIGH, not VALUE" when value is
/// outside the closed range or not a number.
template <class Value>
void require_range(std::string_view name, Value value, std::type_identity_t<Value> low,
                   std::type_identity_t<Value> high) {
    if (value >= low && value <= high) return;
    std::ostringstream message;
    message << name << " must be between " << low << " and " << high << ", not " << value;
    throw std::invalid_argument(message.str());
}

/// Throws std::invalid_argument "COUNT ASVs need WHAT SIZE HOW, and ..." when a size that follows
/// from the number of ASVs is outside its range, or not a number: that number is the cause.
inline void require_derived(std::size_t asv_count, std::string_view what, std::string_view how,
                            double size, double low, double high) {
    if (size >= low && size <= high) return;
    std::ostringstream message;
    message << std::setprecision(2) << asv_count << " ASVs need " << what << ' ' << size << ' '
            << how << " with this factor, and it may be " << low << " to " << high
            << "; take fewer ASVs or another factor";
    throw std::invalid_argument(message.str());
}

}  // namespace asv::core
