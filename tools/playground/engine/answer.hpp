#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"

namespace asv::playground {

using Json = nlohmann::ordered_json;

/// What a call gives back: JSON, and beside it arrays of numbers, each with the member that it is.
struct Answer {
    Json json = Json::object();
    std::vector<std::pair<std::string, std::vector<double>>> arrays;
    std::string text;  ///< the JSON as text, once it is asked for

    void add(std::string member, std::vector<double> numbers) {
        arrays.emplace_back(std::move(member), std::move(numbers));
    }
};

/// What a call is asked: JSON, and the states that come with it, one number after the other.
struct Request {
    Json json;
    std::vector<double> states;
};

/// The problem of a request, a scenario without a map. Throws io::ParseError.
core::Problem problem_of(const Request& request);

/// x1 y1 x2 y2 ... of the states one after the other.
std::vector<double> numbers_of(const core::Path& path);

/// The states of so many ASVs. Throws std::invalid_argument where the numbers are no whole states.
core::Path path_of(const std::vector<double>& numbers, std::size_t asv_count);

// One function for each kind of message; worker.js tells what each takes and gives.
Answer check(const Request& request);
Answer plan(const Request& request);
Answer validate(const Request& request);
Answer profile(const Request& request);
Answer planners(const Request& request);
Answer read(const Request& request);
Answer write(const Request& request);

}  // namespace asv::playground
