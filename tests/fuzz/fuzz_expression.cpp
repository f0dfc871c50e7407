/// libFuzzer: any text either is refused with an Error or gives a formula whose bounds hold its values.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "geom/expression.hpp"
#include "unsliver/error.hpp"

namespace {

void check(const unsliver::geom::Expression& f, const unsliver::Box3& box) {
  const unsliver::geom::Interval range = f.over(box), tight = f.tight_over(box);
  for (const unsliver::Vec3& p : {box.lo, box.center(), box.hi}) {
    const double v = f.at(p);
    if (!range.contains(v) || !tight.contains(v)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto f = unsliver::geom::Expression::parse(std::string(data, data + size));
    check(f, {{-1, -2, 0}, {1, 0.5, 3}});
    check(f, {{0.25, 0.25, -0.5}, {0.375, 0.375, -0.375}});
    check(f, {{-1e300, 0, 1}, {1e300, 0, 1e30}});
  } catch (const unsliver::Error&) {
    // Refusing is a right answer.
  }
  return 0;
}
