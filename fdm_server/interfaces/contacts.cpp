#include "fdm_server/interfaces/contacts.hpp"

#include <algorithm>
#include <cmath>

namespace adit::fdm {

std::uint32_t Contacts::add(const std::array<std::uint32_t, 2>& points, std::span<const Half> halves,
                            const ContactLaw& law, std::uint32_t stage) {
  contacts_.push_back({points, {halves.begin(), halves.end()}, 0, 0, 0, law, stage, {}});
  contacts_.back().shares = {{{points[0], 1}, {points[1], -1}}};
  return static_cast<std::uint32_t>(contacts_.size() - 1);
}

void Contacts::install(std::uint32_t stage, const std::vector<bool>& gone) {
  const auto is_gone = [&](std::uint32_t zone) { return zone != kNoZone && gone[zone]; };
  for (Contact& contact : contacts_) {
    std::erase_if(contact.halves,
                  [&](const Half& half) { return is_gone(half.first_zone) || is_gone(half.second_zone); });
    double nx = 0, ny = 0;
    if (contact.stage <= stage)
      for (const Half& half : contact.halves) {
        nx += half.nx;
        ny += half.ny;
      }
    contact.length = std::hypot(nx, ny);
    if (contact.length == 0) continue;
    contact.nx = nx / contact.length;
    contact.ny = ny / contact.length;
  }
}

void Contacts::mark_points(std::vector<bool>& touched) const {
  for (const Contact& contact : contacts_)
    for (const auto point : contact.points) touched[point] = true;
  for (const Face& guide : guides_)
    for (std::uint32_t side = 0; side < guide.size(); ++side)
      for (const auto point : guide.side(side)) touched[point] = true;
}

Contacts::Part Contacts::standing() const {
  Part part;
  for (std::uint32_t i = 0; i < contacts_.size(); ++i)
    if (contacts_[i].length > 0) part.push_back(i);
  return part;
}

Contacts::Part Contacts::take(Part& part, const std::vector<bool>& chosen) const {
  const auto counts = [&](std::uint32_t i) { return touches(contacts_[i], chosen); };
  Part taken;
  std::ranges::copy_if(part, std::back_inserter(taken), counts);
  std::erase_if(part, counts);
  return taken;
}

// A spring k between two masses m turns with 2k/m = 4/dt^2.
void Contacts::add_masses(std::span<double> of_points, double step) const {
  for (const Contact& contact : contacts_) {
    const double stiffness = std::max(contact.law.normal, contact.law.shear) * contact.length;
    for (const auto point : contact.points) of_points[point] += stiffness * step * step / 2;
  }
}

Contacts::Stiffest Contacts::stiffest(std::span<const double> masses, const std::vector<bool>& chosen) const {
  std::vector<double> stiffness(masses.size(), 0.0);
  for (const Contact& contact : contacts_) {
    double length = 0;
    for (const Half& half : contact.halves) length += std::hypot(half.nx, half.ny);
    for (const auto point : contact.points)
      stiffness[point] += std::max(contact.law.normal, contact.law.shear) * length;
  }
  Stiffest found;
  for (const Contact& contact : contacts_) {
    if (!touches(contact, chosen)) continue;
    double square = 0;
    for (const auto point : contact.points) square += stiffness[point] / masses[point];
    if (square > found.square) found = {square, contact.points[0]};
  }
  return found;
}

// Of the zones beside that have water, the mean by the lengths of their sides.
std::optional<double> Contacts::pressure_in_gap(const Contact& contact, const PressureOf& pressure_of) {
  double sum = 0, length = 0;
  for (const Half& half : contact.halves)
    for (const auto zone : {half.first_zone, half.second_zone}) {
      const auto pressure = zone == kNoZone ? std::nullopt : pressure_of(zone);
      if (!pressure) continue;
      sum += half.side * *pressure;
      length += half.side;
    }
  if (length == 0) return std::nullopt;
  return sum / length;
}

double Contacts::push_apart(const Part& part, const protocol::Step& step, const PressureOf& pressure_of,
                            const PointView& points) {
  double work = 0;
  for (const auto i : part) {
    Contact& contact = contacts_[i];
    const auto pressure = pressure_in_gap(contact, pressure_of);
    if (!pressure) continue;
    const double opens = step.from_rest() ? 0 : moved(contact, step.dt, points.vx, points.vy)[0];
    // The pressure of the step before acted along its normal.
    const double opened = contact.sliding ? opens - 2 * contact.sliding->turned[0] : opens;
    work += contact.length * (opened * contact.water + opens * *pressure) / 2;
    if (contact.filled && contact.state.status != ContactStatus::kOpen) {
      const double before = fdm::strain_energy(contact.law, contact.state),
                   closes = (*pressure - contact.water) / contact.law.normal;
      contact.state.closure += closes;
      contact.preload += closes;
      work += contact.length * (fdm::strain_energy(contact.law, contact.state) - before);
    }
    contact.water = *pressure;
    contact.filled = true;
    pull(contact, {-contact.water, 0}, points);
  }
  return work;
}

void Contacts::take_stress(const std::function<Stress(std::uint32_t zone)>& stress_of,
                           const PressureOf& pressure_of) {
  for (Contact& contact : contacts_) {
    if (contact.length == 0 || contact.halves[0].first_zone == kNoZone) continue;
    if (const auto pressure = pressure_in_gap(contact, pressure_of)) {
      contact.water = *pressure;
      contact.filled = true;
    }
    const Half& half = contact.halves[0];
    const Stress a = stress_of(half.first_zone), b = stress_of(half.second_zone);
    const double xx = (a.xx + b.xx) / 2, yy = (a.yy + b.yy) / 2, xy = (a.xy + b.xy) / 2;
    const double tx = xx * contact.nx + xy * contact.ny, ty = xy * contact.nx + yy * contact.ny;
    contact.state.closure = (tx * contact.nx + ty * contact.ny + contact.water) / contact.law.normal;
    contact.preload = contact.state.closure;
    // The second face holds the first back along the tangent (ny, -nx) with -t.tangent.
    contact.state.shear = tx * contact.ny - ty * contact.nx;
  }
}

void Contacts::add_forces(const Part& part, double dt, const PointView& points) {
  move(part, dt, false, points);
  for (const auto i : part) {
    Contact& contact = contacts_[i];
    const auto [du, ds] = contact.motion;
    const ContactState before = contact.state;
    Stroke stroke{};
    if (!contact.free()) stroke = fdm::move(contact.law, du, ds, contact.state);
    const double normal_before = normal_stress(contact.law, before);
    if (contact.sliding)  // the forces of the step before were along its normal
      dissipated_ -= contact.length * (contact.stress[0] * contact.sliding->turned[0] +
                                       contact.stress[1] * contact.sliding->turned[1]);
    contact.stress = {normal_stress(contact.law, contact.state), contact.state.shear};
    // The forces of both ends of the step do the work.
    stroke.normal = (normal_before + contact.stress[0]) / 2;
    stroke.shear = (before.shear + contact.stress[1]) / 2;
    dissipated_ += contact.length * fdm::dissipated(contact.law, before, stroke, contact.state);
    contact.offset += ds;
    pull(contact, contact.stress, points);
  }
}

// Stresses pull the first face to the second.
void Contacts::pull(const Contact& contact, const std::array<double, 2>& stress, const PointView& points) {
  const auto [normal, shear] = stress;
  const double nx = contact.nx, ny = contact.ny;
  const double fx = contact.length * (normal * nx + shear * ny),
               fy = contact.length * (normal * ny - shear * nx);
  for (const auto& [point, factor] : contact.shared()) {
    points.fx[point] -= factor * fx;
    points.fy[point] -= factor * fy;
  }
}

void Contacts::move(const Part& part, double dt, bool from_rest, const PointView& points) {
  for (const auto i : part) move(contacts_[i], dt, from_rest, points);
}

void Contacts::move(Contact& contact, double dt, bool from_rest, const PointView& points) {
  contact.from_rest = from_rest;
  contact.motion = {0, 0};  // from rest nothing has moved
  if (!from_rest) contact.motion = moved(contact, dt, points.vx, points.vy);
  if (!contact.sliding) return;
  contact.ahead[0] += contact.sliding->turned[0];
  contact.ahead[1] += contact.sliding->turned[1];
}

// The tangent (ny, -nx) lies to the right of the normal.
std::array<double, 2> Contacts::moved(const Contact& contact, double dt, const double* vx, const double* vy) {
  double dx = 0, dy = 0;
  for (const auto& [point, factor] : contact.shared()) {
    dx += factor * vx[point];
    dy += factor * vy[point];
  }
  dx *= dt;
  dy *= dt;
  return {dx * contact.nx + dy * contact.ny, dx * contact.ny - dy * contact.nx};
}

// dt v(n+1/2)/2 = dt v(n-1/2)/2 + dt^2 a/2; from rest dt^2 a/4.
std::array<double, 2> Contacts::place_ahead(const Contact& contact, const std::array<double, 2>& lead) {
  if (contact.from_rest) return lead;
  return {contact.motion[0] / 2 + 2 * lead[0], contact.motion[1] / 2 + 2 * lead[1]};
}

Contacts::Trial Contacts::attempt(const Contact& contact, const std::array<double, 2>& lead) {
  const auto ahead = place_ahead(contact, lead);
  Trial trial{contact.state, {}};
  if (contact.free()) return trial;
  trial.stroke = fdm::move(contact.law, contact.motion[0] + ahead[0] - contact.ahead[0],
                           contact.motion[1] + ahead[1] - contact.ahead[1], trial.state);
  if (contact.from_rest) {
    trial.stroke.normal = normal_stress(contact.law, trial.state);
    trial.stroke.shear = trial.state.shear;
  }
  return trial;
}

Contacts::Bearing Contacts::bear(std::uint32_t i, const std::array<double, 2>& lead) const {
  return bearing(contacts_[i], attempt(contacts_[i], lead).stroke);
}

// The end of the stroke moves by twice the lead; from rest by the lead, but its stresses have twice the
// slopes of the means.
Contacts::Bearing Contacts::bearing(const Contact& contact, const Stroke& stroke) {
  const double length = contact.length, by_lead = 2 * length;
  const auto& [by_normal, by_shear] = stroke.normal_slopes;
  const auto& [shear_by_normal, shear_by_shear] = stroke.shear_slopes;
  return {length * stroke.normal,
          length * stroke.shear,
          {by_lead * by_normal, by_lead * by_shear},
          {by_lead * shear_by_normal, by_lead * shear_by_shear}};
}

void Contacts::settle_pairs(const Part& part, const protocol::Step& step,
                            std::span<const double> inverse_masses, const PointView& points) {
  const double quarter = step.dt * step.dt / 4;
  for (const auto i : part) {
    Contact& contact = contacts_[i];
    move(contact, step.dt, step.from_rest(), points);
    const auto [first, second] = contact.points;
    const double w1 = inverse_masses[first], w2 = inverse_masses[second];
    const double ax = w1 * points.fx[first] - w2 * points.fx[second],
                 ay = w1 * points.fy[first] - w2 * points.fy[second];
    settle(contact, quarter * (w1 + w2),
           {quarter * (ax * contact.nx + ay * contact.ny), quarter * (ax * contact.ny - ay * contact.nx)},
           points);
  }
}

// q + c B(q) = free, where faces slide with a matrix that is not symmetric. Where statuses change, the way is
// shortened until less is missed than before, as in solver/contact_balance.hpp.
void Contacts::settle(Contact& contact, double c, const std::array<double, 2>& free,
                      const PointView& points) {
  constexpr int kMost = 60;
  constexpr double kSame = 1e-12;  // of the terms
  constexpr double kShortest = 1.0 / 64;
  struct Place {
    std::array<double, 2> lead;
    Trial trial;
    Bearing bears;
    double r, s;  // what is missed along both
    double missed() const { return std::max(std::abs(r), std::abs(s)); }
  };
  const auto at = [&](const std::array<double, 2>& lead) {
    const Trial trial = attempt(contact, lead);
    const Bearing bears = bearing(contact, trial.stroke);
    return Place{lead, trial, bears, free[0] - c * bears.normal - lead[0],
                 free[1] - c * bears.shear - lead[1]};
  };
  Place place = at(contact.lead);
  for (int number = 0; number < kMost; ++number) {
    const auto& [lead, trial, bears, r, s] = place;
    const auto& [normal, shear, of_normal, of_shear] = bears;
    const double largest =
        std::max({c * std::abs(normal), c * std::abs(shear), std::abs(free[0]), std::abs(free[1])});
    if (place.missed() <= kSame * largest) break;
    const double rr = 1 + c * of_normal.by_normal, rs = c * of_normal.by_shear, sr = c * of_shear.by_normal,
                 ss = 1 + c * of_shear.by_shear;
    const auto go = [&, lead = place.lead, r = place.r, s = place.s](double part) {
      const double way = part / (rr * ss - rs * sr);
      return at({lead[0] + way * (ss * r - rs * s), lead[1] + way * (rr * s - sr * r)});
    };
    Place there = go(1);
    for (double part = 0.5; there.missed() >= place.missed() && part >= kShortest; part /= 2)
      there = go(part);
    place = there;
  }
  follow(contact, place.lead, place.trial, points);
}

Contacts::Part Contacts::take_pairs(Part& part, const std::vector<bool>& chosen) const {
  std::vector<std::uint32_t> uses(chosen.begin(), chosen.end());
  for (const auto i : part)
    for (const auto point : contacts_[i].points) ++uses[point];
  const auto alone = [&](std::uint32_t i) {
    return !contacts_[i].sliding &&
           std::ranges::all_of(contacts_[i].points, [&](auto point) { return uses[point] == 1; });
  };
  Part taken;
  std::ranges::copy_if(part, std::back_inserter(taken), alone);
  std::erase_if(part, alone);
  return taken;
}

void Contacts::follow(std::uint32_t i, const std::array<double, 2>& lead, const PointView& points) {
  follow(contacts_[i], lead, attempt(contacts_[i], lead), points);
}

void Contacts::follow(Contact& contact, const std::array<double, 2>& lead, const Trial& trial,
                      const PointView& points) {
  const auto& [state, done] = trial;
  if (!contact.from_rest) {
    // By how much the last stroke ended ahead of where the faces went, since its forces were found to a
    // tolerance.
    const double normal_miss = contact.ahead[0] - contact.motion[0] / 2,
                 shear_miss = contact.ahead[1] - contact.motion[1] / 2;
    dissipated_ += contact.length * (fdm::dissipated(contact.law, contact.state, done, state) +
                                     (done.normal - contact.stress[0]) * normal_miss +
                                     (done.shear - contact.stress[1]) * shear_miss);
  }
  contact.state = state;
  contact.stress = {done.normal, done.shear};
  contact.offset += contact.motion[1];
  contact.ahead = place_ahead(contact, lead);
  contact.lead = lead;
  pull(contact, contact.stress, points);
}

void Contacts::add_held(const std::function<double(std::uint32_t zone)>& share_of, std::span<double> fx,
                        std::span<double> fy) const {
  const auto share = [&](std::uint32_t zone) { return zone == kNoZone ? 0.0 : share_of(zone); };
  for (const Contact& contact : contacts_) {
    if (contact.length == 0) continue;
    for (const Half& half : contact.halves) {
      const double normal = normal_stress(contact.law, contact.state) - contact.water,
                   shear = contact.state.shear;
      const double x = normal * half.nx + shear * half.ny, y = normal * half.ny - shear * half.nx;
      // What is taken away on one side goes on holding the other.
      const double of_first = share(half.first_zone), of_second = share(half.second_zone);
      fx[contact.points[1]] += of_first * x;
      fy[contact.points[1]] += of_first * y;
      fx[contact.points[0]] -= of_second * x;
      fy[contact.points[0]] -= of_second * y;
    }
  }
}

std::vector<StrainForm> Contacts::strains(const Part& part) const {
  std::vector<StrainForm> strains;
  for (const auto i : part) {
    const Contact& contact = contacts_[i];
    const auto form = [&](double stiffness, double x, double y) {
      StrainForm& strain = strains.emplace_back(StrainForm{stiffness * contact.length, {}});
      for (const auto& [point, factor] : contact.shared()) {
        strain.shares.push_back({{Freedom::kX, point}, factor * x});
        strain.shares.push_back({{Freedom::kY, point}, factor * y});
      }
    };
    form(contact.law.normal, contact.nx, contact.ny);
    form(contact.law.shear, contact.ny, -contact.nx);
  }
  return strains;
}

double Contacts::dissipated() const {
  double sum = dissipated_;
  for (const Contact& contact : contacts_)
    if (contact.state.status == ContactStatus::kSliding)
      sum -= contact.length * contact.stress[1] * contact.ahead[1];
  return sum;
}

double Contacts::strain_energy() const {
  double sum = 0;
  for (const Contact& contact : contacts_) {
    const auto& [normal, shear] = contact.stress;
    const bool slides = contact.state.status == ContactStatus::kSliding;
    sum += contact.length * (fdm::strain_energy(contact.law, contact.state) - normal * contact.ahead[0] -
                             (slides ? 0 : shear * contact.ahead[1]));
  }
  return sum;
}

void Contacts::reset_offsets() {
  for (Contact& contact : contacts_) contact.offset = 0;
}

void Contacts::exchange(state::Archive& archive) {
  archive.members("contacts", std::span(contacts_), &Contact::state, &Contact::offset, &Contact::stress,
                  &Contact::lead, &Contact::ahead, &Contact::water, &Contact::filled);
  if (slides()) exchange_feet(archive);
  archive("contacts_dissipated", dissipated_);
}

double Contacts::side(std::uint32_t contact) const {
  double longest = 0;
  for (const Half& half : contacts_[contact].halves) longest = std::max(longest, half.side);
  return longest;
}

Contacts::Reading Contacts::read(std::uint32_t i) const {
  const Contact& contact = contacts_[i];
  if (contact.length == 0) return {};
  return {contact.stress[0] - contact.water, contact.stress[1], std::max(0.0, opening(contact.state)),
          contact.offset};
}

}  // namespace adit::fdm
