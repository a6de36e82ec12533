#include "tools/view/numbered_name.hpp"

namespace asv::tools {

std::optional<NumberedName> NumberedName::of(const std::filesystem::path& pattern) {
    const std::string name = pattern.filename().string();
    const std::size_t begin = name.find('%');
    if (begin == std::string::npos) return std::nullopt;
    std::size_t end = begin + 1;
    // One digit says how many there are: more pictures than that are none for a film.
    const bool padded =
        end + 1 < name.size() && name[end] == '0' && name[end + 1] >= '1' && name[end + 1] <= '9';
    NumberedName result;
    if (padded) {
        result.digits_ = static_cast<std::size_t>(name[end + 1] - '0');
        end += 2;
    }
    if (end == name.size() || name[end] != 'd') return std::nullopt;
    result.before_ = (pattern.parent_path() / name.substr(0, begin)).string();
    result.after_ = name.substr(end + 1);
    return result;
}

std::filesystem::path NumberedName::at(std::size_t number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < digits_) digits.insert(0, digits_ - digits.size(), '0');
    return before_ + digits + after_;
}

}  // namespace asv::tools
