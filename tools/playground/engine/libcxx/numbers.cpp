// Reads and writes double as <charconv> has it, by the C library, whose conversions round
// correctly.

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace std {

namespace {

/// Digits that tell every double from every other.
constexpr int most_digits = 17;
/// Digits that every double keeps, so that most short numbers are found at once.
constexpr int safe_digits = 15;

const char* skip_digits(const char* at, const char* last) {
    while (at != last && std::isdigit(static_cast<unsigned char>(*at))) ++at;
    return at;
}

/// Where the exponent at `at` ends; `at` where there is none.
const char* skip_exponent(const char* at, const char* last) {
    if (at == last || (*at != 'e' && *at != 'E')) return at;
    const char* digits = at + 1;
    if (digits != last && (*digits == '+' || *digits == '-')) ++digits;
    const char* const end = skip_digits(digits, last);
    return end == digits ? at : end;
}

/// Where the number that begins at `first` ends; `first` where there is none.
const char* end_of_number(const char* first, const char* last, bool with_exponent) {
    const char* const digits = first != last && *first == '-' ? first + 1 : first;
    for (const char* word : {"infinity", "inf", "nan"}) {
        const size_t length = std::strlen(word);
        if (static_cast<size_t>(last - digits) >= length && strncasecmp(digits, word, length) == 0)
            return digits + length;
    }
    const char* at = skip_digits(digits, last);
    auto count = at - digits;
    if (at != last && *at == '.') {
        const char* const end = skip_digits(at + 1, last);
        count += end - at - 1;
        at = end;
    }
    if (count == 0) return first;
    return with_exponent ? skip_exponent(at, last) : at;
}

/// "-d.ddde+XX" with the fewest digits that read back to the same number.
string shortest_scientific(double value) {
    char text[40];
    const auto reads_back = [&](int digits) {
        std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
        return std::strtod(text, nullptr) == value;
    };
    int digits = safe_digits;
    if (reads_back(digits)) {
        while (digits > 1 && reads_back(digits - 1)) --digits;
    } else {
        while (digits < most_digits && !reads_back(digits)) ++digits;
    }
    reads_back(digits);
    return text;
}

/// The same number without an exponent.
string fixed_of(const string& digits, int exponent) {
    const auto count = static_cast<int>(digits.size());
    if (exponent < 0) return "0." + string(static_cast<size_t>(-exponent - 1), '0') + digits;
    if (exponent >= count - 1)
        return digits + string(static_cast<size_t>(exponent - count + 1), '0');
    const auto whole = static_cast<size_t>(exponent + 1);
    return digits.substr(0, whole) + '.' + digits.substr(whole);
}

}  // namespace

from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format format) noexcept {
    const char* const end = end_of_number(first, last, format != chars_format::fixed);
    if (end == first) return {first, errc::invalid_argument};
    errno = 0;
    const double read = std::strtod(string(first, end).c_str(), nullptr);
    if (errno == ERANGE && (read == 0 || std::isinf(read))) return {end, errc::result_out_of_range};
    value = read;
    return {end, errc{}};
}

to_chars_result to_chars(char* first, char* last, double value) noexcept {
    const string scientific = shortest_scientific(value);
    const size_t e = scientific.find('e');
    string text = scientific;
    if (e != string::npos) {
        const string sign = std::signbit(value) ? "-" : "";
        string digits;
        for (const char c : scientific.substr(0, e))
            if (std::isdigit(static_cast<unsigned char>(c))) digits += c;
        const string fixed = sign + fixed_of(digits, std::atoi(scientific.c_str() + e + 1));
        if (fixed.size() <= scientific.size()) text = fixed;
    }
    if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), errc{}};
}

}  // namespace std
