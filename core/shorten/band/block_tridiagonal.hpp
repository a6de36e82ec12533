#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace asv::core {

/// A symmetric positive definite matrix of square blocks on three diagonals, and its Cholesky
/// factorisation: what links the way points of a path, each to the next. Keeps its memory.
class BlockTridiagonal {
  public:
    /// All zero: `blocks` x `blocks` blocks of `size` x `size` numbers. Both at least 1.
    void reset(std::size_t blocks, std::size_t size);

    std::size_t blocks() const { return blocks_; }
    /// Block (i, i) and block (i, i + 1), column by column. Of the former, only the lower triangle
    /// counts.
    std::span<double> diagonal(std::size_t i) { return block(diagonal_, i); }
    std::span<double> upper(std::size_t i) { return block(upper_, i); }

    /// Solves for the vector in place and leaves the factors in the blocks; false, with nothing
    /// useful in either, when the matrix is not positive definite. O(blocks * size^3).
    /// Precondition: vector.size() == blocks * size.
    bool solve(std::span<double> vector);

  private:
    std::span<double> block(std::vector<double>& blocks, std::size_t i) {
        return {blocks.data() + i * size_ * size_, size_ * size_};
    }

    std::size_t blocks_ = 0, size_ = 0;
    std::vector<double> diagonal_, upper_;
};

}  // namespace asv::core
