#include "core/solve/planner_catalogue.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace asv::core {

namespace {

struct Entry {
    std::string_view name, summary, source;
    Planner planner;
};

/// In the order of the variant's alternatives.
const std::vector<Entry>& catalogue() {
    static const std::vector<Entry> entries{
        {"auto", "two trees that slide along what they meet and pull the ends of the chain",
         "own; RRT-Connect of Kuffner and LaValle 2000 with steps that keep the constraints near",
         AutoPlanner{}},
        {"rrt-connect",
         "bidirectional RRT for ASVs: stepwise and corridor sampling, angle enlargement, ladder; "
         "seven extensions",
         "Kuffner and LaValle 2000; reports on ASVs, and on seven extensions", RrtConnectPlanner{}},
        {"rrt", "one tree that grows by steps toward samples", "LaValle 1998", RrtPlanner{}},
        {"rrt-star", "one tree that is rewired for least cost until its nodes are spent",
         "Karaman and Frazzoli 2011", RrtStarPlanner{}},
        {"prm-grid", "roadmap over a regular grid", "Kavraki, Svestka, Latombe and Overmars 1996",
         PrmGridPlanner{}},
        {"prm-random", "roadmap over uniform random configurations",
         "Kavraki, Svestka, Latombe and Overmars 1996", PrmRandomPlanner{}},
        {"prm-gaussian", "roadmap over configurations near obstacles",
         "Boor, Overmars and van der Stappen 1999", PrmGaussianPlanner{}},
        {"prm-bridge", "roadmap over configurations in narrow places",
         "Hsu, Jiang, Reif and Sun 2003", PrmBridgePlanner{}},
    };
    return entries;
}

const Entry* find_entry(std::string_view name) {
    for (const Entry& entry : catalogue())
        if (entry.name == name) return &entry;
    return nullptr;
}

std::vector<Setting> settings_of(AutoPlanner& p) {
    return joined({settings_of(p.steering), settings_of(p.search)});
}

std::vector<Setting> settings_of(RrtConnectPlanner& p) {
    return joined({settings_of(p.space), settings_of(p.search), settings_of(p.single_steps),
                   settings_of(p.extensions), settings_of(p.sampler)});
}

std::vector<Setting> settings_of(RrtPlanner& p) {
    return joined({settings_of(p.search), settings_of(p.sampler)});
}

std::vector<Setting> settings_of(RrtStarPlanner& p) {
    return joined({settings_of(p.search), settings_of(p.sampler)});
}

std::vector<Setting> settings_of(PrmPlanner& p) {
    return joined({settings_of(p.search), settings_of(p.sampler)});
}

/// The names of the planners that have the setting: "rrt, rrt-star".
std::string planners_with(std::string_view setting) {
    std::string names;
    for (const Entry& entry : catalogue()) {
        Planner planner = entry.planner;
        const auto all = settings(planner);
        if (std::ranges::find(all, setting, &Setting::name) == all.end()) continue;
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    return names;
}

[[noreturn]] void unknown_setting(Planner& planner, std::string_view given) {
    std::ostringstream text;
    text << "planner " << name(planner) << " has no setting '" << given << "'; ";
    const std::string others = planners_with(given);
    if (!others.empty())
        text << others << (others.find(',') == std::string::npos ? " has; " : " have; ");
    text << name(planner) << " has:";
    for (const Setting& s : settings(planner))
        text << "\n  " << s.name << ": " << s.meaning << " (" << describe_range(s) << "; default "
             << describe_value(s) << ")";
    throw std::invalid_argument(text.str());
}

}  // namespace

std::vector<std::string_view> planner_names() {
    std::vector<std::string_view> names;
    for (const Entry& entry : catalogue()) names.push_back(entry.name);
    return names;
}

std::string_view planner_summary(std::string_view name) {
    const Entry* entry = find_entry(name);
    return entry ? entry->summary : std::string_view{};
}

std::string_view planner_source(std::string_view name) {
    const Entry* entry = find_entry(name);
    return entry ? entry->source : std::string_view{};
}

Planner planner_named(std::string_view name) {
    if (const Entry* entry = find_entry(name)) return entry->planner;
    std::string known;
    for (const Entry& entry : catalogue())
        known += (known.empty() ? "" : ", ") + std::string(entry.name);
    throw std::invalid_argument("there is no planner '" + std::string(name) +
                                "'; there are: " + known);
}

std::string_view name(const Planner& planner) {
    return catalogue()[planner.index()].name;
}

std::vector<Setting> settings(Planner& planner) {
    return std::visit([](auto& chosen) { return settings_of(chosen); }, planner);
}

const SamplerOptions* sampler_options(const Planner& planner) {
    return std::visit(
        [](const auto& chosen) -> const SamplerOptions* {
            if constexpr (requires { chosen.sampler; })
                return &chosen.sampler;
            else
                return nullptr;
        },
        planner);
}

void set(Planner& planner, std::string_view setting, std::string_view value) {
    for (const Setting& s : settings(planner))
        if (s.name == setting) return assign(s, value);
    unknown_setting(planner, setting);
}

void require_usable(const Planner& planner, BodyKind body) {
    if (const auto* connect = std::get_if<RrtConnectPlanner>(&planner))
        if (connect->search.orders.empty())
            throw std::invalid_argument(
                "rrt-connect needs at least one order of growing its trees");
    const SamplerOptions* sampler = sampler_options(planner);
    if (!sampler) return;
    const auto uses = [&](SamplerKind kind) {
        return sampler->kind == kind || (sampler->kind == SamplerKind::mix &&
                                         sampler->weights[static_cast<std::size_t>(kind)] > 0);
    };
    if (body != BodyKind::chain && (uses(SamplerKind::stepwise) || uses(SamplerKind::corridor)))
        throw std::invalid_argument("only a chain is sampled stepwise or in corridors");
    double total = 0;
    for (const double weight : sampler->weights) total += weight;
    if (sampler->kind == SamplerKind::mix && total == 0)
        throw std::invalid_argument("sampler mix needs a weight above 0, such as mix-uniform=1");
}

}  // namespace asv::core
