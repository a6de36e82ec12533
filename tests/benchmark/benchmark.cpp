#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "geometry/simd/instruction_set.hpp"
#include "tests/benchmark/scene.hpp"
#include "tests/kit/batch/batch_worlds.hpp"

/// State checks per second (kinematics, bounds, turns, closing turns, area, collision) on valid
/// states, so that no check ends early: the SIMD kernels beside a scalar loop, CGAL and
/// Boost.Geometry. Checks of valid lines: proofs beside a scalar loop in steps of 0.001. After the
/// measurements, a table of the ratios of this same run. --simd=AVX2 or another of Highway's names
/// forces the kernels onto one instruction set.

namespace {

using namespace asv::geometry;
using namespace asv::geometry::benchmark_scene;

using Make = std::unique_ptr<Contender> (*)(const Scene&);

struct Case {
    std::string world;
    std::size_t points, boxes;

    std::string name() const {
        return world + "/n:" + std::to_string(points) + "/m:" + std::to_string(boxes);
    }
};

/// The scene of a case; only the last one is kept, as a million boxes are large.
const Scene& scene_of(const Case& wanted) {
    static std::string name;
    static std::unique_ptr<Scene> scene;
    if (name != wanted.name()) {
        asv::test::Random random(1);
        auto boxes = wanted.world == "map" ? asv::test::grid_map(wanted.boxes, random)
                                           : asv::test::dust(wanted.boxes, random);
        scene = std::make_unique<Scene>(wanted.points, std::move(boxes), 2048);
        name = wanted.name();
    }
    return *scene;
}

/// One way to answer one kind of question.
struct Entry {
    const char* who;
    const char* question;  ///< "states" or "lines"
    Make make;
    bool looks_at_all_boxes;
};

constexpr Entry entries[] = {
    {"kernel", "states", make_kernel, false},     {"scalar", "states", make_scalar, true},
    {"cgal", "states", make_cgal, true},          {"boost", "states", make_boost, true},
    {"kernel", "lines", make_line_kernel, false}, {"scalar", "lines", make_line_scalar, true}};

void run(benchmark::State& state, const Case& wanted, const Entry& entry) {
    const Scene& scene = scene_of(wanted);
    const std::unique_ptr<Contender> contender = entry.make(scene);
    const bool lines = std::string(entry.question) == "lines";
    const std::size_t available = lines ? scene.lines.size() : scene.chains.size();
    // Those who look at every box would need minutes for all questions among a million.
    const std::size_t affordable = 30'000'000 / (wanted.boxes * wanted.points * (lines ? 100 : 1));
    const std::size_t most = entry.looks_at_all_boxes ? affordable / 8 * 8 : available;
    const std::size_t count = std::min(std::max<std::size_t>(most, 8), available);
    if (count == 0 || contender->count_valid(count) != count) {
        state.SkipWithError(count == 0 ? "no valid ones in this world" : "not all are found valid");
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(contender->count_valid(count));
    const auto checks = static_cast<double>(state.iterations()) * static_cast<double>(count);
    state.counters["checks/s"] = benchmark::Counter(checks, benchmark::Counter::kIsRate);
}

/// Prints as usual and remembers the rates for the table at the end.
class RatioReporter : public benchmark::ConsoleReporter {
  public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.error_occurred) continue;
            const std::string name = run.benchmark_name();
            const std::size_t cut = name.find('/');
            double& rate = rates_[name.substr(cut + 1)][name.substr(0, cut)];
            rate = std::max(rate, run.counters.at("checks/s").value);
        }
    }

    void Finalize() override {
        std::printf("\n%-28s %12s %12s %10s %10s %10s\n", "checks", "kernel/s", "ns/check",
                    "x scalar", "x CGAL", "x Boost");
        for (const auto& [name, rates] : rates_) {
            const auto rate = [&known = rates](const char* who) {
                const auto found = known.find(who);
                return found == known.end() ? 0 : found->second;
            };
            const double kernel = rate("kernel");
            std::printf("%-28s %12.4g %12.1f", name.c_str(), kernel, 1e9 / kernel);
            for (const char* who : {"scalar", "cgal", "boost"}) {
                if (rate(who) > 0) std::printf(" %10.3g", kernel / rate(who));
            }
            std::printf("\n");
        }
    }

  private:
    std::map<std::string, std::map<std::string, double>> rates_;
};

void register_case(const Case& wanted) {
    for (const Entry& entry : entries) {
        const std::string question = entry.question;
        // A hundred scalar checks among a million boxes each: nobody waits for that.
        if (question == "lines" && wanted.boxes > 10'000 && entry.looks_at_all_boxes) continue;
        const std::string name = std::string(entry.who) + "/" + question + "/" + wanted.name();
        benchmark::RegisterBenchmark(name.c_str(), [wanted, &entry](auto& state) {
            run(state, wanted, entry);
        })->Unit(benchmark::kMicrosecond);
    }
}

/// Takes --simd=NAME out of the arguments and obeys it; false when it cannot.
bool choose_instruction_set(int& argc, char** argv) {
    const std::string option = "--simd=";
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (!argument.starts_with(option)) continue;
        try {
            simd::use_instruction_set(argument.substr(option.size()));
        } catch (const std::invalid_argument& error) {
            std::fprintf(stderr, "%s\n", error.what());
            return false;
        }
        std::copy(argv + i + 1, argv + argc + 1, argv + i);
        --argc;
        break;
    }
    std::printf("kernels on %s\n", simd::instruction_set().c_str());
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (!choose_instruction_set(argc, argv)) return 2;
    for (const std::size_t points : {3U, 7U, 15U, 25U}) {
        for (const std::size_t boxes : {2U, 7U, 100U, 10'000U, 1'000'000U}) {
            register_case({"dust", points, boxes});
            if (boxes >= 100) register_case({"map", points, boxes});
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return 0;
}
