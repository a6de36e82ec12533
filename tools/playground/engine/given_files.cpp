#include "tools/playground/engine/given_files.hpp"

#include <filesystem>
#include <map>

#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"

namespace asv::playground {

namespace {

std::map<std::string, std::string>& contents() {
    static std::map<std::string, std::string> by_name;
    return by_name;
}

/// The bytes that stand in UTF-8 as characters of at most U+00FF, which take two bytes from U+0080
/// on: the upper two bits of the byte in the first, the lower six in the second.
std::string bytes_of(const std::string& characters) {
    std::string bytes;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const auto first = static_cast<unsigned char>(characters[i]);
        if (first < 0x80) {
            bytes.push_back(characters[i]);
        } else {
            const auto second = static_cast<unsigned char>(characters.at(++i));
            bytes.push_back(static_cast<char>((first & 0x03U) << 6U | (second & 0x3FU)));
        }
    }
    return bytes;
}

}  // namespace

GivenFiles::GivenFiles(const Json& files) {
    for (const auto& [name, characters] : files.items())
        contents()[name] = bytes_of(characters.get<std::string>());
}

GivenFiles::~GivenFiles() {
    contents().clear();
}

}  // namespace asv::playground

// What of io/text/atomic_file.hpp is asked for.
namespace asv::io {

std::string input_name(const std::filesystem::path& file) {
    return file.string();
}

std::string read_file(const std::filesystem::path& file, std::size_t /*limit*/) {
    const auto given = playground::contents().find(file.filename().string());
    if (given == playground::contents().end())
        throw ReadError(file.string() +
                        ": a page reads what is opened: choose it together with the scenario");
    return given->second;
}

std::string read_regular_file(const std::filesystem::path& file, std::size_t limit) {
    return read_file(file, limit);
}

void write_file(const std::filesystem::path& file, std::string_view /*content*/) {
    throw WriteError(file.string() + ": a page has no files to write");
}

}  // namespace asv::io
