// Linings and members that meet in a grid point: what joins them there (supports/lining.hpp), and what the
// user is told.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fdm_server/grid/grid.hpp"
#include "fdm_server/supports/supports.hpp"

namespace adit::fdm {

// UserError at the joint's field of the scene: at an end of a lining that nothing meets, or between two beams
// of a lining where another one, or a member, is joined to both. Plans as the scene lists them.
void require_clear_joints(std::span<const LiningPlan> linings, std::span<const LiningPlan> members,
                          const Grid& grid);

// "the linings `roof` and `wall` are joined rigidly at (1, 3) m", one for each set of linings and members;
// "member `prop` turns freely at (1, 3) m" where nothing holds the rotation of its end.
std::vector<std::string> notes_on_meetings(const Supports& supports, const Grid& grid);

}  // namespace adit::fdm
