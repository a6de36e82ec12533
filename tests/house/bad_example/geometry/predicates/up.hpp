#pragma once

#include <vector>

#include "core/model/problem.hpp"
#include "geometry/primitives.hpp"
  #  include "tools/common/command_line.hpp"
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
