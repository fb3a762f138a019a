// What contacts do in large strain beside what they do in small strain.
#include <algorithm>
#include <cmath>

#include "fdm_server/interfaces/contacts.hpp"
#include "protocol/errors.hpp"

namespace adit::fdm {

void Contacts::slide(std::uint32_t first, std::uint32_t count, bool of_first, Face guide,
                     std::span<const double> x, std::span<const double> y) {
  x_.assign(x.begin(), x.end());
  y_.assign(y.begin(), y.end());
  const std::vector<double> rest(x.size(), 0.0);
  for (std::uint32_t i = first; i < first + count; ++i) {
    Contact& contact = contacts_[i];
    const auto point = contact.points[of_first ? 0 : 1];
    contact.sliding = {static_cast<std::uint32_t>(guides_.size()), point, of_first ? 1.0 : -1.0, {}};
    if (const auto foot = guide.foot(point, std::nullopt, {x, y, rest, rest})) contact.side = foot->side;
  }
  guides_.push_back(std::move(guide));
}

bool Contacts::touches(const Contact& contact, const std::vector<bool>& chosen) const {
  if (chosen[contact.points[0]] || chosen[contact.points[1]]) return true;
  if (!contact.sliding) return false;
  const Face& guide = guides_[contact.sliding->guide];
  for (std::uint32_t side = 0; side < guide.size(); ++side)
    for (const auto point : guide.side(side))
      if (chosen[point]) return true;
  return false;
}

// A point that is stuck or slides follows the guide from its side; one that is open looks everywhere.
void Contacts::find_feet(const protocol::Step& step, std::span<const double> ux, std::span<const double> uy,
                         std::span<const double> vx, std::span<const double> vy) {
  const Face::Places places{x_, y_, ux, uy};
  for (Contact& contact : contacts_) {
    if (!contact.sliding || contact.length == 0) continue;
    const auto motion = [&] {
      return step.from_rest() ? std::array{0.0, 0.0} : moved(contact, step.dt, vx.data(), vy.data());
    };
    const auto before = motion();
    auto& [guide, point, sense, turned] = *contact.sliding;
    const bool open = contact.state.status == ContactStatus::kOpen;
    const auto foot = guides_[guide].foot(point, open ? std::nullopt : std::optional(contact.side), places);
    if (!foot) {
      release(contact);
      turned = {-before[0] / 2, -before[1] / 2};
      continue;
    }
    contact.side = foot->side;
    contact.xi = foot->xi;
    share(contact);
    contact.nx = foot->nx;
    contact.ny = foot->ny;
    const auto now = motion();
    turned = {(now[0] - before[0]) / 2, (now[1] - before[1]) / 2};
    // The stroke of this step ends at the present place and what lies ahead of it.
    if (open)
      contact.state.closure = std::max(contact.state.dilated, contact.preload + sense * foot->height -
                                                                  now[0] + contact.ahead[0] + turned[0]);
  }
}

void Contacts::share(Contact& contact) const {
  const auto& [guide, point, sense, turned] = *contact.sliding;
  const auto& [a, b] = guides_[guide].side(contact.side);
  contact.shares = {{{point, sense}, {a, -sense * (1 - contact.xi)}, {b, -sense * contact.xi}}};
  contact.share_count = 3;
}

void Contacts::exchange_feet(state::Archive& archive) {
  archive.members("contacts_feet", std::span(contacts_), &Contact::share_count, &Contact::side, &Contact::xi,
                  &Contact::nx, &Contact::ny, &Contact::preload);
  for (Contact& contact : contacts_) {
    if (!contact.sliding || contact.share_count == 0) continue;
    if (contact.side >= guides_[contact.sliding->guide].size())
      throw protocol::UserError("contacts_feet",
                                "is the state of another model: its interfaces have more sides");
    if (contact.share_count == 3) share(contact);
  }
}

void Contacts::release(Contact& contact) {
  if (contact.share_count == 0) return;
  dissipated_ += contact.length * fdm::strain_energy(contact.law, contact.state);
  contact.state.status = ContactStatus::kOpen;
  contact.state.parted = true;
  contact.state.shear = 0;
  contact.share_count = 0;
}

}  // namespace adit::fdm
