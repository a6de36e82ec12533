#include <array>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "io/certificate/certificate_file.hpp"

namespace asv::io {

namespace {

using nlohmann::ordered_json;

ordered_json numbers_from_one(const std::vector<std::size_t>& indices) {
    ordered_json numbers = ordered_json::array();
    for (const std::size_t index : indices) numbers.push_back(index + 1);
    return numbers;
}

ordered_json to_json(const core::FacingWalls& facing) {
    ordered_json walls = ordered_json::array();
    for (const auto& wall : facing.walls)
        walls.push_back(wall ? ordered_json(*wall + 1) : ordered_json(nullptr));
    return {{"walls", std::move(walls)}, {"upright", facing.upright}};
}

ordered_json to_json(const core::ClosedSeam& seam) {
    ordered_json object = to_json(seam.between);
    object["gap"] = {seam.gap.low.x, seam.gap.low.y, seam.gap.high.x, seam.gap.high.y};
    object["width"] = seam.width;
    object["depth"] = seam.depth;
    return object;
}

ordered_json to_json(const core::ClosedCorridor& corridor) {
    ordered_json object = to_json(corridor.between);
    object["from"] = corridor.from;
    object["to"] = corridor.to;
    object["height"] = corridor.height;
    object["greatest_area"] = corridor.greatest_area;
    return object;
}

template <typename Part>
ordered_json list_of(const std::vector<Part>& parts) {
    ordered_json list = ordered_json::array();
    for (const Part& part : parts) list.push_back(to_json(part));
    return list;
}

/// The name of a reason and its proof.
using Named = std::pair<const char*, ordered_json>;

Named named(const core::AreaProof& proof) {
    return {"no_area",
            {{"chain_length", proof.chain_length},
             {"greatest_area", proof.greatest_area},
             {"required_area", proof.required_area}}};
}

Named named(const core::OrientationProof& proof) {
    return {"opposite_orientation",
            {{"start_area", proof.start_area},
             {"goal_area", proof.goal_area},
             {"greatest_change", proof.greatest_change},
             {"required_area", proof.required_area}}};
}

Named named(const core::SeparationProof& proof) {
    return {"separated",
            {{"asv", proof.asv + 1},
             {"shrink", proof.shrink},
             {"obstacles", numbers_from_one(proof.obstacles)},
             {"seams", list_of(proof.seams)}}};
}

Named named(const core::CorridorProof& proof) {
    return {"corridor_too_low",
            {{"shrink", proof.shrink},
             {"required_area", proof.required_area},
             {"obstacles", numbers_from_one(proof.obstacles)},
             {"corridors", list_of(proof.corridors)}}};
}

}  // namespace

std::string format_certificate(const core::Certificate& certificate) {
    const core::CertifiedProblem& problem = certificate.problem;
    const auto [reason, proof] =
        std::visit([](const auto& one) { return named(one); }, certificate.proof);
    const ordered_json root = {{"version", certificate_version},
                               {"problem",
                                {{"asv_count", problem.asv_count},
                                 {"obstacle_count", problem.obstacle_count},
                                 {"broom_length", problem.broom_length},
                                 {"max_step", problem.max_step},
                                 {"tolerance", problem.tolerance},
                                 {"digest", problem.digest}}},
                               {"reason", reason},
                               {"proof", proof}};
    // A line for each member, that people find their way.
    std::string text;
    for (const auto& [name, value] : root.items())
        text += (text.empty() ? "{\"" : ",\n \"") + name + "\": " + value.dump();
    return text + "}\n";
}

}  // namespace asv::io
