#include "io/certificate/certificate_file.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/text/atomic_file.hpp"
#include "io/text/json/document.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

using Pointer = JsonDocument::Pointer;

class CertificateReader {
  public:
    CertificateReader(std::string_view text, const std::string& name) : document_(text, name) {}

    core::Certificate read() const {
        const Pointer root;
        document_.require_members(root, {"version", "problem", "reason", "proof"}, {});
        document_.integer(root / "version", certificate_version, certificate_version);
        return {problem(root / "problem"), proof(root / "proof")};
    }

  private:
    core::CertifiedProblem problem(const Pointer& at) const {
        document_.require_members(
            at, {"asv_count", "obstacle_count", "broom_length", "max_step", "tolerance", "digest"},
            {});
        return {count(at / "asv_count"),     count(at / "obstacle_count"),
                number(at / "broom_length"), number(at / "max_step"),
                number(at / "tolerance"),    document_.text(at / "digest")};
    }

    core::InfeasibilityProof proof(const Pointer& at) const {
        const std::string reason = document_.text(Pointer("/reason"));
        if (reason == "no_area") return area(at);
        if (reason == "opposite_orientation") return orientation(at);
        if (reason == "separated") return separation(at);
        if (reason == "corridor_too_low") return corridors(at);
        document_.fail(Pointer("/reason"),
                       "no_area, opposite_orientation, separated or corridor_too_low");
    }

    core::AreaProof area(const Pointer& at) const {
        document_.require_members(at, {"chain_length", "greatest_area", "required_area"}, {});
        return {number(at / "chain_length"), number(at / "greatest_area"),
                number(at / "required_area")};
    }

    core::OrientationProof orientation(const Pointer& at) const {
        document_.require_members(
            at, {"start_area", "goal_area", "greatest_change", "required_area"}, {});
        return {number(at / "start_area"), number(at / "goal_area"), number(at / "greatest_change"),
                number(at / "required_area")};
    }

    core::SeparationProof separation(const Pointer& at) const {
        document_.require_members(at, {"asv", "shrink", "obstacles", "seams"}, {});
        return {index(at / "asv"), number(at / "shrink"), indices(at / "obstacles"),
                list<core::ClosedSeam>(at / "seams")};
    }

    core::CorridorProof corridors(const Pointer& at) const {
        document_.require_members(at, {"shrink", "required_area", "obstacles", "corridors"}, {});
        return {number(at / "shrink"), number(at / "required_area"), indices(at / "obstacles"),
                list<core::ClosedCorridor>(at / "corridors")};
    }

    template <typename Part>
    std::vector<Part> list(const Pointer& at) const {
        std::vector<Part> parts(document_.array(at).size());
        for (std::size_t i = 0; i < parts.size(); ++i) read(at / i, parts[i]);
        return parts;
    }

    void read(const Pointer& at, core::ClosedSeam& seam) const {
        document_.require_members(at, {"walls", "upright", "gap", "width", "depth"}, {});
        const Pointer gap = at / "gap";
        if (document_.array(gap).size() != 4)
            document_.fail(gap, "an array of the four numbers low x, low y, high x, high y");
        seam = {walls(at),
                {{number(gap / 0), number(gap / 1)}, {number(gap / 2), number(gap / 3)}},
                number(at / "width"),
                number(at / "depth")};
    }

    void read(const Pointer& at, core::ClosedCorridor& corridor) const {
        document_.require_members(at, {"walls", "upright", "from", "to", "height", "greatest_area"},
                                  {});
        corridor = {walls(at), number(at / "from"), number(at / "to"), number(at / "height"),
                    number(at / "greatest_area")};
    }

    core::FacingWalls walls(const Pointer& at) const {
        const Pointer two = at / "walls";
        if (document_.array(two).size() != 2)
            document_.fail(two, "an array of two walls: obstacles, or null for the border");
        core::FacingWalls facing;
        for (std::size_t i = 0; i < 2; ++i)
            if (!document_.is_null(two / i)) facing.walls[i] = index(two / i);
        facing.upright = document_.boolean(at / "upright");
        return facing;
    }

    double number(const Pointer& at) const {
        return document_.number(at, -largest_number, largest_number);
    }

    std::size_t count(const Pointer& at) const {
        return static_cast<std::size_t>(document_.integer(at, 0, most));
    }

    /// From 0, of what counts from 1 in the file.
    std::size_t index(const Pointer& at) const {
        return static_cast<std::size_t>(document_.integer(at, 1, most)) - 1;
    }

    std::vector<std::size_t> indices(const Pointer& at) const {
        std::vector<std::size_t> indices(document_.array(at).size());
        for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = index(at / i);
        return indices;
    }

    /// More than any problem has of anything.
    static constexpr std::int64_t most = 1'000'000'000;

    JsonDocument document_;
};

}  // namespace

void write_certificate(const std::filesystem::path& file, const core::Certificate& certificate) {
    write_file(file, format_certificate(certificate));
}

core::Certificate parse_certificate(std::string_view text, const std::string& name) {
    return CertificateReader(text, name).read();
}

core::Certificate read_certificate(const std::filesystem::path& file) {
    return parse_certificate(read_file(file), input_name(file));
}

}  // namespace asv::io
