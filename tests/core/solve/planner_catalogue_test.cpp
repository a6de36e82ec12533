#include "core/solve/planner_catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/kit/files/error_message.hpp"

namespace asv::core {
namespace {

/// What the call's std::invalid_argument says.
template <class Call>
std::string refusal(Call&& call) {
    return test::error_message<std::invalid_argument>(call);
}

/// The value as the setting takes it.
std::string text(double value, const Setting* setting = nullptr) {
    if (setting && !setting->value.words.empty())
        return setting->value.words[static_cast<std::size_t>(value)];
    std::ostringstream out;
    out.precision(17);
    out << value;
    return out.str();
}

/// Calls body(planner, setting) for all settings of all planners.
template <class Body>
void for_settings(Body&& body) {
    for (const auto planner_name : planner_names()) {
        Planner planner = planner_named(planner_name);
        const auto all = settings(planner);
        ASSERT_FALSE(all.empty());
        for (const Setting& setting : all) {
            SCOPED_TRACE(std::string(planner_name) + " " + setting.name);
            body(planner, setting);
        }
    }
}

double value_of(Planner& planner, const std::string& setting) {
    for (const Setting& s : settings(planner))
        if (s.name == setting) return s.value.get();
    ADD_FAILURE() << "no setting " << setting;
    return 0;
}

TEST(Planners, AreKnownByTheirNames) {
    const auto names = planner_names();
    EXPECT_EQ(names.front(), "auto");
    EXPECT_EQ(std::count(names.begin(), names.end(), "rrt-connect"), 1);
    for (const auto planner : names) {
        EXPECT_EQ(name(planner_named(planner)), planner);
        EXPECT_FALSE(planner_summary(planner).empty());
        EXPECT_FALSE(planner_source(planner).empty());
    }
}

TEST(Planners, AnUnknownNameIsToldWhatThereIs) {
    const std::string message = refusal([] { planner_named("teleport"); });
    EXPECT_NE(message.find("teleport"), std::string::npos);
    for (const auto planner : planner_names())
        EXPECT_NE(message.find(planner), std::string::npos) << planner;
}

TEST(Settings, AreDescribedAndDefaultWithinTheirRange) {
    for (const auto planner_name : planner_names()) {
        Planner planner = planner_named(planner_name);
        std::set<std::string> seen;
        for (const Setting& setting : settings(planner)) {
            EXPECT_TRUE(seen.insert(setting.name).second) << setting.name << " twice";
            EXPECT_FALSE(setting.meaning.empty()) << setting.name;
            EXPECT_FALSE(setting.why.empty()) << setting.name;
            EXPECT_FALSE(setting.source.empty()) << setting.name;
            EXPECT_LT(setting.value.low, setting.value.high) << setting.name;
        }
    }
    for_settings([](Planner&, const Setting& setting) {
        EXPECT_GE(setting.value.get(), setting.value.low);
        EXPECT_LE(setting.value.get(), setting.value.high);
    });
}

TEST(Settings, TakeEveryValueOfTheirRange) {
    for_settings([](Planner& planner, const Setting& setting) {
        const double middle = 0.5 * (setting.value.low + setting.value.high);
        for (const double value :
             {setting.value.low, setting.value.whole ? std::floor(middle) : middle,
              setting.value.high}) {
            set(planner, setting.name, text(value, &setting));
            EXPECT_EQ(setting.value.get(), value);
            EXPECT_EQ(value_of(planner, setting.name), value);
        }
    });
}

TEST(Settings, EachSetsItselfAlone) {
    for_settings([](Planner& given, const Setting& setting) {
        Planner planner = planner_named(name(given)), untouched = planner;
        const double other =
            setting.value.get() == setting.value.low ? setting.value.high : setting.value.low;
        set(planner, setting.name, text(other, &setting));
        for (const Setting& s : settings(planner)) {
            if (s.name != setting.name) {
                EXPECT_EQ(s.value.get(), value_of(untouched, s.name)) << s.name;
            }
        }
    });
}

TEST(Settings, RefuseWhatIsOutsideOrNoNumber) {
    for_settings([](Planner& planner, const Setting& setting) {
        const double before = setting.value.get();
        std::vector<std::string> bad{text(setting.value.low - 1),
                                     text(setting.value.high + 1),
                                     "nan",
                                     "inf",
                                     "-inf",
                                     "",
                                     "x",
                                     "1x",
                                     " 1",
                                     "0x1",
                                     "1e999"};
        if (setting.value.whole) bad.push_back(text(setting.value.low + 0.5));
        for (const std::string& value : bad) {
            const std::string message = refusal([&] { set(planner, setting.name, value); });
            EXPECT_NE(message.find(setting.name), std::string::npos) << message;
            EXPECT_NE(message.find("'" + value + "'"), std::string::npos) << message;
            EXPECT_NE(message.find(describe_range(setting)), std::string::npos) << message;
        }
        EXPECT_EQ(setting.value.get(), before);
    });
}

TEST(Settings, SwitchesAreOnOrOff) {
    Planner planner = planner_named("auto");
    for (const auto& [value, expected] : {std::pair{"off", 0.0},
                                          {"on", 1.0},
                                          {"false", 0.0},
                                          {"true", 1.0},
                                          {"0", 0.0},
                                          {"1", 1.0}}) {
        set(planner, "slide", value);
        EXPECT_EQ(value_of(planner, "slide"), expected) << value;
    }
}

TEST(Settings, AnUnknownNameIsToldWhatThereIs) {
    for (const auto planner_name : planner_names()) {
        Planner planner = planner_named(planner_name);
        const std::string message = refusal([&] { set(planner, "warp", "9"); });
        EXPECT_NE(message.find("'warp'"), std::string::npos);
        for (const Setting& setting : settings(planner)) {
            EXPECT_NE(message.find(setting.name + ":"), std::string::npos) << setting.name;
            EXPECT_NE(message.find(setting.meaning), std::string::npos) << setting.name;
            EXPECT_NE(message.find(describe_range(setting)), std::string::npos) << setting.name;
        }
    }
}

TEST(Settings, AnUnknownNameIsToldWhichPlannersHaveIt) {
    const auto refused = [](std::string_view planner_name, std::string_view setting) {
        Planner planner = planner_named(planner_name);
        const std::string message = refusal([&] { set(planner, setting, "1"); });
        return message.substr(0, message.find('\n'));
    };
    EXPECT_EQ(refused("auto", "ladder"),
              "planner auto has no setting 'ladder'; rrt-connect has; auto has:");
    EXPECT_EQ(refused("rrt-connect", "radius"),
              "planner rrt-connect has no setting 'radius'; rrt-star, prm-grid, prm-random, "
              "prm-gaussian, prm-bridge have; rrt-connect has:");
    EXPECT_EQ(refused("rrt", "warp"), "planner rrt has no setting 'warp'; rrt has:");
}

TEST(Settings, OnAndOffAreNoNumbers) {
    Planner planner = planner_named("auto");
    for (const auto* value : {"true", "on", "false", "off"})
        EXPECT_NE(refusal([&] { set(planner, "slide-steps", value); }).find("a whole number"),
                  std::string::npos);
}

TEST(Settings, WordsAreTakenByName) {
    Planner planner = planner_named("prm-random");
    for (const auto* word : {"gaussian", "mix", "own"}) {
        set(planner, "sampler", word);
        const auto all = settings(planner);
        EXPECT_EQ(describe_value(*std::ranges::find(all, "sampler", &Setting::name)), word);
    }
    for (const auto* no_word : {"Gaussian", "gauss", "1", "on"})
        EXPECT_NE(refusal([&] { set(planner, "sampler", no_word); }).find("one of own, uniform"),
                  std::string::npos);
}

TEST(Planners, RoadmapsAreNamedAfterTheirSamplers) {
    for (const auto& [name, sampler] : {std::pair{"prm-grid", SamplerKind::grid},
                                        {"prm-random", SamplerKind::uniform},
                                        {"prm-gaussian", SamplerKind::gaussian},
                                        {"prm-bridge", SamplerKind::bridge}}) {
        const auto of = [](const auto& planner) -> const SamplerOptions* {
            if constexpr (requires { planner.sampler; }) return &planner.sampler;
            return nullptr;
        };
        const Planner planner = planner_named(name);
        EXPECT_EQ(std::visit(of, planner)->kind, sampler);
    }
}

TEST(Planners, SamplersHaveToSuitTheBody) {
    Planner planner = planner_named("rrt");
    set(planner, "sampler", "stepwise");
    EXPECT_NO_THROW(require_usable(planner, BodyKind::chain));
    EXPECT_THROW(require_usable(planner, BodyKind::arm), std::invalid_argument);
    set(planner, "sampler", "mix");
    EXPECT_THROW(require_usable(planner, BodyKind::chain), std::invalid_argument);
    set(planner, "mix-uniform", "2");
    EXPECT_NO_THROW(require_usable(planner, BodyKind::arm));
    set(planner, "mix-corridor", "1");
    EXPECT_THROW(require_usable(planner, BodyKind::point), std::invalid_argument);
}

TEST(Planners, RrtConnectNeedsAnOrder) {
    Planner planner = planner_named("rrt-connect");
    EXPECT_NO_THROW(require_usable(planner, BodyKind::chain));
    for (const auto* order : {"order-both", "order-start", "order-goal"})
        set(planner, order, "off");
    EXPECT_THROW(require_usable(planner, BodyKind::chain), std::invalid_argument);
    set(planner, "order-goal", "on");
    EXPECT_NO_THROW(require_usable(planner, BodyKind::chain));
}

}  // namespace
}  // namespace asv::core
