/// \file
/// The paper's Figure 8 to the letter, every decision in exact numbers, on input vertices in a box without a
/// sizing function: what Table 2, Lemmas 10 and 11 and section 5.2.5 say is watched at each insertion.
///
/// Notation: v the finest refinement vertex of a bad tetrahedron t, with label SC_k or BCC_{k+1}; u1, u2
/// input vertices; w the new vertex; p(w) its parent, n(w) its nearby input vertex. Levels number the
/// lattices: 2k = BCC_k, 2k + 1 = SC_k. Only the Delaunay kernel and the test for badness are those of the
/// generator.
#pragma once

#include <deque>
#include <map>
#include <optional>

#include "delaunay/triangulation.hpp"
#include "prove/watched.hpp"

namespace unsliver::prover {

enum class VertexType { kInput, kStart, k11, k12, k2, k3 };

struct Figure8Vertex {
  VertexType type = VertexType::kInput;
  int level = 0;  ///< the label; refinement vertices only
  Point at;
  VertexId parent = kNoVertex, nearby = kNoVertex;  ///< p(w), n(w)

  /// k of SC_k or BCC_{k+1}.
  int exponent() const { return (level - 1) >> 1; }
};

class Figure8 {
 public:
  /// Inputs are distinct, in [0, 2^13)^3, no two nearer than 16.
  explicit Figure8(const std::vector<Point>& inputs);

  /// Until no tetrahedron near the box of the inputs is bad. \throws std::logic_error where a lemma promised
  /// a point and there is none: the name of the lemma.
  void run();

  const std::vector<Figure8Vertex>& vertices() const { return vertices_; }
  /// By subcase and, for jumps, "1.1.1 jump": what Table 2 says.
  const std::map<std::string, Watched>& table_2() const { return table_2_; }

 private:
  struct Bad;

  Point at(delaunay::TetId t, int corner) const { return vertices_[mesh_.tet(t).v[corner]].at; }
  bool is_input(VertexId v) const { return vertices_[v].type == VertexType::kInput; }
  /// If it is bad and near the box.
  void enqueue(delaunay::TetId t);
  struct Candidate {
    std::string subcase;
    std::optional<Point> w;  ///< none in 1.1.2 and 1.2.2
  };
  Candidate candidate_of_case_1(const Bad& bad) const;
  void case_1(const Bad& bad);
  void case_2(const Bad& bad, VertexId u1);
  void case_3(const Bad& bad);
  void insert(const Bad& bad, const Figure8Vertex& w);
  std::optional<VertexId> input_in_region(const Point& w, int k) const;
  void watch(const std::string& subcase, const Point& v, const Point& other, int k,
             const Enclosure& bound_sq);

  delaunay::Triangulation mesh_;
  std::vector<Figure8Vertex> vertices_;  ///< by id; 0 is the vertex at infinity
  std::vector<VertexId> inputs_;
  struct Queued {
    delaunay::TetId t;
    std::array<VertexId, 4> corners;
  };
  std::deque<Queued> queue_;
  std::map<std::string, Watched> table_2_;
  mutable exact::StageCounts counts_;
};

}  // namespace unsliver::prover
