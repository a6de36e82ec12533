#pragma once

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

}  // namespace asv::core
