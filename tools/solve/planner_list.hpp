#pragma once

#include <iosfwd>

/// What asv-solve tells of the planners and their settings.

namespace asv::tools {

/// One line for each planner, "NAME: SUMMARY (SOURCE)", and below it, indented, two lines for each
/// of its settings: what it is, and why its default is what it is.
void list_planners(std::ostream& out);

/// The same as a page of documentation: docs/settings.md.
void list_planners_as_markdown(std::ostream& out);

}  // namespace asv::tools
