#include "prove/figure_8.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exact/quality_signs.hpp"
#include "prove/constants.hpp"
#include "prove/surd.hpp"

namespace unsliver::prover {
namespace {

using Integer = Surd::Integer;

constexpr std::int64_t kBoxSide = 1 << 13, kCubeCorner = 1 << 17;
/// SC_16: the forbidden regions of the cube's corners end before the box.
constexpr int kStartLevel = 33;
constexpr exact::QualityBounds kBounds{{1, 3, 4}, {-1, 1, 2}, {29241, 15625}};  // 30, 135, 1.368

constexpr int sc(int k) { return 2 * k + 1; }
constexpr bool is_bcc_level(int level) { return (level & 1) == 0; }

/// Squared radii in units of 4^k, exact.
const SurdFraction kScRadiusSq{3, 4};                  // r(SC_k) = sqrt(3)/2
const SurdFraction kNextBccRadiusSq{5, 4};             // r(BCC_{k+1}) = sqrt(5)/2
const SurdFraction kNextScRadiusSq{3, 1};              // r(SC_{k+1}) = sqrt 3
const SurdFraction kCase2RadiusSq{Surd(126, 36), 64};  // r(SC_k) + rho/2 = sqrt(3) (6 + sqrt 6)/8
const SurdFraction kCase3RadiusSq{Surd(66, 24), 16};   // r(SC_k) + rho = sqrt(3) (4 + sqrt 6)/4

Vec3 vec3(const Point& p) { return {double(p.x), double(p.y), double(p.z)}; }

Integer power_of_4(int k) { return Integer(1) << (2 * k); }

/// Is d in the cube of half side 2^k sigma, 4 sigma = 2 + sqrt 6?
bool in_region(const Point& d, int k) {
  const std::int64_t farthest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  return (Surd(4 * int(farthest)) - Surd(1 << k) * Surd(2, 1)).sign() <= 0;
}

/// The lattice points of a level in a box around a ball, in lexicographic order.
template <class Test>
std::optional<Point> first_lattice_point(int level, const Vec3& center, double radius, const Test& test) {
  const std::int64_t step = std::int64_t{1} << ((level - 1) >> 1);
  const auto lowest = [&](double c) { return std::int64_t(std::floor((c - radius) / double(step))) - 1; };
  const auto highest = [&](double c) { return std::int64_t(std::ceil((c + radius) / double(step))) + 1; };
  for (std::int64_t x = lowest(center.x); x <= highest(center.x); ++x)
    for (std::int64_t y = lowest(center.y); y <= highest(center.y); ++y)
      for (std::int64_t z = lowest(center.z); z <= highest(center.z); ++z) {
        if (is_bcc_level(level) && (((x ^ y) | (y ^ z)) & 1) != 0) continue;
        const Point w = step * Point{x, y, z};
        if (test(w)) return w;
      }
  return std::nullopt;
}

Point promised(const char* lemma, const std::optional<Point>& w) {
  if (!w) throw std::logic_error(lemma);
  return *w;
}

/// The circumsphere of a tetrahedron: centre corner + center / twice_det, in integers of any size.
class Sphere {
 public:
  explicit Sphere(const std::array<Point, 4>& t) : corner_(t[0]) {
    const Point b = t[1] - t[0], c = t[2] - t[0], d = t[3] - t[0];
    const Point cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
    twice_det_ = 2 * (Int128(b.x) * cd.x + Int128(b.y) * cd.y + Int128(b.z) * cd.z);
    const auto sum = [&](std::int64_t p, std::int64_t q, std::int64_t r) {
      return Int128(dot(b, b)) * p + Int128(dot(c, c)) * q + Int128(dot(d, d)) * r;
    };
    center_ = {sum(cd.x, db.x, bc.x), sum(cd.y, db.y, bc.y), sum(cd.z, db.z, bc.z)};
    radius_sq_num_ = inner(center_, center_);
  }

  /// sign(R^2 - 4^k x)
  int compare_radius(const SurdFraction& x, int k) const {
    return (Surd::of(radius_sq_num_) * x.den -
            Surd::of(Integer(twice_det_) * twice_det_ * power_of_4(k)) * x.num)
        .sign();
  }
  bool holds_inside(const Point& w) const {
    const auto offset = from_center(w);
    return inner(offset, offset) < radius_sq_num_;
  }
  /// In the closed ball of radius 2^k sqrt(x) about the centre.
  bool is_near_center(const Point& w, const SurdFraction& x, int k) const {
    const auto offset = from_center(w);
    return !((Surd::of(Integer(twice_det_) * twice_det_ * power_of_4(k)) * x.num) <
             Surd::of(inner(offset, offset)) * x.den);
  }
  /// In the closed ball of radius 2^k sqrt(x) tangent at v, a corner, inside the sphere; but not v.
  bool in_tangent_ball(const Point& w, const Point& v, const SurdFraction& x, int k) const {
    const Point d = w - v;
    const auto to_v = from_center(v);
    const Integer along = -(Integer(d.x) * to_v[0] + Integer(d.y) * to_v[1] + Integer(d.z) * to_v[2]);
    if (along <= 0) return false;
    const Integer length_sq = dot(d, d);
    return !(Surd::of(4 * power_of_4(k) * along * along) * x.num <
             Surd::of(length_sq * length_sq * radius_sq_num_) * x.den);
  }

  /// In doubles, for where to look.
  Vec3 center() const {
    const double scale = 1 / double(twice_det_);
    return vec3(corner_) + scale * Vec3{double(center_[0]), double(center_[1]), double(center_[2])};
  }
  double radius() const { return std::sqrt(radius_sq_num_.convert_to<double>()) / double(twice_det_); }

 private:
  using Wide = std::array<Int128, 3>;

  static Integer inner(const Wide& p, const Wide& q) {
    return Integer(p[0]) * q[0] + Integer(p[1]) * q[1] + Integer(p[2]) * q[2];
  }
  Wide from_center(const Point& w) const {
    const Point d = w - corner_;
    return {twice_det_ * d.x - center_[0], twice_det_ * d.y - center_[1], twice_det_ * d.z - center_[2]};
  }

  Point corner_;
  Wide center_;
  Int128 twice_det_;  ///< > 0
  Integer radius_sq_num_;
};

}  // namespace

struct Figure8::Bad {
  Bad(const Figure8& f, delaunay::TetId tet)
      : t(tet), sphere({f.at(tet, 0), f.at(tet, 1), f.at(tet, 2), f.at(tet, 3)}) {
    for (const VertexId corner : f.mesh_.tet(tet).v)
      if (f.is_input(corner))
        inputs.push_back(corner);
      else if (v == kNoVertex || f.vertices_[corner].level < f.vertices_[v].level)
        v = corner;
  }
  delaunay::TetId t;
  Sphere sphere;
  VertexId v = kNoVertex;  ///< kNoVertex where all corners are input vertices
  std::vector<VertexId> inputs;
};

Figure8::Figure8(const std::vector<Point>& inputs) : vertices_(1) {
  for (int i = 0; i < 8; ++i) {
    const auto coordinate = [&](int bit) { return (i & bit) != 0 ? kCubeCorner : -kCubeCorner; };
    const Point corner{coordinate(1), coordinate(2), coordinate(4)};
    mesh_.insert(vec3(corner));
    vertices_.push_back({VertexType::kStart, kStartLevel, corner});
  }
  for (const Point& u : inputs) {
    inputs_.push_back(mesh_.insert(vec3(u)));
    vertices_.push_back({VertexType::kInput, 0, u});
  }
}

void Figure8::run() {
  for (delaunay::TetId t = 0; t < mesh_.slot_count(); ++t) enqueue(t);
  while (!queue_.empty()) {
    const Queued next = queue_.front();
    queue_.pop_front();
    if (!mesh_.is_finite(next.t) ||
        !std::equal(next.corners.begin(), next.corners.end(), mesh_.tet(next.t).v))
      continue;
    const Bad bad(*this, next.t);
    bad.v == kNoVertex ? case_3(bad) : case_1(bad);
    for (const delaunay::TetId t : mesh_.created()) enqueue(t);
  }
}

void Figure8::enqueue(delaunay::TetId t) {
  if (!mesh_.is_finite(t)) return;
  const Tet corners = mesh_.corners(t);
  Box3 box;
  for (const Vec3& p : corners) box.extend(p);
  constexpr double kEnd = double(kBoxSide);
  if (!box.overlaps({{0, 0, 0}, {kEnd, kEnd, kEnd}}) || !exact::is_bad(corners, kBounds, counts_)) return;
  const auto& v = mesh_.tet(t).v;
  queue_.push_back({t, {v[0], v[1], v[2], v[3]}});
}

Figure8::Candidate Figure8::candidate_of_case_1(const Bad& bad) const {
  const Figure8Vertex& v = vertices_[bad.v];
  const bool next_is_bcc = is_bcc_level(v.level + 1);
  const int k = v.exponent();
  const std::string number = next_is_bcc ? "1.1." : "1.2.";
  const SurdFraction& radius_sq = next_is_bcc ? kNextBccRadiusSq : kNextScRadiusSq;
  if (bad.sphere.compare_radius(radius_sq, k) > 0) {
    const double radius = std::ldexp(next_is_bcc ? 1.2 : 1.8, k);  // where to look: a little more than r
    const Vec3 at = vec3(v.at), center = at + radius / bad.sphere.radius() * (bad.sphere.center() - at);
    const auto in_ball = [&](const Point& q) { return bad.sphere.in_tangent_ball(q, v.at, radius_sq, k); };
    return {number + "1", promised("Lemma 3", first_lattice_point(v.level + 1, center, radius, in_ball))};
  }
  if (!bad.inputs.empty()) return {number + "2", std::nullopt};
  if (next_is_bcc) throw std::logic_error("Lemma 5");
  const auto inside = [&](const Point& q) { return bad.sphere.holds_inside(q); };
  return {number + "3", promised("Lemma 6", first_lattice_point(v.level + 1, bad.sphere.center(),
                                                                bad.sphere.radius(), inside))};
}

void Figure8::case_1(const Bad& bad) {
  const Figure8Vertex& v = vertices_[bad.v];
  const bool next_is_bcc = is_bcc_level(v.level + 1);
  const int k = v.exponent();
  const Roots r;
  // 2 r(BCC_{k+1}) = 2^k sqrt 5, 2 r(SC_{k+1}) = 2^k sqrt 12; and the region's radius.
  const Enclosure reach_sq = next_is_bcc ? 5 : 12, margin = next_is_bcc ? r.rho : Enclosure(2) * r.rho;
  const auto [subcase, w] = candidate_of_case_1(bad);
  if (!w) {
    watch(subcase + " jump", v.at, vertices_[bad.inputs[0]].at, k, reach_sq);
    return case_2(bad, bad.inputs[0]);
  }
  if (const auto u1 = input_in_region(*w, v.level / 2)) {
    watch(subcase + " jump", v.at, vertices_[*u1].at, k, square(square_root(reach_sq) + margin));
    return case_2(bad, *u1);
  }
  watch(subcase, v.at, *w, k, reach_sq);
  if (next_is_bcc)
    insert(bad, {VertexType::k11, v.level + 1, *w, bad.v, v.nearby});
  else
    insert(bad, {VertexType::k12, v.level + 1, *w});
}

void Figure8::case_2(const Bad& bad, VertexId u1) {
  const Figure8Vertex& v = vertices_[bad.v];
  const int k = v.exponent();
  const Roots r;
  const bool is_large = bad.sphere.compare_radius(kCase2RadiusSq, k) > 0;
  const auto other = std::find_if(bad.inputs.begin(), bad.inputs.end(), [&](VertexId u) { return u != u1; });
  if (!is_large && other != bad.inputs.end()) {
    watch("2.3 jump", v.at, vertices_[*other].at, k, square(r.root3 + r.rho));
    return case_3(bad);
  }
  const std::string subcase = is_large ? "2.1" : "2.2";
  const double radius = is_large ? std::ldexp(1.9, k) : bad.sphere.radius();
  const Vec3 at = vec3(v.at), to_center = bad.sphere.center() - at;
  const Vec3 center = at + std::min(1.0, radius / bad.sphere.radius()) * to_center;
  const auto is_candidate = [&](const Point& q) {
    return !in_region(vertices_[u1].at - q, k) &&
           (is_large ? bad.sphere.in_tangent_ball(q, v.at, kCase2RadiusSq, k) : bad.sphere.holds_inside(q));
  };
  const Point w = promised(is_large ? "Lemma 3" : "Corollary 9",
                           first_lattice_point(sc(k), center, radius, is_candidate));
  if (const auto u2 = input_in_region(w, k)) {
    watch(subcase + " jump", v.at, vertices_[*u2].at, k, square(r.root3 + Enclosure(2) * r.rho));
    return case_3(bad);
  }
  watch(subcase, v.at, w, k, square(r.root3 + r.rho));
  insert(bad, {VertexType::k2, sc(k), w, bad.v, u1});
}

void Figure8::case_3(const Bad& bad) {
  int j = std::ilogb(bad.sphere.radius());
  while (j >= 0 && bad.sphere.compare_radius(kCase3RadiusSq, j) <= 0) --j;
  if (j < 0) throw std::logic_error("the least distance of inputs");
  const auto near_center = [&](const Point& q) { return bad.sphere.is_near_center(q, kScRadiusSq, j); };
  const Point w =
      promised("Lemma 3", first_lattice_point(sc(j), bad.sphere.center(), std::ldexp(0.9, j), near_center));
  if (input_in_region(w, j)) throw std::logic_error("Case 3, its empty region");
  insert(bad, {VertexType::k3, sc(j), w});
}

void Figure8::insert(const Bad& bad, const Figure8Vertex& w) {
  mesh_.insert_in_conflict(vec3(w.at), bad.t);
  vertices_.push_back(w);
}

std::optional<VertexId> Figure8::input_in_region(const Point& w, int k) const {
  for (const VertexId u : inputs_)
    if (in_region(vertices_[u].at - w, k)) return u;
  return std::nullopt;
}

void Figure8::watch(const std::string& subcase, const Point& v, const Point& other, int k,
                    const Enclosure& bound_sq) {
  table_2_[subcase].see(v, other, k, bound_sq);
}

}  // namespace unsliver::prover
