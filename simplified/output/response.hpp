// What a run of any of the models leaves, in the order of the chainage: envelopes, joints, histories, fields.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace adit::simplified {

// Least and greatest value of a quantity at each place.
struct Envelope {
  std::string name;  // of its columns, with the unit behind: "axial_force", "N"
  std::string unit;
  std::vector<double> least, greatest;
};

struct JointResponse {
  double chainage;
  std::size_t group;   // of tunnel.joints
  double opening;      // largest, from the installed state, where the joint opens most [m]
  double compression;  // largest, likewise [m]
  double offset;       // largest, across the axis [m]
};

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

// The tunnel's motion and axial force along itself, a row a recorded time.
struct Fields {
  std::vector<double> chainage, time;
  std::vector<double> axial_velocity, lateral_velocity, axial_force;  // [m/s], [m/s], [N]
};

struct Response {
  std::vector<double> chainage;  // of the envelopes' places [m]
  std::vector<Envelope> envelopes;
  std::vector<JointResponse> joints;
  Table histories;
  Fields fields;  // empty for the column
  std::vector<std::pair<std::string, double>>
      figures;        // of the model, for the summary: name with unit, value
  double wall_s = 0;  // of the model itself, without excitation and files
};

// The place at which the envelope's magnitude is largest, and that magnitude.
struct Peak {
  double chainage = 0, value = 0;
};
Peak peak(const std::vector<double>& chainage, const Envelope& envelope);

// Null where the response has none of that name.
const Envelope* find(const Response& response, const std::string& name);

}  // namespace adit::simplified
