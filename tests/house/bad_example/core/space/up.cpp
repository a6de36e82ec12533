// #include "io/problem/problem_file.hpp"
#include <fstream>
#include "io/problem/problem_file.hpp"
#include "core/shorten/improve.hpp"
#include "chain_world.hpp"
#include <CGAL/Gmpq.h>
