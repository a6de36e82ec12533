#include <fstream>

#include "asv/core/problem.hpp"
#include "asv/tools/command_line.hpp"
