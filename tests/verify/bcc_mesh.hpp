/// \file
/// Meshes for the tests, valid by construction: the Delaunay tetrahedralization of a block of the BCC
/// lattice.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "unsliver/verify.hpp"

namespace unsliver::testing_verify {

struct BccOptions {
  std::array<int, 3> cells{8, 8, 8};  ///< a tetrahedron joins two cells, so only inner faces carry any
  int k = 3;                          ///< BCC_k: cells of side 2^k units
  double unit = 1;
  Vec3 origin{};
  bool frame = true;
};

/// Corners and centres of the cells; round every inner face of the cell grid four tetrahedra that join the
/// two centres to an edge of the face: all of one shape, with angles 60 and 90 and radius-edge ratio
/// sqrt(5/12).
inline TetMesh bcc_mesh(const BccOptions& o = {}) {
  TetMesh mesh;
  if (o.frame) mesh.frame = Frame{o.unit, o.origin};
  const int nx = o.cells[0], ny = o.cells[1], nz = o.cells[2];
  const auto half = std::int64_t{1} << (o.k - 1);
  std::vector<VertexId> corner_ids(std::size_t(nx + 1) * (ny + 1) * (nz + 1), kNoVertex);
  std::vector<VertexId> center_ids(std::size_t(nx) * ny * nz, kNoVertex);
  const auto vertex = [&](VertexId& id, std::array<std::int64_t, 3> halves) {
    if (id != kNoVertex) return id;
    id = VertexId(mesh.points.size());
    Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = o.origin[i] + o.unit * double(halves[i] * half);
    mesh.points.push_back(p);
    mesh.levels.push_back(std::uint8_t(2 * o.k));
    return id;
  };
  const auto corner = [&](std::array<int, 3> c) {
    return vertex(corner_ids[(std::size_t(c[0]) * (ny + 1) + c[1]) * (nz + 1) + c[2]],
                  {2 * c[0], 2 * c[1], 2 * c[2]});
  };
  const auto center = [&](std::array<int, 3> c) {
    return vertex(center_ids[(std::size_t(c[0]) * ny + c[1]) * nz + c[2]],
                  {2 * c[0] + 1, 2 * c[1] + 1, 2 * c[2] + 1});
  };
  const auto around_face = [&](std::array<int, 3> cell, int axis) {
    std::array<int, 3> next = cell;
    ++next[axis];
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    constexpr int kRound[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int i = 0; i < 4; ++i) {
      std::array<int, 3> a = next, b = next;
      a[u] += kRound[i][0], a[w] += kRound[i][1];
      b[u] += kRound[i + 1][0], b[w] += kRound[i + 1][1];
      mesh.tets.push_back({corner(a), corner(b), center(cell), center(next)});
    }
  };
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z) {
        if (x + 1 < nx) around_face({x, y, z}, 0);
        if (y + 1 < ny) around_face({x, y, z}, 1);
        if (z + 1 < nz) around_face({x, y, z}, 2);
      }
    }
  }
  return mesh;
}

/// Every cell of SC_k cut into six tetrahedra round a diagonal: everywhere Delaunay with ties, angles 45,
/// 60, 90.
inline TetMesh kuhn_mesh(const BccOptions& o = {}) {
  TetMesh mesh;
  if (o.frame) mesh.frame = Frame{o.unit, o.origin};
  const int nx = o.cells[0], ny = o.cells[1], nz = o.cells[2];
  const auto side = std::int64_t{1} << o.k;
  const auto id = [&](const std::array<int, 3>& c) {
    return VertexId((c[0] * (ny + 1) + c[1]) * (nz + 1) + c[2]);
  };
  const auto add_cell = [&](const std::array<int, 3>& cell) {
    constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int i = 0; i < 6; ++i) {
      std::array<VertexId, 4> tet;
      std::array<int, 3> c = cell;
      tet[0] = id(c);
      for (int step = 0; step < 3; ++step) ++c[kOrders[i][step]], tet[step + 1] = id(c);
      if (i >= 3) std::swap(tet[2], tet[3]);
      mesh.tets.push_back(tet);
    }
  };
  for (int x = 0; x <= nx; ++x) {
    for (int y = 0; y <= ny; ++y) {
      for (int z = 0; z <= nz; ++z) {
        const Vec3 steps{double(x * side), double(y * side), double(z * side)};
        mesh.points.push_back(o.origin + o.unit * steps);
        mesh.levels.push_back(std::uint8_t(2 * o.k + 1));
        if (x < nx && y < ny && z < nz) add_cell({x, y, z});
      }
    }
  }
  return mesh;
}

/// One tetrahedron with integer corners, no frame.
inline TetMesh single_tet(const std::array<std::array<double, 3>, 4>& p) {
  TetMesh mesh;
  for (const auto& q : p) mesh.points.push_back({q[0], q[1], q[2]});
  mesh.tets.push_back({0, 1, 2, 3});
  return mesh;
}

/// How many findings each check made.
inline std::map<std::string, int> findings(const VerifyReport& r) {
  std::map<std::string, int> n;
  for (const Finding& f : r.findings) ++n[f.check];
  return n;
}

/// For failure messages.
inline std::string text(const VerifyReport& r) {
  std::string s;
  for (const auto& line : r.checks) s += line + "\n";
  for (const auto& f : r.findings) s += "! " + f.check + ": " + f.message + "\n";
  return s;
}

inline VerifyOptions guaranteed(double min = 30, double max = 135, double ratio = 1.118033988749895) {
  VerifyOptions o;
  o.guarantee = QualityGuarantee{min, max, ratio};
  return o;
}

}  // namespace unsliver::testing_verify
