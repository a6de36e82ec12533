#include "io/player/player.hpp"

#include <limits>
#include <span>

#include <nlohmann/json.hpp>

#include "core/model/planning_window.hpp"
#include "io/player/assets.hpp"
#include "io/player/held_states.hpp"
#include "io/player/packing.hpp"
#include "io/text/markup.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<double> flat(std::span<const Point> points) {
    std::vector<double> numbers;
    numbers.reserve(2 * points.size());
    for (const Point& point : points) numbers.insert(numbers.end(), {point.x, point.y});
    return numbers;
}

/// Appends the sides of the boxes as pack_doubles has them. There may be a million: part by part,
/// no second copy of all is ever in memory.
void append_packed(std::string& text, std::span<const Box> boxes) {
    // The bytes of so many boxes are a multiple of three, which base64 needs no padding for.
    constexpr std::size_t boxes_at_a_time = 3 * 256;
    std::vector<double> numbers;
    while (!boxes.empty()) {
        const std::size_t count = std::min(boxes.size(), boxes_at_a_time);
        numbers.clear();
        for (const Box& box : boxes.first(count))
            numbers.insert(numbers.end(), {box.low.x, box.low.y, box.high.x, box.high.y});
        text += pack_doubles(numbers);
        boxes = boxes.subspan(count);
    }
}

/// The states that the page holds, as one table of their coordinates.
PackedTable packed_positions(const Exhibit& exhibit, std::span<const std::size_t> held) {
    if (held.empty()) return {};
    std::vector<double> numbers;
    numbers.reserve(2 * held.size() * exhibit.problem.asv_count());
    for (const std::size_t state : held) {
        for (const Point& point : exhibit.solution->path.state(state))
            numbers.insert(numbers.end(), {point.x, point.y});
    }
    return pack_table(numbers, 2 * exhibit.problem.asv_count());
}

void add_measures(ordered_json& data, const Exhibit& exhibit, std::span<const std::size_t> held) {
    const auto column = [&](const auto& value) {
        std::vector<decltype(value(exhibit.measures.front()))> numbers;
        numbers.reserve(held.size());
        for (const std::size_t state : held) numbers.push_back(value(exhibit.measures[state]));
        return numbers;
    };
    const auto doubles = [&](const char* key, const auto& value) {
        data[key] = pack_doubles(column(value));
    };
    const auto integers = [&](const char* key, const auto& value) {
        data[key] = pack_integers(
            column([&](const StateMeasures& m) { return static_cast<std::int32_t>(value(m)); }));
    };
    using M = StateMeasures;
    doubles("cost", [](const M& m) { return m.cost; });
    doubles("clearance", [](const M& m) { return m.clearance ? m.clearance->distance : none; });
    integers("clearanceBroom", [](const M& m) { return m.clearance ? m.clearance->broom : 0; });
    integers("clearanceObstacle",
             [](const M& m) { return m.clearance ? m.clearance->obstacle : 0; });
    const bool closed = exhibit.problem.body_kind() == core::BodyKind::chain;
    doubles("area", [&](const M& m) { return closed ? m.area : none; });
    doubles("turn", [](const M& m) { return m.tightest_turn.value_or(none); });
    integers("turnAsv", [](const M& m) { return m.tightest_asv; });
}

/// How many states of so many points fit into the bytes that a page has for them: of each seven
/// numbers of a measure and its step, and coordinates, which take up to five bytes where the
/// states lie apart; all of it in base64.
std::size_t most_states(std::size_t points) {
    constexpr std::size_t bytes_for_states = 3'500'000;
    constexpr std::size_t bytes_of_measures = 64;
    constexpr std::size_t bytes_of_point = 14;
    return bytes_for_states / (bytes_of_measures + bytes_of_point * points);
}

void add_states(ordered_json& data, const Exhibit& exhibit, std::span<const std::size_t> held) {
    const std::size_t all = exhibit.measures.size();
    data["states"] = held.size();
    data["lastStep"] = std::max<std::size_t>(all, 1) - 1;
    // Where all states are there, each is the step of its index.
    const std::vector<std::int32_t> steps(held.begin(), held.end());
    data["steps"] = held.size() == all ? "" : pack_integers(steps);
    const PackedTable positions = packed_positions(exhibit, held);
    data["unit"] = positions.unit;
    data["positions"] = positions.text;
    add_measures(data, exhibit, held);
}

void add_complaints(ordered_json& data, const Exhibit& exhibit) {
    data["complaints"] = ordered_json::array();
    for (const core::CheckResult& check : exhibit.report.checks) {
        if (check.ok()) continue;
        const bool placed = check.worst && check.check != core::Check::cost;
        std::string sentence = core::describe(check);
        if (!exhibit.solution && placed) {
            sentence += check.worst->state == 0 ? " (start)" : " (goal)";
        }
        data["complaints"].push_back(
            {{"check", core::name(check.check)},
             {"sentence", std::move(sentence)},
             {"step", placed ? ordered_json(check.worst->state) : ordered_json(nullptr)}});
    }
    if (!exhibit.feasibility.reason.empty())
        data["complaints"].push_back(
            {{"check", "no path"}, {"sentence", exhibit.feasibility.reason}, {"step", nullptr}});
}

void add_violations(ordered_json& data, const Exhibit& exhibit, std::span<const std::size_t> held) {
    // As many take about a megabyte.
    constexpr std::size_t most_violations = 6000;
    const auto has_place = [](const Violation& v) { return v.check != core::Check::cost; };
    data["violationCount"] =
        std::count_if(exhibit.violations.begin(), exhibit.violations.end(), has_place);
    data["violations"] = ordered_json::array();
    const auto index = [](const std::optional<std::size_t>& i) {
        return i ? static_cast<std::int64_t>(*i) : -1;
    };
    for (const Violation& violation : held_violations(exhibit, held, most_violations)) {
        if (!has_place(violation)) continue;
        data["violations"].push_back(
            {{"check", core::name(violation.check)},
             {"step", violation.offender.state},
             {"asv", index(violation.offender.asv)},
             {"broom", index(violation.offender.broom)},
             {"obstacle", index(violation.offender.obstacle)},
             {"sentence", core::describe(violation.check, violation.offender)}});
    }
}

ordered_json packed(const SearchTree& tree) {
    std::vector<float> points;
    for (const double number : flat(tree.points)) points.push_back(static_cast<float>(number));
    const std::vector<std::int32_t> parents(tree.parents.begin(), tree.parents.end());
    const bool known = tree.root == "start" || tree.root == "goal";
    return {{"kind", known ? tree.root : "roadmap"},
            {"points", pack_floats(points)},
            {"parents", pack_integers(parents)},
            {"edges", ""}};
}

void add_trees(ordered_json& data, const Exhibit& exhibit) {
    data["trees"] = ordered_json::array();
    if (!exhibit.trees) return;
    for (const SearchTree& tree : exhibit.trees->trees) data["trees"].push_back(packed(tree));
    std::vector<std::int32_t> edges;
    for (const auto& edge : exhibit.trees->edges) {
        for (const std::size_t node : edge) edges.push_back(static_cast<std::int32_t>(node));
    }
    if (!edges.empty()) data["trees"][0]["edges"] = pack_integers(edges);
}

ordered_json words_of(core::BodyKind body) {
    const BodyWords words = words_for(body);
    return {{"first", words.first}, {"chain", words.chain}, {"path", words.path},
            {"link", words.link},   {"seen", words.seen},   {"counted", words.counted}};
}

const char* kind_name(core::BodyKind body) {
    constexpr const char* names[] = {"chain", "arm", "point"};
    return names[static_cast<std::size_t>(body)];
}

ordered_json data_of(const Exhibit& exhibit) {
    const core::Problem& problem = exhibit.problem;
    const Box bounds = core::planning_window(problem);
    ordered_json data = {{"name", exhibit.name},
                         {"facts", facts(exhibit)},
                         {"body", kind_name(problem.body_kind())},
                         {"words", words_of(problem.body_kind())},
                         {"asvCount", problem.asv_count()},
                         {"bounds", {bounds.low.x, bounds.low.y, bounds.high.x, bounds.high.y}},
                         {"minimumArea", problem.requirements.min_area(problem.asv_count())},
                         {"totalCost", exhibit.solution ? exhibit.solution->cost : 0},
                         {"lowerBound", exhibit.lower_bound ? ordered_json(*exhibit.lower_bound)
                                                            : ordered_json(nullptr)},
                         {"start", flat(problem.start)},
                         {"goal", flat(problem.goal)}};
    const std::vector<std::size_t> held = held_states(exhibit, most_states(problem.asv_count()));
    add_states(data, exhibit, held);
    data["valid"] =
        exhibit.report.valid() && exhibit.feasibility.cause == core::Infeasibility::none;
    data["verdict"] = verdict(exhibit);
    add_complaints(data, exhibit);
    add_violations(data, exhibit, held);
    add_trees(data, exhibit);
    return data;
}

}  // namespace

std::string make_player(const Exhibit& exhibit) {
    const std::string title = escape_markup(exhibit.name);
    const std::string data = embeddable(data_of(exhibit).dump(-1, ' ', true));
    const std::span<const Box> obstacles = exhibit.problem.obstacles;
    std::string result;
    result.reserve(assets::page.size() + assets::style.size() + assets::script.size() +
                   data.size() + 2 * title.size() + base64_size(obstacles.size_bytes()));
    append_filled(result, assets::page, [&](std::string& page, std::string_view key) {
        if (key == "OBSTACLES") return append_packed(page, obstacles);
        page += key == "TITLE"    ? std::string_view(title)
                : key == "STYLE"  ? assets::style
                : key == "SCRIPT" ? assets::script
                                  : std::string_view(data);
    });
    return result;
}

}  // namespace asv::io
