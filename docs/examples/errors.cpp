#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <iostream>

int main() {
  try {
    exsect::parse_patches(R"({"exsect": "patches/1", "patches": [
      {"name": "x", "degree": [1, 1], "points": [[[0, 0, 0], [0, 1, "1/0"]], [[1, 0, 0], [1, 1, 1]]]}]})",
                          "model.json");
  } catch (const exsect::InputError& error) {
    std::cout << error.what() << '\n';
  }

  const auto pair = exsect::read_patches("examples/chapter9-first.json").patches;
  exsect::IntersectOptions options;
  options.max_seconds = 1e-9;
  const auto result = exsect::intersect(pair[0].patch, pair[1].patch, options);
  if (result.status == exsect::Status::incomplete) std::cout << result.incomplete.front().why << '\n';

  options.tolerance = 0;
  try {
    exsect::intersect(pair[0].patch, pair[1].patch, options);
  } catch (const std::invalid_argument& error) {
    std::cout << error.what() << '\n';
  }
}
