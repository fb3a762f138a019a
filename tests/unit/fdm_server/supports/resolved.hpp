// The supports of a continuum, given by its text, on six by three zones.
#pragma once

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>

#include "fdm_server/model/supports/supports.hpp"
#include "tests/unit/fdm_server/grid/grids.hpp"

namespace adit::fdm::test {

inline Supports resolved(const std::string& continuum) {
  scene::Scene scene;
  EXPECT_TRUE(
      google::protobuf::TextFormat::ParseFromString("continuum { " + continuum + " } statics {}", &scene));
  Grid grid = make_grid({0, 6, 0, 3, 6, 3});
  const Ground ground{{{2500, 25e9, 0.2}}, std::vector<std::uint32_t>(grid.zones.size(), 0)};
  return resolve_supports(scene, ground, {}, grid);
}

}  // namespace adit::fdm::test
