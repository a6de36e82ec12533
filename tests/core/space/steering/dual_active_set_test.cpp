#include "core/space/steering/dual_active_set.hpp"

#include <cmath>
#include <optional>

#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Row;

struct Constraint {
    Row gradient;
    double limit;
    double compliance = 0;
};

struct Program {
    Row wish;
    std::vector<Constraint> rows;
};

double dot(const Row& a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Solves the square system by Gaussian elimination; nothing when it is nearly singular.
std::optional<Row> solve_square(std::vector<Row> a, Row b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        if (std::abs(a[pivot][k]) < 1e-9) return std::nullopt;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = 0; k < n; ++k) b[k] /= a[k][k];
    return b;
}

/// The optimum if these rows (and all springs) are the active ones: the unknowns are the point and
/// their multipliers. Nothing when that violates a row or needs one that pulls.
std::optional<Row> optimum_of(const Program& program, const std::vector<std::size_t>& active) {
    const std::size_t d = program.wish.size(), size = d + active.size();
    std::vector<Row> a(size, Row(size, 0.0));
    Row b(size, 0.0);
    for (std::size_t i = 0; i < d; ++i) {
        a[i][i] = 1;
        b[i] = program.wish[i];
    }
    for (std::size_t r = 0; r < active.size(); ++r) {
        const Constraint& row = program.rows[active[r]];
        for (std::size_t i = 0; i < d; ++i) {
            a[i][d + r] = -row.gradient[i];
            a[d + r][i] = row.gradient[i];
        }
        a[d + r][d + r] = row.compliance;
        b[d + r] = row.limit;
    }
    const auto solution = solve_square(a, b);
    if (!solution) return std::nullopt;
    for (std::size_t r = 0; r < active.size(); ++r)
        if (program.rows[active[r]].compliance == 0 && (*solution)[d + r] < -1e-9)
            return std::nullopt;
    const Row point(solution->begin(), solution->begin() + static_cast<std::ptrdiff_t>(d));
    for (const Constraint& row : program.rows)
        if (row.compliance == 0 && dot(row.gradient, point) < row.limit - 1e-9) return std::nullopt;
    return point;
}

/// Tries every set of active rows.
std::optional<Row> brute_force(const Program& program) {
    for (std::size_t set = 0; set < std::size_t{1} << program.rows.size(); ++set) {
        std::vector<std::size_t> active;
        bool springs = true;
        for (std::size_t r = 0; r < program.rows.size(); ++r) {
            const bool in = (set >> r & 1) != 0;
            if (in) active.push_back(r);
            springs = springs && (in || program.rows[r].compliance == 0);
        }
        if (!springs || active.size() > program.wish.size() + 2) continue;
        if (const auto point = optimum_of(program, active)) return point;
    }
    return std::nullopt;
}

DualActiveSet solver_of(const Program& program) {
    DualActiveSet solver(program.wish.size());
    for (const Constraint& row : program.rows) {
        const auto gradient = solver.add_row(row.limit, row.compliance);
        std::copy(row.gradient.begin(), row.gradient.end(), gradient.begin());
    }
    return solver;
}

Row solve(const Program& program, bool* pushed = nullptr) {
    DualActiveSet solver = solver_of(program);
    const auto point = solver.solve(program.wish);
    if (pushed != nullptr) *pushed = solver.pushed();
    return {point.begin(), point.end()};
}

Row random_row(Rng& rng, std::size_t dimension) {
    Row row(dimension);
    for (double& value : row) value = rng.normal();
    return row;
}

/// Configurations that some point meets; some of them parallel, or the same.
Program feasible_program(Rng& rng) {
    const std::size_t d = 1 + rng.below(5);
    Program program{random_row(rng, d), {}};
    const Row inside = random_row(rng, d);
    const std::size_t count = rng.below(8);
    for (std::size_t r = 0; r < count; ++r) {
        Constraint row{random_row(rng, d), 0};
        if (r > 0 && rng.chance(0.2)) row.gradient = program.rows[rng.below(r)].gradient;
        row.limit = dot(row.gradient, inside) - (rng.chance(0.2) ? 0 : rng.uniform(0, 2));
        program.rows.push_back(std::move(row));
    }
    return program;
}

void expect_near(std::span<const double> found, const Program& program) {
    const auto expected = brute_force(program);
    ASSERT_TRUE(expected);
    double wish = 0;
    for (const double w : program.wish) wish += w * w;
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], (*expected)[i], 2e-5 * (1 + std::sqrt(wish)));
}

void expect_optimum(const Program& program) {
    expect_near(solve(program), program);
}

TEST(DualActiveSet, AgreesWithBruteForce) {
    for_seeds(test::scaled(3000), [](Rng& rng) { expect_optimum(feasible_program(rng)); });
}

TEST(DualActiveSet, SpringsAgreeWithBruteForce) {
    for_seeds(test::scaled(3000), [](Rng& rng) {
        Program program = feasible_program(rng);
        for (std::size_t springs = 1 + rng.below(2); springs > 0; --springs)
            program.rows.push_back({random_row(rng, program.wish.size()), rng.normal(),
                                    std::pow(10, rng.uniform(-2, 1))});
        expect_optimum(program);
    });
}

TEST(DualActiveSet, BeginsAgainWhereTheLimitsHaveChanged) {
    for_seeds(test::scaled(3000), [](Rng& rng) {
        Program program = feasible_program(rng);
        if (rng.chance(0.5))
            program.rows.push_back({random_row(rng, program.wish.size()), rng.normal(), 0.5});
        DualActiveSet solver = solver_of(program);
        solver.solve(program.wish);
        for (int change = 0; change < 3; ++change) {
            // Lower limits only: a point that met the rows still does.
            for (std::size_t r = 0; r < program.rows.size(); ++r) {
                if (rng.chance(0.5)) continue;
                program.rows[r].limit -= rng.chance(0.5) ? rng.uniform(0, 0.1) : rng.uniform(0, 2);
                solver.set_limit(r, program.rows[r].limit);
            }
            expect_near(solver.solve_again(), program);
        }
    });
}

TEST(DualActiveSet, TellsWhetherARowPushes) {
    bool pushed = true;
    EXPECT_EQ(solve({{1, 0}, {{{1, 0}, 0.5}}}, &pushed), (Row{1, 0}));
    EXPECT_FALSE(pushed);
    EXPECT_EQ(solve({{1, 0}, {{{1, 0}, 2}}}, &pushed), (Row{2, 0}));
    EXPECT_TRUE(pushed);
    // A spring alone is no push: halfway, as it is as stiff as the wish.
    EXPECT_EQ(solve({{1, 0}, {{{1, 0}, 2, 1}}}, &pushed), (Row{1.5, 0}));
    EXPECT_FALSE(pushed);
}

TEST(DualActiveSet, ContradictingRowsEndInAFinitePoint) {
    for_seeds(test::scaled(2000), [](Rng& rng) {
        Program program = feasible_program(rng);
        const Row gradient = random_row(rng, program.wish.size());
        Row opposite(gradient);
        for (double& value : opposite) value *= -rng.uniform(0.5, 2);
        program.rows.push_back({gradient, rng.uniform(0.1, 1)});
        program.rows.push_back({opposite, rng.uniform(0.1, 1)});
        for (const double value : solve(program)) ASSERT_TRUE(std::isfinite(value));
    });
}

TEST(DualActiveSet, RowsCanBeTakenBackAndChanged) {
    DualActiveSet solver(2);
    const auto add = [&](double x, double y, double limit) {
        const auto row = solver.add_row(limit);
        row[0] = x;
        row[1] = y;
    };
    add(1, 0, 2);
    add(0, 1, 5);
    solver.drop_row();
    const auto solved = [&] {
        const auto point = solver.solve(Row{0, 0});
        return Row(point.begin(), point.end());
    };
    EXPECT_EQ(solver.size(), 1U);
    EXPECT_EQ(solved(), (Row{2, 0}));
    solver.set_limit(0, 3);
    EXPECT_EQ(solved(), (Row{3, 0}));
    solver.clear();
    EXPECT_EQ(solved(), (Row{0, 0}));
}

}  // namespace
}  // namespace asv::core
