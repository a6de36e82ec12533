#include "io/problem/scenario_values.hpp"

#include "io/text/scanner.hpp"

namespace asv::io {

using Pointer = JsonDocument::Pointer;

std::size_t array_size(const JsonDocument& document, const Pointer& at, const std::string& what) {
    if (!document.is_array(at)) document.fail(at, what);
    return document.array(at).size();
}

double any_number(const JsonDocument& document, const Pointer& at) {
    return document.number(at, -largest_number, largest_number);
}

geometry::Point read_point(const JsonDocument& document, const Pointer& at) {
    const std::string point = "a point [x, y]";
    if (array_size(document, at, point) != 2) document.fail(at, point);
    return {any_number(document, at / 0), any_number(document, at / 1)};
}

}  // namespace asv::io
