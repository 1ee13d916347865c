#include "eliminant/vector_eliminant.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/modular.h>

#include <array>
#include <cstdint>
#include <stdexcept>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "eliminant/fibre_resultants.h"
#include "eliminant/turning_eliminant_lanes.h"

namespace exsect {

bool has_vector_eliminant() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

namespace {

/// Differences of successive primes below 2^48: enough for control points of 53 bits.
constexpr std::array<std::uint8_t, 176> prime_gaps = {
    59, 6,  24, 4,   54,  18, 24, 44, 10, 14, 60, 12, 40,  90, 54, 12, 2,  22,  18, 2,  58, 42,
    96, 32, 28, 74,  16,  30, 62, 12, 28, 2,  88, 48, 24,  60, 8,  18, 12, 48,  28, 24, 20, 76,
    2,  10, 90, 14,  10,  8,  22, 26, 40, 20, 10, 44, 24,  52, 32, 36, 12, 12,  42, 28, 42, 20,
    4,  2,  88, 36,  38,  28, 8,  34, 18, 18, 66, 8,  52,  26, 12, 16, 14, 36,  10, 24, 2,  10,
    18, 6,  50, 102, 12,  46, 26, 6,  4,  48, 12, 68, 112, 24, 26, 10, 36, 42,  18, 80, 24, 4,
    30, 12, 32, 12,  10,  8,  22, 20, 6,  42, 28, 18, 32,  54, 28, 38, 24, 6,   78, 24, 10, 36,
    42, 14, 4,  102, 8,   46, 54, 44, 22, 38, 76, 54, 20,  72, 6,  4,  20, 118, 2,  6,  48, 22,
    20, 90, 34, 84,  114, 8,  28, 6,  14, 16, 6,  62, 16,  6,  26, 22, 62, 48,  22, 6,  18, 26};

}  // namespace

std::uint64_t LanePrimes::next() {
  last_ = used_ < prime_gaps.size() ? last_ - prime_gaps[used_] : prime_below(last_);
  ++used_;
  return last_;
}

#ifdef __x86_64__

namespace {

/// Points beyond the degree of E plus 1 for the first primes, which check the degree.
constexpr std::size_t spare_points = 9;
static_assert(Ruled33::degree(3) + 1 + spare_points <= max_lane_points);
/// The nodes are consecutive and start here, far from zero: at small integers structured input often makes an
/// expression undefined for every prime.
constexpr std::uint64_t first_node = 0x2f61c3e8d9a75b4;

using LaneRow = std::array<std::uint64_t, 4>;

/// The integer of the class of a in [0,p) of modulus at most p/2, exactly.
double balanced(std::uint64_t a, std::uint64_t p) {
  return a <= p / 2 ? static_cast<double>(a) : -static_cast<double>(p - a);
}

double balanced(const Integer& a, std::uint64_t p) {
  const auto& z = a.backend().data();
  if (!mpz_fits_slong_p(z)) return balanced(mpz_fdiv_ui(z, p), p);
  const auto q = static_cast<std::int64_t>(p);
  const std::int64_t remainder = mpz_get_si(z) % q;
  return balanced(static_cast<std::uint64_t>(remainder < 0 ? remainder + q : remainder), p);
}

/// `lanes` has zeros beyond the degrees of the net.
template <class Lanes, class Net>
void set_net(Lanes& lanes, const Net& net, const LaneRow& primes) {
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j)
      for (std::size_t k = 0; k < net[i][j].size(); ++k)
        for (std::size_t lane = 0; lane < 4; ++lane)
          lanes[i][j][k][lane] = balanced(net[i][j][k], primes[lane]);
}

/// Coefficients of E modulo several primes.
template <class Kind, class Pair>
class LaneResidues {
 public:
  explicit LaneResidues(const Pair& pair) : pair_(pair), degree_(Kind::degree(pair.x.size() - 1)) {}

  /// Four more primes; false if E is undefined at some node modulo all four.
  bool add_primes(const LaneRow& primes) {
    const std::size_t points = degree_ + 1 + (residues_.primes.empty() ? spare_points : 0);
    LanePair<Kind> lanes = {};
    double first[4];
    for (std::size_t lane = 0; lane < 4; ++lane) {
      lanes.primes[lane] = static_cast<double>(primes[lane]);
      first[lane] = balanced(first_node % primes[lane], primes[lane]);
    }
    set_net(lanes.x, pair_.x, primes);
    set_net(lanes.y, pair_.y, primes);
    if constexpr (requires { lanes.factor; })
      for (std::size_t i = 0; i < pair_.factor.size(); ++i)
        for (std::size_t lane = 0; lane < 4; ++lane)
          lanes.factor[i][lane] = balanced(pair_.factor[i], primes[lane]);
    double coefficients[max_lane_points][4];
    bool defined[4];
    eliminant_in_lanes(lanes, first, points, coefficients, defined);
    bool any = false;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (!defined[lane]) continue;
      any = true;
      add_row(primes[lane], coefficients, lane, points);
    }
    return any;
  }

  const Integer& product() const { return product_; }
  ModularIntegers take() { return std::move(residues_); }

 private:
  void add_row(std::uint64_t p, const double (*coefficients)[4], std::size_t lane, std::size_t points) {
    std::vector<std::uint64_t> row;
    for (std::size_t i = 0; i < points; ++i) {
      const auto c = static_cast<std::int64_t>(coefficients[i][lane]);
      if (i > degree_ && c != 0)
        throw ProofFailure(whole_domain(), "the values of the turning eliminant exceed its degree");
      if (i <= degree_)
        row.push_back(c < 0 ? p - static_cast<std::uint64_t>(-c) : static_cast<std::uint64_t>(c));
    }
    residues_.primes.push_back(p);
    residues_.residues.push_back(std::move(row));
    product_ *= p;
  }

  const Pair& pair_;
  const std::size_t degree_;
  ModularIntegers residues_;
  Integer product_ = 1;
};

template <class Kind, class Pair>
std::optional<ModularIntegers> eliminant_modulo_primes(const Pair& pair, std::size_t bits) {
  if (!has_vector_eliminant()) return std::nullopt;
  LanePrimes primes;
  LaneResidues<Kind, Pair> residues(pair);
  while (msb(residues.product()) < bits + 2) {
    interruption_point();
    LaneRow row;
    for (auto& p : row) p = primes.next();
    if (!residues.add_primes(row)) return std::nullopt;
  }
  return residues.take();
}

}  // namespace

std::optional<ModularIntegers> vector_eliminant(const IntegerPair& pair, std::size_t bits) {
  return eliminant_modulo_primes<PolynomialKind>(pair, bits);
}

std::optional<ModularIntegers> vector_eliminant(const WeightedPair& pair, std::size_t bits) {
  return by_kind(pair, [&]<class Kind>(Kind) { return eliminant_modulo_primes<Kind>(pair, bits); });
}

std::optional<ModularIntegers> vector_eliminant(const StrippedPair& pair, std::size_t bits) {
  return by_kind(pair, [&]<class Kind>(Kind) { return eliminant_modulo_primes<Kind>(pair, bits); });
}

#else

std::optional<ModularIntegers> vector_eliminant(const IntegerPair&, std::size_t) { return std::nullopt; }
std::optional<ModularIntegers> vector_eliminant(const WeightedPair&, std::size_t) { return std::nullopt; }
std::optional<ModularIntegers> vector_eliminant(const StrippedPair&, std::size_t) { return std::nullopt; }

#endif

}  // namespace exsect
