#pragma once

#include <string>

#include <gtest/gtest.h>

namespace asv::test {

/// What the Error says that the call throws; a failure of the test where it throws none.
template <class Error, class Call>
std::string error_message(Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return "no error";
}

}  // namespace asv::test
