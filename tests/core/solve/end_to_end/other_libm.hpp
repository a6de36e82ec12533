#pragma once

namespace asv::test {

/// As long as one lives, the functions of <cmath> that C libraries round differently (sine, power,
/// hypot and the like, of double) give the number above the right one. Only in a program that
/// other_libm.cpp is linked to, and for one thread.
struct OtherLibm {
    OtherLibm();
    ~OtherLibm();
    OtherLibm(const OtherLibm&) = delete;
    OtherLibm& operator=(const OtherLibm&) = delete;
};

}  // namespace asv::test
