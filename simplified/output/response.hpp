// The results of any of the models: envelopes, joints, histories, fields, all in the order of the chainage.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace adit::simplified {

// The least and the greatest value of a quantity at each place.
struct Envelope {
  std::string name;  // "axial_force"; with the unit it names the columns of the table
  std::string unit;  // "N"
  std::vector<double> least, greatest;
};

struct JointResponse {
  double chainage;
  std::size_t group;   // number in tunnel.joints
  double opening;      // largest opening from the installed state, at the point that opens most [m]
  double compression;  // largest compression, likewise [m]
  double offset;       // largest offset across the axis [m]
};

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

// The tunnel's motion and axial force along its axis, a row for each recorded time.
struct Fields {
  std::vector<double> chainage, time;
  std::vector<double> axial_velocity, lateral_velocity, axial_force;  // [m/s], [m/s], [N]
  std::vector<double> spin;  // of the sections in the horizontal plane, counter-clockwise from above [rad/s]
};

// What a joint does over the times of the fields: the second face against the first, on the axis, from the
// installed state.
struct JointCourse {
  std::vector<double> opening, offset, rotation;   // [m], [m], [rad]
  std::vector<double> axial_force, shear, moment;  // [N], [N], [N m]
};

struct Response {
  std::vector<double> chainage;  // places of the envelopes [m]
  std::vector<Envelope> envelopes;
  std::vector<JointResponse> joints;
  Table histories;
  Fields fields;                     // empty for the model column
  std::vector<JointCourse> courses;  // of the joints; empty for the models chain and column
  std::vector<std::pair<std::string, double>>
      figures;        // further figures for the summary: name with unit, value
  double wall_s = 0;  // time of the model alone, without excitation and files [s]
};

// The place at which the envelope's magnitude is largest, and that magnitude.
struct Peak {
  double chainage = 0, value = 0;
};
Peak peak(const std::vector<double>& chainage, const Envelope& envelope);

// The envelope of that name; null if the response has none.
const Envelope* find(const Response& response, const std::string& name);

}  // namespace adit::simplified
