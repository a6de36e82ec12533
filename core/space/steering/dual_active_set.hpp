#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asv::core {

/// The point nearest to a wish in a polyhedron:
///
///     minimise |y - wish|^2 / 2 + sum of c_s (m_s)^2 / 2   subject to   g_r . y >= b_r
///
/// where the rows s with a compliance c_s > 0 are springs: they pull g_s . y toward b_s from both
/// sides with a force m_s. The dual method of Goldfarb and Idnani (1983), which starts at the wish
/// and adds violated rows one by one; the Hessian is the identity, so a Cholesky factor of the
/// active rows' Gram matrix is all that it keeps. Each step costs O(rows x dimension). Holds its
/// memory: nothing is allocated once it has grown to the sizes in use.
class DualActiveSet {
  public:
    /// Precondition: dimension > 0.
    explicit DualActiveSet(std::size_t dimension);

    void clear();
    /// A new last row g . y >= limit, or a spring if compliance > 0; fill in the returned gradient
    /// (dimension numbers, valid until the next call).
    std::span<double> add_row(double limit, double compliance = 0);
    /// Takes the last row back.
    void drop_row();
    std::size_t size() const { return limits_.size(); }
    double limit(std::size_t row) const { return limits_[row]; }
    void set_limit(std::size_t row, double limit) { limits_[row] = limit; }
    std::span<const double> row(std::size_t row) const {
        return {rows_.data() + row * dimension_, dimension_};
    }

    /// The nearest point. Where the rows contradict each other, or too many steps are needed, the
    /// last iterate, which meets the rows that are active.
    std::span<const double> solve(std::span<const double> wish);

    /// The same for the wish of the last solve() after set_limit(): begins with the rows that were
    /// active, of which most still are when the limits have changed a little.
    std::span<const double> solve_again();

    /// Does an inequality push in the last solution?
    bool pushed() const { return pushed_; }

  private:
    double gram(std::size_t a, std::size_t b) const;
    std::optional<std::size_t> strongest_pulling_row() const;
    std::span<const double> add_violated();
    void find_missing();
    double prepare_direction(std::size_t row);
    bool activate(std::size_t row);
    void deactivate(std::size_t position);
    void solve_active();
    void substitute_forward(std::vector<double>& values) const;
    void substitute_back(std::vector<double>& values) const;
    double& factor(std::size_t row, std::size_t column) { return factor_[row * stride_ + column]; }

    std::size_t dimension_;
    std::vector<double> rows_;  ///< size() x dimension
    std::vector<double> limits_, compliances_;
    std::vector<double> wish_, step_, change_;
    std::vector<double> missing_;  ///< what each row lacks at step_
    std::vector<double> multipliers_;
    std::vector<std::size_t> active_;
    std::vector<double> factor_;  ///< lower Cholesky factor of their Gram matrix, row by row
    std::size_t stride_ = 0;      ///< of its rows
    std::vector<double> forward_, direction_;
    bool pushed_ = false;
};

}  // namespace asv::core
