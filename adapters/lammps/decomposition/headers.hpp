// The headers of LAMMPS. Those of Debian call fmt::make_args_checked of fmt 8 in templates, which fmt 9 does
// not have; none of these templates is used here.
#pragma once

#include <fmt/format.h>

namespace fmt {
template <class... Values>
format_args make_args_checked(...);
}  // namespace fmt

#include <lammps/atom.h>
#include <lammps/comm.h>
#include <lammps/domain.h>
#include <lammps/fix.h>
#include <lammps/force.h>
#include <lammps/input.h>
#include <lammps/lammps.h>
#include <lammps/library.h>
#include <lammps/modify.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
