#include "size_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "files.hpp"
#include "formula_error.hpp"
#include "samples.hpp"
#include "text.hpp"
#include "unsliver/error.hpp"
#include "unsliver/io.hpp"

namespace unsliver::cli {

const double kSizePerEdge = (std::sqrt(5.0) / 4) / ((3 + 2 * std::sqrt(3.0)) / 7);

namespace {

constexpr double kDiagonalPerDefaultSize = 40;
constexpr std::size_t kProbes = 2000;
/// A lower bound this small says nothing: it is what sizing functions give in place of 0.
constexpr double kNoSize = 1e-300;
constexpr double kTinyShare = 1e-9;
constexpr int kMostLooks = 20'000;

/// --size or --edge-length: `factor` times a number or a formula.
struct Typed {
  const char* option;
  const std::optional<std::string>& text;
  double factor;
};

std::vector<Typed> typed_sizes(const SizeRequest& request) {
  std::vector<Typed> given;
  for (const Typed& typed :
       {Typed{"--size", request.size, 1}, Typed{"--edge-length", request.edge_length, kSizePerEdge}})
    if (typed.text) given.push_back(typed);
  return given;
}

void check_positive(const std::string& option, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(ErrorCode::kBadOption,
              fmt::format("{} is {}: it must be a positive, finite length", option, value));
}

/// \throws Error kBadOption for "0,1".
void check_no_decimal_comma(const std::string& option, std::string text) {
  const std::string typed = text;
  std::replace(text.begin(), text.end(), ',', '.');
  if (parse_number(text))
    throw Error(ErrorCode::kBadOption, fmt::format("{} is \"{}\": write {}", option, typed, text));
}

/// The smallest of the constants asked for, as s.
std::optional<double> smallest_constant(const SizeRequest& request) {
  std::optional<double> smallest;
  for (const Typed& typed : typed_sizes(request))
    if (const auto number = parse_number(*typed.text)) {
      const double s = typed.factor * *number;
      smallest = smallest ? std::min(*smallest, s) : s;
    }
  return smallest;
}

bool varies(const SizeRequest& request) {
  if (request.size_mesh || !request.functions.empty()) return true;
  for (const Typed& typed : typed_sizes(request))
    if (!parse_number(*typed.text)) return true;
  return false;
}

/// Parsed as typed first, so that columns in error messages are those of the text the user sees.
SizingPtr formula(const Typed& typed, const Box3& bounds) {
  SizingPtr plain = of_formula(typed.option, *typed.text,
                               [&](const std::string& text) { return expression_size(text, bounds); });
  if (typed.factor == 1) return plain;
  return expression_size(fmt::format("{:.17g} * ({})", typed.factor, *typed.text), bounds);
}

SizingPtr background(const std::string& path) {
  check_readable(path);
  return background_size(io::read_sizing_mesh(path));
}

SizingPtr combined(std::vector<SizingPtr> sizes) {
  return sizes.size() == 1 ? sizes.front() : minimum_size(std::move(sizes));
}

/// Formulas, background meshes and functions, limited to the gradation where one is asked for.
SizingPtr varying(const SizeRequest& request, const Box3& bounds) {
  std::vector<SizingPtr> sizes = request.functions;
  for (const Typed& typed : typed_sizes(request))
    if (!parse_number(*typed.text)) sizes.push_back(formula(typed, bounds));
  if (request.size_mesh) sizes.push_back(background(*request.size_mesh));
  const SizingPtr all = combined(std::move(sizes));
  return request.gradation ? limit_gradation(all, *request.gradation, bounds) : all;
}

bool has_sizes(const DomainSource& source) { return source.inputs && !source.inputs->set.sizes.empty(); }

/// A constant size grows away from the surface, or from points that have no sizes of their own.
bool constant_grows(const SizeRequest& request, const DomainSource& source) {
  return request.gradation && (source.surface || (source.inputs && !has_sizes(source)));
}

double cap_of(const SizeRequest& request) {
  return request.size_max.value_or(std::numeric_limits<double>::infinity());
}

SizingPtr uniform(const SizeRequest& request, const DomainSource& source, double s) {
  if (!constant_grows(request, source)) return constant_size(s);
  if (source.surface) return graded_from_surface(*source.surface, s, *request.gradation, cap_of(request));
  return graded_from_points(source.inputs->set.points, {s}, *request.gradation, cap_of(request));
}

SizingPtr at_points(const SizeRequest& request, const PointSet& set) {
  return graded_from_points(set.points, set.sizes, request.gradation.value_or(kDefaultGradation),
                            cap_of(request));
}

/// Nothing is asked beyond what the input vertices bring about.
class NoDemand final : public Sizing {
 public:
  double at(const Vec3&) const override { return std::numeric_limits<double>::infinity(); }
  double lower_bound(const Box3&) const override { return std::numeric_limits<double>::infinity(); }
  double lipschitz() const override { return 0; }
  std::string describe() const override { return "none: as large as the input vertices allow"; }
};

/// One of the eight parts of a box.
Box3 octant(const Box3& box, int index) {
  const Vec3 center = box.center();
  Box3 part = box;
  for (int axis = 0; axis < 3; ++axis) (index >> axis & 1 ? part.lo : part.hi)[axis] = center[axis];
  return part;
}

/// A tiny box of the domain over which nothing but s > 0 is known: its centre. None if there is no such box,
/// or none was found in time. Depth first, for a zero of s is at the end of any branch that leads there.
std::optional<Vec3> vanishing_place(const Sizing& sizing, const Domain& domain) {
  const double tiny = kTinyShare * domain.bounds().diagonal();
  std::vector<Box3> boxes = {domain.bounds()};
  for (int looks = 0; looks < kMostLooks && !boxes.empty(); ++looks) {
    const Box3 box = boxes.back();
    boxes.pop_back();
    const bool harmless = sizing.lower_bound(box) > kNoSize;
    if (harmless || domain.side_of_ball(box.center(), 0.5 * box.diagonal()) > 0) continue;
    if (box.diagonal() < tiny) return box.center();
    for (int i = 0; i < 8; ++i) boxes.push_back(octant(box, i));
  }
  return std::nullopt;
}

/// A formula or a file may hold anything: looks at s all over the domain before anybody relies on it.
/// \throws Error kBadInput where s is not positive (naming a point), may be 0 between the points looked at,
/// or is infinite everywhere.
void probe(const Sizing& sizing, const Domain& domain) {
  bool finite = std::isfinite(sizing.at(domain.bounds().center()));
  for (const Vec3& p : domain_samples(domain, kProbes)) finite |= std::isfinite(sizing.at(p));
  if (!finite)
    throw Error(ErrorCode::kBadInput, "the size is infinite all over the domain: give a finite length");
  if (const auto place = vanishing_place(sizing, domain))
    throw Error(
        ErrorCode::kBadInput,
        fmt::format("the size reaches 0, or comes close, near {}: keep it above 0 all over the domain, a "
                    "formula with max(formula, smallest size)",
                    point_text(*place)));
}

/// \throws Error kBadOption for a gradation or a cap that changes nothing.
void check_effects(const SizeRequest& request, const DomainSource& source, bool has_constant) {
  const bool grows = has_sizes(source) || (has_constant && constant_grows(request, source));
  if (request.gradation && !grows && !varies(request))
    throw Error(ErrorCode::kBadOption,
                source.inputs ? "--size-gradation has no effect here: there is no size that could grow; give "
                                "--size, or points with sizes"
                              : "--size-gradation has no effect here: the size is constant and there is no "
                                "surface to grade from");
  if (request.size_max && !grows)
    throw Error(ErrorCode::kBadOption,
                "--size-max has no effect here: it caps the size that grows away from a surface or points (a "
                "constant size and --size-gradation, or points with sizes)");
}

}  // namespace

void check_size_request(const SizeRequest& request) {
  for (const Typed& typed : typed_sizes(request))
    if (const auto number = parse_number(*typed.text))
      check_positive(typed.option, *number);
    else
      check_no_decimal_comma(typed.option, *typed.text);
  if (request.gradation && !(*request.gradation > 0 && std::isfinite(*request.gradation)))
    throw Error(ErrorCode::kBadOption,
                fmt::format("--size-gradation is {}: it must be a positive, finite slope (length per length)",
                            *request.gradation));
  if (request.size_max) check_positive("--size-max", *request.size_max);
}

SizeSource make_sizing(const SizeRequest& request, const DomainSource& source) {
  const Box3 bounds = source.domain->bounds();
  SizeSource result;
  std::optional<double> s = smallest_constant(request);
  result.by_default = !s && !varies(request) && !has_sizes(source);
  if (result.by_default && !source.inputs) s = bounds.diagonal() / kDiagonalPerDefaultSize;
  check_effects(request, source, s.has_value());
  std::vector<SizingPtr> sizes;
  if (s) sizes.push_back(uniform(request, source, *s));
  if (has_sizes(source)) sizes.push_back(at_points(request, source.inputs->set));
  if (varies(request)) {
    sizes.push_back(varying(request, bounds));
    probe(*sizes.back(), *source.domain);
  }
  if (s && sizes.size() == 1 && !request.gradation) result.constant = s;
  result.sizing = sizes.empty() ? std::make_shared<NoDemand>() : combined(std::move(sizes));
  return result;
}

}  // namespace unsliver::cli
