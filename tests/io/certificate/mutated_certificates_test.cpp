#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/bounds/asv_plane.hpp"
#include "core/bounds/certify/certify.hpp"
#include "core/bounds/corridors/low_corridors.hpp"
#include "core/bounds/seams.hpp"
#include "core/bounds/walls.hpp"
#include "core/certificate_check/check_certificate.hpp"
#include "core/generate/families.hpp"
#include "io/certificate/certificate_file.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wall_of_two.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

/// Certificates that are not what the prover wrote: each is refused, or what it says is true.

namespace asv::io {
namespace {

using core::Problem;
using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

struct Case {
    std::string name;
    Problem problem;
    std::string text;
};

Problem low_corridor(std::size_t asv_count, double share) {
    core::CorridorOptions options;
    options.chain.asv_count = asv_count;
    options.height.factor = share;
    options.length = 0.05 * static_cast<double>(asv_count) + 0.01;
    core::Rng rng(asv_count);
    return core::corridor(options, rng);
}

Problem obstructed(core::Obstruction obstruction) {
    core::CorridorOptions options;
    options.chain.asv_count = 5;
    options.chain.obstruction = obstruction;
    core::Rng rng(3);
    return core::corridor(options, rng);
}

std::vector<Case> cases() {
    std::vector<Case> all;
    const auto add = [&](const std::string& name, const Problem& problem) {
        const auto proof = core::certify_infeasibility(problem);
        ASSERT_TRUE(proof) << name;
        all.push_back(
            {name, problem,
             format_certificate({core::certified(problem, problem_digest(problem)), *proof})});
    };
    for (const char* name :
         {"enclosed-goal", "enclosed-start", "opposite-orientation", "two-asvs", "wall-across"})
        add(name, test::testcase(std::string("infeasible/") + name + ".txt"));
    add("seams", test::wall_of_two(3, 1));
    add("upright seams", test::transposed(test::wall_of_two(3, 1)));
    add("fenced", obstructed(core::Obstruction::fenced));
    add("turned", obstructed(core::Obstruction::turned));
    for (const double share : {0.9, 0.95, 0.97}) add("corridor of 3", low_corridor(3, share));
    for (const std::size_t n : {4u, 7u})
        for (const double share : {0.9, 0.98}) add("corridor", low_corridor(n, share));
    add("upright corridor", test::transposed(low_corridor(5, 0.985)));
    return all;
}

bool accepted(const std::string& text, const Problem& problem) {
    try {
        return check_certificate(parse_certificate(text, "mutated"), problem,
                                 problem_digest(problem))
            .accepted();
    } catch (const ParseError&) {
        return false;
    }
}

TEST(Certificates, AreAcceptedForTheirProblemAlone) {
    const std::vector<Case> all = cases();
    for (const Case& one : all) {
        for (const Case& other : all)
            EXPECT_EQ(accepted(one.text, other.problem),
                      problem_digest(one.problem) == problem_digest(other.problem))
                << one.name << ", " << other.name;
    }
}

/// Do the obstacles of a proof separate, by the prover's own means, when it may close what it can?
bool separates(const Problem& problem, const std::vector<std::size_t>& obstacles,
               const core::Point& start, const core::Point& goal,
               const std::vector<core::Box>& closed, bool seams) {
    Problem some = problem;
    some.obstacles.clear();
    for (const std::size_t i : obstacles) some.obstacles.push_back(problem.obstacles.at(i));
    const double shrink = core::shrink_for_steps(problem.requirements);
    core::ShrunkObstacles walls = core::shrink_obstacles(some, shrink);
    walls.boxes.insert(walls.boxes.end(), closed.begin(), closed.end());
    geometry::FreePlane plane = seams ? core::make_asv_plane(some, core::Reading::literal)
                                      : geometry::FreePlane(walls.boxes, walls.bounds);
    return plane.is_free(start) && plane.is_free(goal) && !plane.connected(start, goal);
}

bool is_true(const core::SeparationProof& proof, const Problem& problem) {
    return separates(problem, proof.obstacles, problem.start.at(proof.asv),
                     problem.goal.at(proof.asv), {}, !proof.seams.empty());
}

bool is_true(const core::CorridorProof& proof, const Problem& problem) {
    std::vector<core::Box> closed;
    for (const core::LowCorridor& low : core::find_low_corridors(problem))
        for (const core::ClosedCorridor& one : proof.corridors)
            if (one.between.walls == low.walls && one.between.upright == low.upright)
                closed.push_back(low.closed);
    return separates(problem, proof.obstacles, core::middle_of_chain(problem.start),
                     core::middle_of_chain(problem.goal), closed, false);
}

/// The rest are numbers that no certificate can get wrong.
bool is_true(const core::AreaProof&, const Problem&) {
    return true;
}
bool is_true(const core::OrientationProof&, const Problem&) {
    return true;
}

bool is_true(const std::string& text, const Problem& problem) {
    const core::Certificate certificate = parse_certificate(text, "mutated");
    return std::visit([&](const auto& proof) { return is_true(proof, problem); },
                      certificate.proof);
}

void find_places(const Json& value, const Pointer& at, std::vector<Pointer>& places) {
    places.push_back(at);
    if (value.is_object())
        for (const auto& [name, inner] : value.items()) find_places(inner, at / name, places);
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) find_places(value[i], at / i, places);
}

Pointer pick(test::Random& random, const Json& document, bool (*wanted)(const Json&)) {
    std::vector<Pointer> places;
    find_places(document, Pointer(), places);
    std::erase_if(places, [&](const Pointer& at) { return !wanted(document.at(at)); });
    return places.empty() ? Pointer() : places[random.below(places.size())];
}

/// By more than the slack that docs/proofs.md tells, up to a million times that.
void change_number(test::Random& random, Json& document) {
    const Pointer at =
        pick(random, document, [](const Json& value) { return value.is_number_float(); });
    const double is = document.at(at).get<double>();
    const bool area =
        at.back() == "greatest_area" && at.to_string().find("corridors") != std::string::npos;
    const double slack = area ? 1e-6 * is : 1e-9 * (1 + std::abs(is));
    const double change = 1.5 * slack * std::pow(10, random.uniform(0, 6));
    document[at] = is + (random.one_in(2) ? change : -change);
    if (random.one_in(20) && std::abs(is) > slack) document[at] = random.one_in(2) ? 0 : -is;
}

void change_index(test::Random& random, Json& document) {
    const Pointer at = pick(random, document, [](const Json& value) {
        return value.is_number_integer() || value.is_boolean() || value.is_null();
    });
    Json& value = document[at];
    if (value.is_boolean())
        value = !value.get<bool>();
    else if (value.is_null() || random.one_in(3))
        value = 1 + random.below(6);
    else
        value =
            random.one_in(6) ? Json(nullptr) : Json(value.get<int>() + (random.one_in(2) ? 1 : -1));
}

/// An entry dropped, repeated, or moved to the end; or a number added.
void change_list(test::Random& random, Json& document) {
    const Pointer at = pick(random, document, [](const Json& value) { return value.is_array(); });
    if (at.empty()) return change_index(random, document);
    Json& list = document[at];
    const std::size_t choice = random.below(4);
    if (list.empty() || choice == 0) return list.push_back(1 + random.below(6));
    const std::size_t i = random.below(list.size());
    const Json entry = list[i];
    if (choice == 1)
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), entry);
    else
        list.erase(i);
    if (choice == 2) list.push_back(entry);
}

std::string broken(test::Random& random, std::string text) {
    const std::string letters = "0123456789-+.eE,:{}[]\"truefalsn \n";
    const std::size_t at = random.below(text.size());
    const char letter = letters[random.below(letters.size())];
    switch (random.below(4)) {
        case 0:
            return text.substr(0, at);
        case 1:
            return text.erase(at, 1 + random.below(5));
        case 2:
            return text.insert(at, 1, letter);
        default:
            text[at] = letter;
            return text;
    }
}

TEST(Certificates, WithANumberChangedAreRefused) {
    const std::vector<Case> all = cases();
    test::Random random(1);
    for (std::size_t i = 0; i < test::scaled(80); ++i) {
        const Case& one = all[i % all.size()];
        Json document = Json::parse(one.text);
        change_number(random, document);
        EXPECT_FALSE(accepted(document.dump(), one.problem)) << i << ": " << document.dump();
    }
}

TEST(Certificates, ThatAreChangedOtherwiseAreRefusedOrTrue) {
    const std::vector<Case> all = cases();
    test::Random random(2);
    std::size_t refused = 0, count = test::scaled(80);
    for (std::size_t i = 0; i < count; ++i) {
        const Case& one = all[i % all.size()];
        Json document = Json::parse(one.text);
        const std::size_t kind = random.below(3);
        if (kind == 0) change_index(random, document);
        if (kind == 1) change_list(random, document);
        const std::string text = kind == 2 ? broken(random, one.text) : document.dump();
        if (accepted(text, one.problem)) {
            EXPECT_TRUE(is_true(text, one.problem)) << i << ": " << text;
        } else {
            ++refused;
        }
    }
    EXPECT_GT(refused, count / 2);
    std::cout << refused << " of " << count << " are refused\n";
}

}  // namespace
}  // namespace asv::io
