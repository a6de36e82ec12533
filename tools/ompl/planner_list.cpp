#include "tools/ompl/planner_list.hpp"

#include <stdexcept>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

namespace asv::adaptor {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Maker = ob::PlannerPtr (*)(const ob::SpaceInformationPtr&);

template <class Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& information) {
    return std::make_shared<Planner>(information);
}

struct Entry {
    std::string_view name;
    Maker maker;
};

constexpr Entry entries[] = {{"ABITstar", make<og::ABITstar>},
                             {"BFMT", make<og::BFMT>},
                             {"BITstar", make<og::BITstar>},
                             {"BKPIECE1", make<og::BKPIECE1>},
                             {"BiEST", make<og::BiEST>},
                             {"BiTRRT", make<og::BiTRRT>},
                             {"EST", make<og::EST>},
                             {"FMT", make<og::FMT>},
                             {"InformedRRTstar", make<og::InformedRRTstar>},
                             {"KPIECE1", make<og::KPIECE1>},
                             {"LBKPIECE1", make<og::LBKPIECE1>},
                             {"LazyPRM", make<og::LazyPRM>},
                             {"LazyPRMstar", make<og::LazyPRMstar>},
                             {"LazyRRT", make<og::LazyRRT>},
                             {"PDST", make<og::PDST>},
                             {"PRM", make<og::PRM>},
                             {"PRMstar", make<og::PRMstar>},
                             {"RRT", make<og::RRT>},
                             {"RRTConnect", make<og::RRTConnect>},
                             {"RRTstar", make<og::RRTstar>},
                             {"SBL", make<og::SBL>},
                             {"STRIDE", make<og::STRIDE>},
                             {"TRRT", make<og::TRRT>}};

template <class Names>
std::string joined(const Names& names) {
    std::string text;
    for (const auto& name : names) text.append(text.empty() ? "" : ", ").append(name);
    return text;
}

}  // namespace

std::vector<std::string_view> ompl_planner_names() {
    std::vector<std::string_view> names;
    for (const Entry& entry : entries) names.push_back(entry.name);
    return names;
}

ob::PlannerPtr ompl_planner(std::string_view name, const ob::SpaceInformationPtr& information) {
    for (const Entry& entry : entries)
        if (entry.name == name) return entry.maker(information);
    throw std::invalid_argument("there is no planner '" + std::string(name) +
                                "' of OMPL here; there are " + joined(ompl_planner_names()));
}

void set_parameter(ob::Planner& planner, const std::string& name, const std::string& value) {
    ob::ParamSet& parameters = planner.params();
    if (!parameters.hasParam(name)) {
        std::vector<std::string> names;
        parameters.getParamNames(names);
        throw std::invalid_argument(planner.getName() + " has no parameter '" + name +
                                    "'; it has " + joined(names));
    }
    bool taken = false;
    try {
        taken = parameters.setParam(name, value);
    } catch (const std::runtime_error&) {
        // OMPL cannot read it as a number.
    }
    if (!taken)
        throw std::invalid_argument("OMPL does not take '" + value + "' for " + name + " of " +
                                    planner.getName() + "; it suggests " +
                                    parameters.getParam(name)->getRangeSuggestion());
}

ob::SpaceInformationPtr information_of_a_plane() {
    return std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2U));
}

}  // namespace asv::adaptor
