#include "adapters/lammps/decomposition/decomposition.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "adapters/lammps/decomposition/carrier.hpp"

namespace adit::lammps {
namespace {

std::unique_ptr<LAMMPS_NS::LAMMPS> quiet_lammps(MPI_Comm ranks) {
  std::vector<std::string> words{"lammps", "-screen", "none", "-log", "none", "-nocite"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()), arguments.data(), ranks);
}

}  // namespace

Decomposition::Decomposition(MPI_Comm ranks, const geometry::BoundingBox& box, double reach, double skin,
                             Part& part)
    : lammps_(quiet_lammps(ranks)), ranks_(ranks), part_(part) {
  Carrier::add_style(*lammps_);
  const auto tell = [this](const std::string& command) { lammps_->input->one(command); };
  for (const char* command : {"units si", "dimension 2", "boundary s s p", "atom_style atomic", "newton off",
                              "comm_style tiled", "processors * * 1"})
    tell(command);
  // Nothing sorts the particles: neighbours have near numbers from the start.
  tell("atom_modify map yes sort 0 0");
  tell(fmt::format("region box block {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", box.x_min - reach,
                   box.x_max + reach, box.y_min - reach, box.y_max + reach, -reach, reach));
  tell("create_box 1 box");
  tell("mass 1 1");
  tell(fmt::format("pair_style zero {:.17g}", reach));
  tell("pair_coeff * *");
  tell(fmt::format("neighbor {:.17g} bin", skin));
  tell("neigh_modify delay 0 every 1 check no");
  // Bonds are seen until they have stretched to twice their length.
  tell(fmt::format("comm_modify cutoff {:.17g}", 2 * reach + skin));
  tell(fmt::format("fix carrier all {}", Carrier::kStyle));
  carrier_ = static_cast<Carrier*>(lammps_->modify->fix[lammps_->modify->find_fix("carrier")]);
  carrier_->carry(part_);
}

Decomposition::~Decomposition() = default;

void Decomposition::add(std::uint32_t first, std::span<const double> particles) {
  const std::size_t count = particles.size() / Part::kColumns;
  std::vector<int> tags, types(count, 1);
  std::vector<double> x;
  for (std::size_t k = 0; k < count; ++k) {
    const double* const values = &particles[k * Part::kColumns];
    tags.push_back(static_cast<int>(first + k + 1));
    x.insert(x.end(), {values[0], values[1], 0.0});
  }
  const LAMMPS_NS::Atom& atom = *lammps_->atom;
  const auto before = static_cast<std::size_t>(atom.nlocal);
  lammps_create_atoms(lammps_.get(), static_cast<int>(count), tags.data(), types.data(), x.data(), nullptr,
                      nullptr, 0);
  const auto columns = part_.columns();
  for (auto i = before; i < static_cast<std::size_t>(atom.nlocal); ++i) {
    const std::size_t k = static_cast<std::size_t>(atom.tag[i]) - 1 - first;
    for (std::size_t c = 0; c < columns.size(); ++c) (*columns[c])[i] = particles[k * Part::kColumns + c];
  }
}

void Decomposition::balance() {
  lammps_->input->one("balance 1.0 rcb");
  lammps_->init();
  lammps_->atom->map_init();
  lammps_->atom->map_set();
  part_.own(static_cast<std::uint32_t>(lammps_->atom->nlocal));
}

void Decomposition::place() {
  const dem::Particles& p = part_.particles;
  for (std::uint32_t i = 0; i < part_.own(); ++i) {
    lammps_->atom->x[i][0] = p.x[i] + p.ux[i];
    lammps_->atom->x[i][1] = p.y[i] + p.uy[i];
  }
}

void Decomposition::renew() {
  const auto places = [this](double number) { return place_of(number); };
  LAMMPS_NS::LAMMPS& l = *lammps_;
  place();
  part_.open(static_cast<std::size_t>(l.atom->nmax), places);
  auto most = static_cast<std::uint64_t>(part_.most_pairs());
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_UINT64_T, MPI_MAX, ranks_);
  carrier_->make_room(most);
  l.domain->pbc();
  l.domain->reset_box();
  l.comm->setup();
  l.neighbor->setup_bins();
  l.comm->exchange();
  l.comm->borders();
  l.neighbor->build(1);
  Numbers numbers;
  for (int i = 0; i < l.atom->nlocal + l.atom->nghost; ++i)
    numbers.push_back(static_cast<std::uint32_t>(l.atom->tag[i] - 1));
  part_.close(std::move(numbers), static_cast<std::uint32_t>(l.atom->nlocal), places, near());
}

Part::Near Decomposition::near() const {
  Part::Near near;
  const LAMMPS_NS::NeighList& list = *lammps_->force->pair->list;
  for (int k = 0; k < list.inum; ++k) {
    const int i = list.ilist[k];
    for (int n = 0; n < list.numneigh[i]; ++n)
      near.push_back(
          {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(list.firstneigh[i][n] & NEIGHMASK)});
  }
  return near;
}

void Decomposition::show() {
  lammps_->comm->forward_comm_fix(carrier_);
}

std::uint32_t Decomposition::place_of(double number) const {
  const int place = lammps_->atom->map(static_cast<LAMMPS_NS::tagint>(number) + 1);
  return place < 0 ? std::numeric_limits<std::uint32_t>::max() : static_cast<std::uint32_t>(place);
}

}  // namespace adit::lammps
