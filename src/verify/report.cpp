#include "verify/report.hpp"

#include <cstdio>

namespace unsliver::verifier {
namespace {

std::string print(const char* format, double x) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

}  // namespace

void Reporter::find(std::string_view check, std::vector<std::int64_t> ids,
                    const std::function<std::string()>& describe) {
  report_.ok = false;
  ++report_.finding_count;
  auto entry = counts_.begin();
  while (entry != counts_.end() && entry->first != check) ++entry;
  if (entry == counts_.end()) entry = counts_.insert(entry, {std::string(check), 0});
  if (entry->second++ < max_findings_) {
    report_.findings.push_back({std::string(check), describe(), std::move(ids)});
  }
}

std::uint64_t Reporter::count(std::string_view check) const {
  for (const auto& [name, n] : counts_) {
    if (name == check) return n;
  }
  return 0;
}

std::string grouped(std::uint64_t n) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

std::string full(double x) { return print("%.17g", x); }
std::string brief(double x) { return print("%.12g", x); }

std::string full(const Vec3& p) { return "(" + full(p.x) + ", " + full(p.y) + ", " + full(p.z) + ")"; }

std::string describe_tet(const TetMesh& mesh, std::size_t t) {
  std::string text = "tetrahedron " + std::to_string(t);
  for (int i = 0; i < 4; ++i) {
    const VertexId v = mesh.tets[t][i];
    text += (i == 0 ? " (vertex " : ", ") + std::to_string(v) + " at " + full(mesh.points[v]);
  }
  return text + ")";
}

}  // namespace unsliver::verifier
