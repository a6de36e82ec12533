// The entry that libFuzzer calls, for one target.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/targets/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    asv::fuzz::ASV_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
