// The polyline of an arc, with a proved bound of its distance. Internal to solver/.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "answer/chord_count.h"
#include "trace/bounded_vertex.h"

namespace exsect {

/// Vertices and chords while they are collected.
class ArcPolyline {
 public:
  /// (17.36), docs/method-equations.md: K such that chords over steps h, which add_chords() makes as short as
  /// K asks for on this length of an arc, are within K h^2 / 8 of it. `all` and `normal` bound the second
  /// derivative and its part across the arc, `least_speed` the first derivative from below.
  static double deviation(double all, double normal, double least_speed, double length, double tolerance) {
    const double across_step = std::min(length, step(normal, tolerance)) * kSlack;
    const double turn = all * across_step / (2 * least_speed) * kSlack;
    const double across = (normal + all * turn) * kSlack;
    return across_step * (kMostChords / 2) > length && turn < 0.5 && across < all ? across : all;
  }

  void add_vertex(const BoundedVertex& v) {
    vertices_.push_back(v.vertex);
    vertex_error_ = larger_bound(vertex_error_, v.error);
  }
  /// A chord keeps within the bound of what it stands for.
  void cover(double bound) { chord_error_ = larger_bound(chord_error_, bound); }

  /// The chords over such steps deviate by less than the tolerance, by the bound of add_chords.
  static double step(double second_derivative, double tolerance) {
    return std::sqrt(8 * 0.9 * tolerance / second_derivative);
  }

  /// Chords between the offsets a and b, whose vertices are added by others, within the tolerance if they are
  /// not too many. The position in space is twice differentiable along the arc, so a chord over a step h
  /// deviates by at most K h^2 / 8 from the arc over the same offsets, K a bound of the second derivative.
  template <class VertexAt>
  void add_chords(double second_derivative, double a, double b, double tolerance, const VertexAt& vertex_at) {
    const int n = cover_chords(second_derivative, std::fabs(b - a), tolerance);
    for (int i = 1; i < n; ++i) add_vertex(vertex_at(a + (b - a) * (static_cast<double>(i) / n)));
  }
  /// The same without vertices: the number of equal steps.
  int cover_chords(double second_derivative, double distance, double tolerance) {
    const double length = distance * kSlack;
    const int n = chord_count(std::ceil(length / step(second_derivative, tolerance)));
    const double each = length / n;
    cover(second_derivative * each * each / 8 * kSlack);
    return n;
  }

  std::size_t size() const { return vertices_.size(); }
  std::vector<PolylineVertex> take_vertices() { return std::move(vertices_); }
  /// Each vertex is within that of a point of the curve.
  double vertex_error() const { return vertex_error_; }
  /// The polyline's end offsets, joints and vertices stand for true points within the errors of vertices;
  /// twice, because the true end of an arc may be anywhere in its node's box.
  double bound() const { return (chord_error_ + 2 * vertex_error_) * kSlack; }

 private:
  std::vector<PolylineVertex> vertices_;
  double vertex_error_ = 0;
  double chord_error_ = 0;
};

}  // namespace exsect
