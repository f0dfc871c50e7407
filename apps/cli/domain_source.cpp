#include "domain_source.hpp"

#include <fmt/format.h>

#include "files.hpp"
#include "text.hpp"
#include "unsliver/error.hpp"
#include "unsliver/io.hpp"

namespace unsliver::cli {
namespace {

Box3 parse_box(const std::string& text, const std::string& option) {
  const auto n = parse_numbers(text, 6, option);
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

DomainSource from_file(const std::string& path) {
  check_readable(path);
  DomainSource source{"surface", path, nullptr, io::read_surface(path)};
  source.domain = make_surface(*source.surface);
  return source;
}

DomainSource from_ball(const std::string& text) {
  const auto n = parse_numbers(text, 4, "--ball");
  return {"ball", "ball " + text, make_ball({n[0], n[1], n[2]}, n[3]), std::nullopt};
}

}  // namespace

void check_domain_request(const DomainRequest& request) {
  const int count = int{request.surface_file.has_value()} + int{request.box.has_value()} +
                    int{request.ball.has_value()} + int{request.implicit.has_value()};
  if (count == 0)
    throw Error(ErrorCode::kBadOption, "nothing to mesh: give a surface file, --box, --ball or --implicit");
  if (count > 1)
    throw Error(ErrorCode::kBadOption,
                fmt::format("{} inputs: give one of a surface file, --box, --ball and --implicit", count));
  if (request.implicit && !request.bounds)
    throw Error(ErrorCode::kBadOption, "--implicit needs --bounds \"x0 y0 z0 x1 y1 z1\": the box to look in");
  if (request.bounds && !request.implicit)
    throw Error(ErrorCode::kBadOption, "--bounds has no effect without --implicit");
}

DomainSource make_domain(const DomainRequest& request) {
  if (request.surface_file) return from_file(*request.surface_file);
  if (request.ball) return from_ball(*request.ball);
  if (request.box)
    return {"box", "box " + *request.box, make_box(parse_box(*request.box, "--box")), std::nullopt};
  return {"implicit", *request.implicit + " <= 0",
          make_implicit(*request.implicit, parse_box(*request.bounds, "--bounds")), std::nullopt};
}

}  // namespace unsliver::cli
