// cgal_mesh SURFACE MESH SIZE {raw|optimised}: tetrahedra of a closed triangle surface (OFF) by CGAL's
// Mesh_3, as a MEDIT file. SIZE bounds the circumradii of tetrahedra and surface triangles and the lengths of
// sharp edges; `raw` is Delaunay refinement alone, `optimised` adds CGAL's default steps against slivers
// (perturb, exude).
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/make_mesh_3.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string_view>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Mesh_polyhedron_3<Kernel>::type;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex =
    CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;

namespace parameters = CGAL::parameters;

Complex make_mesh(const Surface& surface, double size, bool optimised) {
  Domain domain(surface);
  domain.detect_features();
  const CGAL::Mesh_criteria_3<Triangulation> criteria(
      parameters::edge_size = size, parameters::facet_angle = 25, parameters::facet_size = size,
      parameters::facet_distance = size / 10, parameters::cell_radius_edge_ratio = 2,
      parameters::cell_size = size);
  if (optimised) return CGAL::make_mesh_3<Complex>(domain, criteria);
  return CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: cgal_mesh SURFACE MESH SIZE {raw|optimised}\n";
    return 2;
  }
  Surface surface;
  if (!CGAL::IO::read_polygon_mesh(argv[1], surface) || !CGAL::is_closed(surface)) {
    std::cerr << argv[1] << ": not a closed triangle surface\n";
    return 2;
  }
  const Complex mesh = make_mesh(surface, std::atof(argv[3]), std::string_view(argv[4]) == "optimised");
  std::ofstream out(argv[2]);
  mesh.output_to_medit(out);
  return out.good() ? 0 : 1;
}
