#pragma once

#include <vector>

#include "asv/core/problem.hpp"
#include "asv/geometry/primitives.hpp"
  #  include <asv/tools/command_line.hpp>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
