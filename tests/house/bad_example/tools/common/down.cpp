#include <iostream>

#include "core/model/problem.hpp"
#include "tools/common/command_line.hpp"
