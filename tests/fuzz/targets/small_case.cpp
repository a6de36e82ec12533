#include "tests/fuzz/targets/small_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <vector>

#include "core/solve/planner_catalogue.hpp"
#include "geometry/primitives.hpp"
#include "io/text/number_text.hpp"

namespace asv::fuzz {

namespace {

using geometry::Box;
using geometry::Point;

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double broom_length = 0.05;

/// Draws from the bytes, one byte each; zeros when they are used up.
class Draws {
  public:
    explicit Draws(std::string_view bytes) : bytes_(bytes) {}

    std::size_t below(std::size_t count) { return next() % count; }
    /// In [0, 1].
    double share() { return next() / 255.0; }
    double between(double low, double high) { return std::min(low + (high - low) * share(), high); }
    template <std::size_t count>
    double one_of(const double (&values)[count]) {
        return values[below(count)];
    }
    bool one_in(std::size_t count) { return below(count) == count - 1; }

  private:
    std::uint8_t next() {
        if (at_ >= bytes_.size()) return 0;
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
};

/// Writes numbers, which are in units of the unit square, in those of a field of `side`.
class ScenarioText {
  public:
    explicit ScenarioText(double side) : side_(side) {}

    ScenarioText& operator<<(std::string_view words) {
        text_ += words;
        return *this;
    }
    void length(double value) { io::append_number(text_, value * side_); }
    void number(double value) { io::append_number(text_, value); }
    void point(const Point& at) {
        text_ += '[';
        length(at.x);
        text_ += ", ";
        length(at.y);
        text_ += ']';
    }
    void box(const Box& at) {
        text_ += '[';
        point(at.low);
        text_ += ", ";
        point(at.high);
        text_ += ']';
    }
    /// "[a, b, c]", each written by `write`.
    template <class Values, class Write>
    void array(const Values& values, const Write& write) {
        text_ += '[';
        for (std::size_t i = 0; i < std::size(values); ++i) {
            if (i > 0) text_ += ", ";
            write(values[i]);
        }
        text_ += ']';
    }
    void points(const std::vector<Point>& values) {
        array(values, [&](const Point& at) { point(at); });
    }
    void numbers(const std::vector<double>& values) {
        array(values, [&](double value) { number(value); });
    }
    std::string take() { return std::move(text_); }

  private:
    double side_;
    std::string text_;
};

Point place(Draws& draws) {
    return {draws.between(0.05, 0.95), draws.between(0.05, 0.95)};
}

/// Turns to one side, none of them more than those of a closed ring.
std::vector<Point> chain(Draws& draws, std::size_t asv_count, double side_of_turns) {
    std::vector<Point> points{place(draws)};
    double heading = draws.between(0, full_turn);
    while (points.size() < asv_count) {
        points.push_back({points.back().x + broom_length * std::cos(heading),
                          points.back().y + broom_length * std::sin(heading)});
        heading += side_of_turns * draws.between(0.25, 1) * full_turn /
                   static_cast<double>(std::max<std::size_t>(asv_count, 2));
    }
    return points;
}

Box obstacle(Draws& draws, const Point& start) {
    constexpr double hardly[] = {0, 1e-9, 1e-6, 1e-5, 2e-5, 3e-5, 1e-3};
    switch (draws.below(4)) {
        case 0: {  // at the start
            const double apart = draws.one_of(hardly);
            const Point low{start.x + apart, start.y + apart};
            return {low, {low.x + draws.between(0, 0.2), low.y + draws.between(0, 0.2)}};
        }
        case 1: {  // a thin wall from below, perhaps through the whole field
            const Point low{draws.share(), -0.1};
            return {low, {low.x + draws.one_of(hardly), draws.between(0.2, 1.1)}};
        }
        default: {
            const Point low = place(draws);
            const double width = draws.share(), height = draws.share();
            return {low, {low.x + 0.3 * width * width, low.y + 0.3 * height * height}};
        }
    }
}

void write_chain(Draws& draws, ScenarioText& text, Point& start) {
    const std::size_t asv_count = 1 + draws.below(6);
    const double side_of_turns = draws.one_in(2) ? -1 : 1;
    const double side_at_goal = draws.one_in(16) ? -side_of_turns : side_of_turns;
    text << "{\"version\": 1, \"body\": {\"kind\": \"chain\", \"broom_length\": ";
    text.length(broom_length);
    text << ", \"minimum_area_factor\": ";
    text.length(0.007);
    const std::vector<Point> from = chain(draws, asv_count, side_of_turns);
    start = from[draws.below(asv_count)];
    text << "},\n \"start\": ";
    text.points(from);
    text << ",\n \"goal\": ";
    text.points(chain(draws, asv_count, side_at_goal));
}

void write_arm(Draws& draws, ScenarioText& text, Point& start) {
    const std::size_t links = 1 + draws.below(4);
    start = place(draws);
    text << "{\"version\": 1, \"body\": {\"kind\": \"arm\", \"base\": ";
    text.point(start);
    text << ", \"links\": ";
    text.array(std::vector<int>(links), [&](int) { text.length(draws.between(0.05, 0.25)); });
    text << (draws.one_in(2) ? ", \"angles\": \"absolute\"" : ", \"angles\": \"relative\"");
    const bool wraps = draws.one_in(2);
    const double low = -draws.between(0.1, full_turn), high = draws.between(0.1, full_turn);
    text << ", \"joints\": ";
    if (wraps)
        text << "\"wrap\"";
    else
        text.numbers({low, high});
    for (const std::string_view end : {"},\n \"start\": ", ",\n \"goal\": "}) {
        text << end;
        text.array(std::vector<int>(links), [&](int) { text.number(draws.between(low, high)); });
    }
}

void write_point(Draws& draws, ScenarioText& text, Point& start) {
    start = place(draws);
    text << "{\"version\": 1, \"body\": {\"kind\": \"point\"},\n \"start\": ";
    text.point(start);
    text << ",\n \"goal\": ";
    text.point(place(draws));
}

void write_world(Draws& draws, ScenarioText& text, const Point& start) {
    text << ",\n \"obstacles\": ";
    text.array(std::vector<int>(draws.below(6)), [&](int) { text.box(obstacle(draws, start)); });
    text << ",\n \"bounds\": ";
    switch (draws.below(4)) {
        case 0:
            text << "null";
            break;
        case 1:
            text.box({{0.05, 0}, {0.9, 1}});
            break;
        default:
            text.box({{0, 0}, {1, 1}});
            break;
    }
    text << ",\n \"step\": ";
    text.length(draws.one_of({0.001, 0.001, 0.002}));
    text << ", \"tolerance\": ";
    text.length(draws.one_of({1e-5, 1e-5, 1e-5, 1e-4, 1e-6, 0}));
    text << "}\n";
}

std::string scenario_text(Draws& draws) {
    ScenarioText text(draws.one_of({1, 1, 1, 20}));
    Point start;
    switch (draws.below(8)) {
        case 6:
            write_arm(draws, text, start);
            break;
        case 7:
            write_point(draws, text, start);
            break;
        default:
            write_chain(draws, text, start);
            break;
    }
    write_world(draws, text, start);
    return text.take();
}

/// A few settings, each its least value, another word, or some times its default.
void change_settings(Draws& draws, core::Planner& planner) {
    const std::vector<core::Setting> all = core::settings(planner);
    for (std::size_t i = draws.below(4); i > 0; --i) {
        const core::SettingValue& value = all[draws.below(all.size())].value;
        double given = value.low;
        if (!value.words.empty() || value.is_switch())
            given = static_cast<double>(draws.below(static_cast<std::size_t>(value.high) + 1));
        else if (!draws.one_in(8))
            given = value.get() * draws.one_of({0.25, 0.5, 2, 4});
        if (value.whole) given = std::floor(given);
        value.set(std::clamp(given, value.low, value.high));
    }
}

}  // namespace

SmallCase small_case(std::string_view bytes) {
    constexpr double without_end = 1e9;  // seconds
    Draws draws(bytes);
    SmallCase drawn;
    core::SolveOptions& options = drawn.options;
    const auto names = core::planner_names();
    options.planner = core::planner_named(names[draws.below(names.size())]);
    options.seed = draws.below(256);
    options.time_limit = without_end;
    options.max_iterations = 1 + 2 * draws.below(256);
    options.optimize = draws.one_of({0, 0, 0.001, 0.01});
    options.reverse = draws.one_in(2);
    options.keep_trees = draws.one_in(2);
    drawn.scenario = scenario_text(draws);
    change_settings(draws, options.planner);
    return drawn;
}

}  // namespace asv::fuzz
