#include "unsliver/verify_stream.hpp"

#include "verify/holes.hpp"
#include "verify/shape_census.hpp"
#include "verify/stream_facets.hpp"
#include "verify/stream_points.hpp"
#include "verify/structure.hpp"
#include "verify/until_cancelled.hpp"

namespace unsliver {
namespace verifier {
namespace {

/// The first pass over the tetrahedra: can they be read, which shapes have they, where are their facets?
class TetPass {
 public:
  TetPass(const StreamContext& context, PointPages& points) : c_(context), points_(points), map_(context) {}

  /// False: nothing else may be checked.
  bool run() {
    TetChunk tets;
    for (std::uint64_t chunk = 0; chunk < chunk_count(c_.head.tets); ++chunk) {
      read_chunk(c_, chunk, tets);
      const bool sound = add_chunk(chunk * kChunk, tets);
      if (sound) map_.add_chunk(tets);
    }
    return c_.reporter.count("index") == 0 && c_.reporter.count("shapes") == 0;
  }

  const ShapeCensus& census() const { return census_; }
  const FacetMap& facets() const { return map_; }

 private:
  bool add_chunk(std::uint64_t first, const TetChunk& tets) {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      if (!has_sound_indices(tets[i]))
        find_index(first + i, tets[i]);
      else if (!census_.is_full())
        census_.add(shape_of(tets[i]), first + i);
      else if (c_.reporter.count("shapes") == 0)
        c_.reporter.find("shapes", {}, [] {
          return "there are more than " + grouped(ShapeCensus::kMostShapes) +
                 " shapes of tetrahedra: this is no mesh of an octree's";
        });
    }
    return c_.reporter.count("index") == 0;
  }

  bool has_sound_indices(const std::array<VertexId, 4>& t) const {
    const bool different =
        t[0] != t[1] && t[0] != t[2] && t[0] != t[3] && t[1] != t[2] && t[1] != t[3] && t[2] != t[3];
    return different && *std::max_element(t.begin(), t.end()) < c_.head.vertices;
  }

  Differences shape_of(const std::array<VertexId, 4>& t) {
    const Row<std::int64_t> origin = points_[t[0]];
    Differences shape;
    for (std::size_t i = 0; i < 3; ++i) {
      const Row<std::int64_t> q = points_[t[i + 1]];
      shape[i] = {q[0] - origin[0], q[1] - origin[1], q[2] - origin[2]};
    }
    return shape;
  }

  void find_index(std::uint64_t number, const std::array<VertexId, 4>& t) const {
    c_.reporter.find("index", {static_cast<std::int64_t>(number)}, [&] {
      std::string text = "tetrahedron " + std::to_string(number) + " has the vertices";
      for (const VertexId v : t) text += " " + std::to_string(v);
      return text + ": expected four different ones below " + std::to_string(c_.head.vertices);
    });
  }

  const StreamContext& c_;
  PointPages& points_;
  ShapeCensus census_;
  FacetMap map_;
};

void check_facets(const StreamContext& c, const TetPass& pass, PointPages& points) {
  const FacetCounts facets = match_stream_facets(c, pass.facets(), points);
  const std::uint64_t wrong = c.reporter.count("conformity");
  c.reporter.line("conformity: " + grouped(facets.interior) + " facets in two tetrahedra, " +
                  grouped(facets.boundary) + " in one" +
                  (wrong == 0 ? "" : "; " + grouped(wrong) + " defects"));
  if (c.options.inside) report_holes(c.reporter, facets.boundary, c.reporter.count("cover"));
  const BigInt six_volumes = pass.census().six_volumes();
  const double unit = c.head.frame.unit;
  VerifyReport& report = c.report;
  report.volume = six_volumes.convert_to<double>() / 6 * unit * unit * unit;
  if (six_volumes != facets.six_volumes)
    c.reporter.find("volume", {}, [&] {
      return "the tetrahedra have the volume " + six_volumes.str() +
             "/6 in cubic units of the frame, and the " + "facets in one of them enclose " +
             facets.six_volumes.str() + "/6";
    });
  c.reporter.line(
      "volume: " + brief(report.volume) + ", " + six_volumes.str() + "/6 cubic units of the frame" +
      (c.reporter.count("volume") == 0 ? ", as the facets in one tetrahedron enclose (exact)" : ""));
}

bool check_head(const StreamContext& c) {
  check_frame(c.head.frame, c.reporter);
  if (c.head.vertices >= kNoVertex || (c.head.vertices == 0 && c.head.tets > 0))
    c.reporter.find("index", {}, [&] {
      return "there are " + grouped(c.head.vertices) + " vertices, more or less than can be";
    });
  return c.report.ok;
}

void run(const StreamContext& c) {
  if (!check_head(c) || !check_stream_points(c)) return;
  check_stream_coincident(c);
  if (c.head.tets == 0) return c.reporter.line("structure: there are no tetrahedra");
  PointPages points(c);
  TetPass pass(c, points);
  const bool sound = pass.run();
  c.reporter.line("structure: " + grouped(c.head.vertices) + " points, " + grouped(c.head.tets) +
                  " tetrahedra, " +
                  (sound ? "all indices in range" : "and defects: nothing else was checked"));
  if (!sound) return;
  pass.census().judge(c);
  check_facets(c, pass, points);
}

}  // namespace
}  // namespace verifier

StreamVerifyReport verify_stream(MeshSource& source, const StreamVerifyOptions& options,
                                 const Control& control) {
  using namespace verifier;
  StreamVerifyReport report;
  Reporter reporter(report, options.max_findings);
  const MeshHead head = source.head();
  Pulse pulse(control, 2 * (head.vertices + head.tets), head.vertices, head.tets);
  run_until_cancelled(reporter, [&] { run({source, head, options, report, reporter, pulse}); });
  return report;
}

}  // namespace unsliver
