#include "io/player/player.hpp"

#include <limits>
#include <span>

#include <nlohmann/json.hpp>

#include "core/model/planning_window.hpp"
#include "io/player/assets.hpp"
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

std::string pack(const std::vector<Box>& boxes) {
    std::vector<double> numbers;
    numbers.reserve(4 * boxes.size());
    for (const Box& box : boxes) {
        numbers.insert(numbers.end(), {box.low.x, box.low.y, box.high.x, box.high.y});
    }
    return pack_doubles(numbers);
}

/// One column of the measures, as doubles or as 0-based indices.
template <class Value>
auto column(const Exhibit& exhibit, const Value& value) {
    std::vector<decltype(value(exhibit.measures.front()))> numbers;
    numbers.reserve(exhibit.measures.size());
    for (const StateMeasures& measures : exhibit.measures) numbers.push_back(value(measures));
    return numbers;
}

void add_states(ordered_json& data, const Exhibit& exhibit) {
    const std::size_t columns = 2 * exhibit.problem.asv_count();
    const PackedTable positions = exhibit.solution
                                      ? pack_table(flat(exhibit.solution->path.points()), columns)
                                      : PackedTable{};
    data["states"] = exhibit.measures.size();
    data["unit"] = positions.unit;
    data["positions"] = positions.text;
    const auto doubles = [&](const char* key, const auto& value) {
        data[key] = pack_doubles(column(exhibit, value));
    };
    const auto integers = [&](const char* key, const auto& value) {
        data[key] = pack_integers(column(
            exhibit, [&](const StateMeasures& m) { return static_cast<std::int32_t>(value(m)); }));
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

void add_verdict(ordered_json& data, const Exhibit& exhibit) {
    data["valid"] = exhibit.report.valid();
    data["verdict"] = verdict(exhibit);
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
             {"state", placed ? ordered_json(check.worst->state) : ordered_json(nullptr)}});
    }
    data["violations"] = ordered_json::array();
    const auto index = [](const std::optional<std::size_t>& i) {
        return i ? static_cast<std::int64_t>(*i) : -1;
    };
    for (const Violation& violation : exhibit.violations) {
        if (violation.check == core::Check::cost) continue;
        data["violations"].push_back(
            {{"check", core::name(violation.check)},
             {"state", violation.offender.state},
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
                         {"asvCount", problem.asv_count()},
                         {"bounds", {bounds.low.x, bounds.low.y, bounds.high.x, bounds.high.y}},
                         {"minimumArea", problem.requirements.min_area(problem.asv_count())},
                         {"totalCost", exhibit.solution ? exhibit.solution->cost : 0},
                         {"lowerBound", exhibit.lower_bound ? ordered_json(*exhibit.lower_bound)
                                                            : ordered_json(nullptr)},
                         {"start", flat(problem.start)},
                         {"goal", flat(problem.goal)}};
    // A large text is moved into its place; a list in braces would copy it.
    data["obstacles"] = pack(problem.obstacles);
    add_states(data, exhibit);
    add_verdict(data, exhibit);
    add_trees(data, exhibit);
    return data;
}

/// JSON that can stand in a script element: no "</script>" or "<!--" can come out of a name.
std::string embeddable(const ordered_json& data) {
    std::string text = data.dump(-1, ' ', true);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

}  // namespace

std::string make_player(const Exhibit& exhibit) {
    const std::string title = escape_markup(exhibit.name);
    const std::string data = embeddable(data_of(exhibit));
    std::string result;
    result.reserve(assets::page.size() + assets::style.size() + assets::script.size() +
                   data.size() + 2 * title.size());
    std::string_view rest = assets::page;
    while (!rest.empty()) {
        const std::size_t mark = std::min(rest.find('@'), rest.size());
        result += rest.substr(0, mark);
        rest.remove_prefix(mark);
        if (rest.empty()) break;
        const std::size_t end = rest.find('@', 1);
        const std::string_view key = rest.substr(1, end - 1);
        result += key == "TITLE"    ? std::string_view(title)
                  : key == "STYLE"  ? assets::style
                  : key == "SCRIPT" ? assets::script
                                    : std::string_view(data);
        rest.remove_prefix(end + 1);
    }
    return result;
}

}  // namespace asv::io
