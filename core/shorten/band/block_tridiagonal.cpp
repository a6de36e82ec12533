#include "core/shorten/band/block_tridiagonal.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace asv::core {

namespace {

Eigen::Map<Eigen::MatrixXd> matrix(std::span<double> block, Eigen::Index size) {
    return {block.data(), size, size};
}

}  // namespace

void BlockTridiagonal::reset(std::size_t blocks, std::size_t size) {
    blocks_ = blocks;
    size_ = size;
    diagonal_.assign(blocks * size * size, 0.0);
    upper_.assign(blocks * size * size, 0.0);
}

bool BlockTridiagonal::solve(std::span<double> vector) {
    const auto size = static_cast<Eigen::Index>(size_);
    const auto part = [&](std::size_t i) {
        return Eigen::Map<Eigen::VectorXd>(vector.data() + i * size_, size);
    };
    for (std::size_t i = 0; i < blocks_; ++i) {
        auto pivot = matrix(diagonal(i), size);
        if (i > 0) {
            const auto above = matrix(upper(i - 1), size);
            pivot.triangularView<Eigen::Lower>() -= above.transpose() * above;
            part(i).noalias() -= above.transpose() * part(i - 1);
        }
        Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(pivot);
        if (factor.info() != Eigen::Success) return false;
        const auto lower = pivot.triangularView<Eigen::Lower>();
        auto rest = part(i);
        lower.solveInPlace(rest);
        if (i + 1 < blocks_) {
            auto next = matrix(upper(i), size);
            lower.solveInPlace(next);
        }
    }
    for (std::size_t i = blocks_; i-- > 0;) {
        auto rest = part(i);
        if (i + 1 < blocks_) rest.noalias() -= matrix(upper(i), size) * part(i + 1);
        matrix(diagonal(i), size).triangularView<Eigen::Lower>().transpose().solveInPlace(rest);
    }
    return true;
}

}  // namespace asv::core
