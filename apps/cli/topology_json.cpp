#include "topology_json.hpp"

#include "mesh_report.hpp"

namespace unsliver::cli {

using Json = nlohmann::ordered_json;

Json topology_json(const TetMesh& mesh) {
  const Periodicity& periodicity = *mesh.periodicity;
  Json vertices = Json::array(), tets = Json::array(), offsets = Json::array(), copies = Json::array();
  for (VertexId v = 0; v < mesh.points.size(); ++v)
    if (periodicity.home[v] == v)
      vertices.push_back(to_json(mesh.points[v]));
    else
      copies.push_back({{"point", v}, {"home", periodicity.home[v]}, {"shift", periodicity.shift[v]}});
  for (const auto& tet : mesh.tets) {
    Json homes = Json::array(), shifts = Json::array();
    for (const VertexId v : tet) {
      homes.push_back(periodicity.home[v]);
      shifts.push_back(periodicity.shift[v]);
    }
    tets.push_back(std::move(homes));
    offsets.push_back(std::move(shifts));
  }
  return {{"cell", to_json(periodicity.cell)}, {"period", to_json(periodicity.cell.size())},
          {"vertices", std::move(vertices)},   {"tets", std::move(tets)},
          {"offsets", std::move(offsets)},     {"copies", std::move(copies)}};
}

}  // namespace unsliver::cli
