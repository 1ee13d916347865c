// The result of `exsect ray` as text and as JSON, form "ray/1".
#pragma once

#include <exsect/solver/surface_ray.h>

#include <string>
#include <vector>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// What the ray has in common with one of the surfaces.
struct SurfaceOnRay {
  std::string surface;  // its name
  RayIntersection common;
};

/// The ray origin + t direction, t >= 0, and the surfaces in the order of their file.
struct ShownRay {
  Point origin;
  Point direction;
  std::vector<SurfaceOnRay> surfaces;

  bool is_complete() const;
};

/// A hit, its surface, and the number of its point along the ray, from 1 on: equal for hits in one point.
struct HitOnRay {
  std::string surface;
  RayHit hit;
  int place;
};

/// All hits, ascending in t, those of one point in the order of the surfaces.
std::vector<HitOnRay> hits_in_order(const ShownRay& ray);

/// Deterministic, keys in the order of docs/formats.md.
Json ray_json(const ShownRay& ray);
std::string ray_summary(const ShownRay& ray, bool verbose);

}  // namespace exsect::cli
