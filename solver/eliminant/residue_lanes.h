// Residues modulo several primes at once in AVX2 registers of doubles. Only for files compiled for AVX2 and
// FMA.
#pragma once

#include <immintrin.h>

// Let 2^47 < p < 2^48 be a prime. A residue is an integer a in a double with |a| <= 0.61 p and this class
// modulo p; zero has only the representative 0. All operations round to nearest.
//
// Reduction of an integer t, |t| <= 10.5 p^2, given as t = h + l with doubles h, l: x = fl(fl(h + l) fl(1/p))
// has the relative error (1 + 2^-53)^3 - 1 < 3.01 2^-53, q is x rounded to an integer, so that
//   |t - q p| <= (1/2 + 3.01 2^-53 |t|/p) p.                                                            (*)
// As p < 2^48 this is < 0.535 p for |t| <= 0.3721 p^2 (one product of residues), < 0.61 p for three products,
// and < 1.48 p for 28 products. t - q p is computed as (h - q p) + l, in one fused operation and one
// addition; both are exact if h is an integer and |l| + 1.5 p < 2^53, because their results are integers
// below 2^53.
namespace exsect::lanes {

/// One residue for each of four primes.
using Lane = __m256d;

/// Four primes.
struct Primes {
  Lane p;
  Lane inverse;  // fl(1/p)
};

inline Lane nearest_integer(Lane x) {
  return _mm256_round_pd(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

/// a modulo p for an integer |a| < 2^52: |result| <= 0.501 p by (*), with h = a, l = 0.
inline Lane reduce(const Primes& f, Lane a) {
  return _mm256_fnmadd_pd(nearest_integer(_mm256_mul_pd(a, f.inverse)), f.p, a);
}

inline Lane add(const Primes& f, Lane a, Lane b) { return reduce(f, _mm256_add_pd(a, b)); }
inline Lane negate(Lane a) { return _mm256_xor_pd(a, _mm256_set1_pd(-0.0)); }

/// h = fl(ab) is an integer, l = ab - h is exact and below 2^43. |result| <= 0.535 p.
inline Lane multiply(const Primes& f, Lane a, Lane b) {
  const Lane h = _mm256_mul_pd(a, b);
  const Lane l = _mm256_fmsub_pd(a, b, h);
  const Lane q = nearest_integer(_mm256_mul_pd(h, f.inverse));
  return _mm256_add_pd(_mm256_fnmadd_pd(q, f.p, h), l);
}

/// a b + c modulo p: as multiply with |t| <= 0.3721 p^2 + 0.61 p and l + c in place of l. |result| <= 0.535
/// p.
inline Lane multiply_add(const Primes& f, Lane a, Lane b, Lane c) {
  const Lane h = _mm256_mul_pd(a, b);
  const Lane l = _mm256_add_pd(_mm256_fmsub_pd(a, b, h), c);
  const Lane q = nearest_integer(_mm256_mul_pd(_mm256_add_pd(h, c), f.inverse));
  return _mm256_add_pd(_mm256_fnmadd_pd(q, f.p, h), l);
}

/// A sum of at most 28 products of residues, as a double `high` between 2^101 and 2^102, hence a multiple of
/// 2^49, and what rounding it left, `low`: high - 1.5 2^101 + low is the sum. A product changes high to
/// fl(high + ab) (one fused operation): the change is a difference of multiples of 2^49 and exact, the rest
/// is an integer of modulus at most 2^48 and exact, and |low| <= 28 2^48 < 2^53. |high - 1.5 2^101| <= 28
/// (0.3721 2^96 + 2^48) < 2^100.
class LaneSum {
 public:
  LaneSum() : high_(offset()), low_(_mm256_setzero_pd()) {}
  /// The product a b.
  LaneSum(Lane a, Lane b)
      : high_(_mm256_fmadd_pd(a, b, offset())), low_(_mm256_fmadd_pd(a, b, _mm256_sub_pd(offset(), high_))) {}

  void add(Lane a, Lane b) {
    const Lane high = _mm256_fmadd_pd(a, b, high_);
    low_ = _mm256_add_pd(low_, _mm256_fmadd_pd(a, b, _mm256_sub_pd(high_, high)));
    high_ = high;
  }

  /// Of at most three products: |result| < 0.61 p. Here |l| <= 28 2^48, which leaves room for 1.5 p.
  Lane reduced_few(const Primes& f) const {
    const Lane h = _mm256_sub_pd(high_, offset());
    const Lane q = nearest_integer(_mm256_mul_pd(_mm256_add_pd(h, low_), f.inverse));
    return _mm256_add_pd(_mm256_fnmadd_pd(q, f.p, h), low_);
  }
  /// Of at most 28: reduced_few is below 1.48 p, and is reduced once more.
  Lane reduced(const Primes& f) const { return reduce(f, reduced_few(f)); }

 private:
  static Lane offset() { return _mm256_set1_pd(0x1.8p101); }

  Lane high_;
  Lane low_;
};

/// As FibreTable wants it.
class LaneArithmetic {
 public:
  using Residue = Lane;

  explicit LaneArithmetic(const Primes& primes) : primes_(primes) {}

  Lane add(Lane a, Lane b) const { return lanes::add(primes_, a, b); }
  Lane negate(Lane a) const { return lanes::negate(a); }
  /// At most 9.8 p < 2^52 for 16 residues.
  Lane add_unreduced(Lane a, Lane b) const { return _mm256_add_pd(a, b); }
  Lane reduced(Lane a) const { return lanes::reduce(primes_, a); }

 private:
  Primes primes_;
};

/// Residues at two points for each of four primes, as EliminantForms wants them: two independent chains of
/// operations hide their latency.
struct TwoLanes {
  Lane a;
  Lane b;
};

class TwoLaneArithmetic {
 public:
  using Residue = TwoLanes;
  class Sum {
   public:
    Sum() = default;
    Sum(const TwoLanes& f, const TwoLanes& g) : a_(f.a, g.a), b_(f.b, g.b) {}
    void add(const TwoLanes& f, const TwoLanes& g) {
      a_.add(f.a, g.a);
      b_.add(f.b, g.b);
    }

   private:
    friend class TwoLaneArithmetic;
    LaneSum a_;
    LaneSum b_;
  };

  explicit TwoLaneArithmetic(const Primes& primes) : primes_(primes) {}

  TwoLanes reduce(const Sum& sum) const { return {sum.a_.reduced(primes_), sum.b_.reduced(primes_)}; }
  TwoLanes reduce_few(const Sum& sum) const {
    return {sum.a_.reduced_few(primes_), sum.b_.reduced_few(primes_)};
  }
  TwoLanes add(const TwoLanes& f, const TwoLanes& g) const {
    return {lanes::add(primes_, f.a, g.a), lanes::add(primes_, f.b, g.b)};
  }
  TwoLanes negate(const TwoLanes& f) const { return {lanes::negate(f.a), lanes::negate(f.b)}; }
  TwoLanes multiply(const TwoLanes& f, const TwoLanes& g) const {
    return {lanes::multiply(primes_, f.a, g.a), lanes::multiply(primes_, f.b, g.b)};
  }

 private:
  Primes primes_;
};

}  // namespace exsect::lanes
