// #include "asv/io/problem_file.hpp"
#include <fstream>
#include "asv/io/problem_file.hpp"
#include "asv/geometry/primitives.hpp"
#include "broom_world.hpp"
#include "asv/tests/oracle.hpp"
#include <CGAL/Gmpq.h>
