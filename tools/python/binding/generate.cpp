#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "core/generate/families.hpp"
#include "core/generate/vouch/vouch.hpp"
#include "tools/python/binding/module.hpp"
#include "tools/python/binding/support/keywords.hpp"

namespace asv::python {

namespace {

using core::Problem;
using core::Rng;
using namespace py::literals;

// Each family takes its options by the names that asv-generate gives them.

void take(Keywords& words, core::CorridorOptions& o) {
    words.take("height_factor", o.height.factor);
    words.take("height", o.height.absolute);
    words.take("length", o.length);
    words.take("level", o.level);
}

void take(Keywords& words, core::BendOptions& o) {
    words.take("height_factor", o.height.factor);
    words.take("height", o.height.absolute);
    words.take("bends", o.bends);
    words.take("leg", o.leg);
    words.take("room", o.room);
}

void take(Keywords& words, core::GauntletOptions& o) {
    words.take("height_factor", o.height.factor);
    words.take("height", o.height.absolute);
    words.take("walls", o.walls);
    words.take("thickness", o.thickness);
    words.take("least_offset", o.min_offset);
    words.take("room", o.room);
}

void take(Keywords& words, core::RoomsOptions& o) {
    words.take("height_factor", o.height.factor);
    words.take("height", o.height.absolute);
    words.take("rooms", o.rooms);
    words.take("doors", o.doors);
    words.take("thickness", o.thickness);
    words.take("shelves", o.shelves);
    words.take("shelf_gap", o.shelf_gap);
}

void take(Keywords& words, core::MazeOptions& o) {
    words.take("way_factor", o.way.factor);
    words.take("way", o.way.absolute);
    words.take("wall", o.wall);
    words.take("cells", o.cells);
}

void take(Keywords& words, core::SpiralOptions& o) {
    using core::SpiralDirection;
    words.take("way_factor", o.way.factor);
    words.take("way", o.way.absolute);
    words.take("wall", o.wall);
    words.take("legs", o.legs);
    words.take_word<SpiralDirection>("direction", o.direction,
                                     {{"random", SpiralDirection::random},
                                      {"inward", SpiralDirection::inward},
                                      {"outward", SpiralDirection::outward}});
}

void take(Keywords& words, core::CrossingOptions& o) {
    using core::Branch;
    const std::vector<std::pair<const char*, Branch>> branches{{"random", Branch::random},
                                                               {"east", Branch::east},
                                                               {"north", Branch::north},
                                                               {"west", Branch::west},
                                                               {"south", Branch::south}};
    words.take("road_factor", o.road.factor);
    words.take("road", o.road.absolute);
    words.take("offset", o.offset);
    words.take_word("start_arm", o.start_arm, branches);
    words.take_word("goal_arm", o.goal_arm, branches);
}

void take(Keywords& words, core::ClutterOptions& o) {
    words.take("obstacles", o.obstacles);
    words.take("density", o.density);
    words.take("side_ratio", o.side_ratio);
    words.take("lane", o.lane);
}

void take(Keywords& words, core::ChainOptions& o) {
    using core::Obstruction;
    using core::Orientation;
    words.take_word<Orientation>("orientation", o.orientation,
                                 {{"random", Orientation::random},
                                  {"cw", Orientation::clockwise},
                                  {"ccw", Orientation::counter_clockwise}});
    words.take_word<Obstruction>("infeasible", o.obstruction,
                                 {{"no", Obstruction::none},
                                  {"turned", Obstruction::turned},
                                  {"fenced", Obstruction::fenced}});
    words.take("clearance", o.clearance);
    words.take("area_margin", o.area_margin);
    words.take("least_turn", o.min_turn);
    words.take("least_closing", o.min_closing_side);
}

/// One family: draws a problem, or only says which options there are.
struct Family {
    const char* name;
    Problem (*draw)(std::size_t asv_count, Rng& rng, Keywords& words);
    void (*list)(Keywords& words);
};

template <class Options, Problem (*draw)(const Options&, Rng&)>
Family family(const char* name) {
    return {name,
            [](std::size_t asv_count, Rng& rng, Keywords& words) {
                Options options;
                take(words, options);
                take(words, options.chain);
                options.chain.asv_count = asv_count;
                words.finish();
                return draw(options, rng);
            },
            [](Keywords& words) {
                Options options;
                take(words, options);
                take(words, options.chain);
            }};
}

const std::vector<Family>& families() {
    static const std::vector<Family> all{family<core::CorridorOptions, core::corridor>("corridor"),
                                         family<core::BendOptions, core::bend>("bend"),
                                         family<core::GauntletOptions, core::gauntlet>("gauntlet"),
                                         family<core::RoomsOptions, core::rooms>("rooms"),
                                         family<core::MazeOptions, core::maze>("maze"),
                                         family<core::SpiralOptions, core::spiral>("spiral"),
                                         family<core::CrossingOptions, core::crossing>("crossing"),
                                         family<core::ClutterOptions, core::clutter>("clutter")};
    return all;
}

/// The first problem of the seed that is solvable for certain, of at most so many, else the last
/// one. One attempt is not looked at: vouching takes time.
Problem generate(const std::string& name, std::size_t asv_count, std::uint64_t seed,
                 std::size_t attempts, const py::dict& options) {
    const auto family = std::find_if(families().begin(), families().end(),
                                     [&](const Family& f) { return name == f.name; });
    if (family == families().end()) {
        std::string known;
        for (const Family& f : families())
            known += (known.empty() ? "" : ", ") + std::string(f.name);
        throw std::invalid_argument("there is no family '" + name + "'; there are: " + known);
    }
    Rng rng(seed);
    const auto draw = [&] {
        Keywords words(options);
        return family->draw(asv_count, rng, words);
    };
    Problem problem = draw();
    for (std::size_t attempt = 1; attempt < attempts && !core::vouch(problem).solvable; ++attempt)
        problem = draw();
    return problem;
}

}  // namespace

void bind_generate(py::module_& module) {
    module.def("families", [] {
        py::dict all;
        for (const Family& family : families()) {
            Keywords words{py::dict()};
            family.list(words);
            all[family.name] = words.known();
        }
        return all;
    });
    module.def("generate", &generate, "family"_a, "asv_count"_a, "seed"_a, "attempts"_a,
               "options"_a);
    module.def(
        "vouch",
        [](const Problem& problem) {
            core::Verdict verdict;
            {
                const py::gil_scoped_release release;
                verdict = core::vouch(problem);
            }
            return py::make_tuple(verdict.solvable, verdict.reason);
        },
        "problem"_a);
}

}  // namespace asv::python
